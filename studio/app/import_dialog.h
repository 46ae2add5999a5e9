#pragma once

#include <QDialog>
#include <QStringList>

#include "core/project/import.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace kumite::studio {

/// How one or two recordings become a take: which file is whose, and what to believe about rate,
/// frames, units and placement where the files say nothing or the wrong thing.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// `project`: name of the open project that the take may be added to; empty: none is open.
    ImportDialog(const QStringList& files, const QString& project, QWidget* parent);

    /// What was asked for; complete once the dialog was accepted.
    TakeRequest request() const { return request_; }
    bool addsToProject() const;

protected:
    void accept() override;

private:
    QWidget* fileRow(QLineEdit* field, int player);
    QLineEdit* number(const QString& accessibleName, const QString& hint);
    void swapFiles();
    bool read(TakeRequest& request, QString& problem) const;

    QLineEdit* files_[2];
    QLineEdit* name_;
    QLineEdit* rate_;
    QLineEdit* frames_;
    QComboBox* units_;
    QComboBox* up_;
    QLineEdit* offset_;
    QLineEdit* x_;
    QLineEdit* z_;
    QLineEdit* yaw_;
    QCheckBox* add_;
    QLabel* problem_;
    TakeRequest request_;
};

}  // namespace kumite::studio
