#pragma once

#include <QPoint>
#include <QWidget>

#include <memory>

namespace kumite::studio {

class Session;

/// The 3D view: both fighters of the take at the moment that the session shows, on the floor.
/// Left drag turns, middle or Shift+drag moves, the wheel zooms about the pointer, a click on a
/// fighter makes it the active one.
class StageView : public QWidget {
    Q_OBJECT

public:
    explicit StageView(Session& session, QWidget* parent = nullptr);
    ~StageView() override;

    /// Shows the whole area that the take covers.
    void frameAll();
    /// Shows the active fighter as it stands now.
    void frameActiveFighter();
    void lookFromFront();
    void lookFromSide();
    void lookFromTop();
    /// How fast a drag turns and the wheel zooms; 1 as usual.
    void setMouseSpeed(double speed) { mouseSpeed_ = speed; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void takeChanged();
    void bodiesChanged();
    void showPose();
    void showColours();
    void applyCamera();
    void lookFrom(double yaw, double pitch);
    void activateFighterAt(const QPointF& position);

    struct Scene;
    Session& session_;
    std::unique_ptr<Scene> scene_;
    QPointF lastPointer_;
    QPointF pressed_;
    bool dragged_ = false;
    double mouseSpeed_ = 1;
};

}  // namespace kumite::studio
