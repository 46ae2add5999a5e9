#pragma once

#include <QDialog>
#include <QStringList>
#include <QTimer>

#include <memory>

#include "studio/app/import/import_look.h"
#include "studio/jobs/job_runner.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace kumite::studio {

class ImportPreview;
class RoleTable;

/// How one or two recordings become a take: which file is whose, and what to believe about rate,
/// frames, units, roles and placement. Files are read beside the window; the preview shows what
/// the answers make of them. Everything here `kumite new` can say, too.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// `project`: name of the open project that the take may be added to; empty: none is open.
    ImportDialog(const QStringList& files, const QString& project, QWidget* parent);

    /// What was asked for, and the recordings that were read; complete once it was accepted.
    TakeRequest request() const { return request_; }
    const Recordings& recordings() const { return recordings_; }
    bool addsToProject() const;
    /// Whether it still reads or looks.
    bool isBusy() const;

protected:
    void accept() override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// What is asked about each fighter. Empty fields: as found.
    struct Answers {
        QLineEdit* file;
        QLineEdit* asf;
        QComboBox* root;
        QComboBox* units;
        QComboBox* up;
        QLineEdit* offset;
        QLineEdit* x;
        QLineEdit* z;
        QLineEdit* yaw;
        QLineEdit* floor;
    };

    void layOut(const QString& project);
    QWidget* makeFileRows();
    QWidget* makeQuestions(const QString& project);
    void addRow(QGridLayout* grid, const QString& name, QWidget* first, QWidget* second);
    QLineEdit* makeField(const QString& name, const QString& hint, const QString& tip);
    QComboBox* makeChoice(const QString& name, const QString& tip);
    void makeAnswers(int player);
    void chooseFile(QLineEdit* field, const QString& filter);
    void setFiles(const QStringList& files);
    void swapFighters();

    void readFiles();
    void look();
    void showLook(std::shared_ptr<const ImportLook> look);
    void showFound(const ImportLook& look);
    void showProblem(const QString& problem);
    void offerRoots();
    bool ask(TakeRequest& request, QString& problem) const;
    bool askFighter(int player, FighterRequest& fighter, QString& problem) const;

    Answers answers_[2];
    QLineEdit* name_;
    QLineEdit* rate_;
    QLabel* rateFound_;
    QLineEdit* frames_;
    QLabel* framesFound_;
    QCheckBox* add_;
    QTabWidget* tabs_;
    ImportPreview* preview_;
    QPushButton* play_;
    RoleTable* roles_;
    QLabel* findings_;
    QPushButton* open_;
    std::vector<QWidget*> asfRow_;
    std::vector<QWidget*> rootRow_;

    Recordings recordings_;
    TakeRequest request_;
    std::shared_ptr<const ImportLook> look_;
    JobRunner reading_;
    JobRunner looking_;
    QTimer soon_;
    bool looksOld_ = true;  ///< an answer changed since the last look
};

}  // namespace kumite::studio
