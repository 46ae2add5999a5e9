#pragma once

#include <QDialog>

#include <array>
#include <memory>

#include "core/project/project.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QWidget;

namespace kumite::studio {

class CommandTable;
class Session;

/// How the active fighter's recording is read: when it starts, where it stands, its floor and
/// which joint is what; and the body model of the project. Stays open beside the window; every
/// change shows at once in all views and is one step of the history.
class FighterProperties : public QDialog {
    Q_OBJECT

public:
    FighterProperties(Session& session, const CommandTable& commands, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeFields();
    QWidget* makeJoints();
    QDoubleSpinBox* addNumber(const QString& name, const QString& tip);
    FighterAddress address() const;
    /// The fighter that is shown; null where there is none.
    const Fighter* fighter() const;
    void refresh();
    void showFighters();
    void showRecording(const Fighter& shown);
    void showNumbers(const Fighter& shown);
    void showBodyModel();
    void showJoints(const Fighter& shown);
    void applyPlacement();
    void applyFloor();
    void applyRole(Role role, int index);
    void applyBodyModel(int index);

    Session& session_;
    QComboBox* who_;
    QLabel* recording_;
    QWidget* content_;
    QDoubleSpinBox* offset_ = nullptr;
    QDoubleSpinBox* x_ = nullptr;
    QDoubleSpinBox* z_ = nullptr;
    QDoubleSpinBox* turn_ = nullptr;
    QCheckBox* floorFound_ = nullptr;
    QDoubleSpinBox* floor_ = nullptr;
    QComboBox* bodyModel_ = nullptr;
    QLabel* jointsNote_ = nullptr;
    std::array<QComboBox*, kRoleCount> joints_{};
    std::shared_ptr<const Skeleton> listed_;  ///< whose joints the fields list
    bool filling_ = false;
};

}  // namespace kumite::studio
