#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QMenu;
class QSpinBox;
class QToolButton;

namespace kumite::studio {

class StageView;

/// The buttons in the corner of the 3D view: camera, what is shown, measuring. Their entries are
/// the commands of the window.
class StageTools : public QWidget {
    Q_OBJECT

public:
    explicit StageTools(StageView& stage);

    void setCameraActions(const QList<QAction*>& actions);
    /// Followed by the length of the trails.
    void setOverlayActions(const QList<QAction*>& actions);
    void setMeasureAction(QAction* action);

protected:
    void changeEvent(QEvent* event) override;

private:
    QToolButton* addButton(const QString& icon, const QString& name, const QString& tip);
    QWidget* trailFields(QWidget* parent);
    void refreshIcons();

    StageView& stage_;
    QList<QToolButton*> buttons_;
    QMenu* camera_;
    QMenu* overlays_;
    QToolButton* measure_;
};

}  // namespace kumite::studio
