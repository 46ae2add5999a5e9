#pragma once

#include <QImage>
#include <QPoint>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "studio/view3d/bones.h"
#include "studio/view3d/camera_controller.h"
#include "studio/view3d/camera_hand.h"
#include "studio/view3d/measuring.h"
#include "studio/view3d/overlays.h"
#include "studio/view3d/pose.h"
#include "studio/view3d/stage_handles.h"

namespace kumite::studio {

class Session;
struct StageMarks;

/// The 3D view: both fighters of the take at the moment that the session shows, on the floor.
/// Left drag turns, middle or Shift+drag moves, the wheel zooms about the pointer, a click on a
/// fighter makes it the active one; with the measuring tool a click takes a joint. A click with the
/// right button asks for a menu.
class StageView : public QWidget {
    Q_OBJECT

public:
    explicit StageView(Session& session, QWidget* parent = nullptr);
    ~StageView() override;

    /// Shows the whole area that the take covers.
    void frameAll();
    /// Shows both fighters as they are from one moment to another (seconds on the take's clock);
    /// turns to the side where one would hide the other.
    void frameFighters(double begin, double end);
    /// The same, but only where one does hide the other.
    void showBoth(double begin, double end);
    /// Shows the active fighter as it stands now.
    void frameActiveFighter();
    void lookFromFront();
    void lookFromSide();
    void lookFromTop();
    /// From behind a fighter, toward its opponent.
    void lookOverShoulder(int player);
    /// The camera moves along with the fighters.
    void setFollowing(bool following);
    bool isFollowing() const { return following_; }

    const Overlays& overlays() const { return overlays_; }
    void setOverlays(const Overlays& overlays);

    /// Leaves the fighters as they stand now as ghosts; of too many the oldest goes.
    void addGhost();
    void clearGhosts();
    int ghostCount() const { return static_cast<int>(ghostTimes_.size()); }

    void setMeasuring(bool on);
    bool isMeasuring() const;
    /// The measured distance now, metres; nothing until two joints were chosen.
    std::optional<double> measuredDistance() const;
    const Measuring& measuring() const;
    /// Points to the next (+1) or previous (-1) joint of the active fighter, named joints first;
    /// begins to measure if it did not.
    void stepJoint(int direction);
    /// What a click on the joint that is pointed to would do.
    void takeJoint();
    /// What is measured now, in words: joint and speed, distance; empty where there is nothing.
    QString measuredText() const;
    /// How to measure; shown while the tool is on.
    void setMeasuringHint(const QString& hint);

    /// Where a joint is drawn, in the view's pixels; nothing where there is no such joint or it
    /// lies behind the camera.
    std::optional<QPointF> jointPosition(const JointRef& joint) const;

    /// Others in place of the take's fighters, until their owner ends it or another begins: what
    /// their bones are (none: no such figure), then poses.
    void beginLive(const QObject* owner, std::array<std::vector<Bone>, 2> bones);
    void showLive(std::array<FigurePose, 2> poses);
    /// Nothing, if another has begun meanwhile.
    void endLive(const QObject* owner);
    bool isLive() const { return live_ != nullptr; }
    bool isLiveFor(const QObject* owner) const { return live_ == owner; }

    /// Tells where on the floor the pointer is, and by `floorClicked` where a click was beside the
    /// fighters.
    void setPointingAtFloor(bool on);
    /// A mark on the floor, x and z in metres; none: nothing. `faint`: not yet chosen.
    void setFloorMark(const std::optional<Eigen::Vector2d>& place, bool faint);

    /// What of the live figures can be dragged and turned; nothing: an empty value.
    void setHandles(StageHandles handles);
    /// The live figures at other moments, beside themselves.
    void setLiveGhosts(const std::vector<StageGhost>& ghosts);
    /// Where a handle is drawn, in the view's pixels.
    std::optional<QPointF> handlePosition(int handle) const;
    /// Where a point of a ring is drawn.
    std::optional<QPointF> ringPosition(int ring, double angle) const;

    /// What the view shows, in device pixels, without its buttons.
    QImage picture();

    /// Puts a widget (the view's buttons) into the upper right corner.
    void setTools(QWidget* tools);

    /// How fast a drag turns and the wheel zooms; 1 as usual.
    void setMouseSpeed(double speed) { hand_.setSpeed(speed); }

Q_SIGNALS:
    /// Overlays, ghosts, follow or the measuring tool changed.
    void switchesChanged();
    /// x and z, metres; nothing: beside the floor, or the pointer left.
    void floorHovered(const std::optional<Eigen::Vector2d>& place);
    void floorClicked(const Eigen::Vector2d& place);
    /// A press on a handle, then where it is dragged to (metres), then the release.
    void handlePressed(int handle, Qt::KeyboardModifiers modifiers);
    void handleDragged(int handle, const Eigen::Vector3d& place);
    void handleReleased(int handle);
    /// How far a ring was turned since it was pressed, radians; then its release.
    void ringTurned(int ring, double angle);
    void ringReleased(int ring);
    /// Esc, while a handle or a ring was dragged.
    void dragCancelled();
    /// On a fighter, which is the active one now, or on nothing, at a point of the screen.
    void menuWanted(std::optional<int> player, const QPoint& at);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    /// What room each fighter takes.
    using Places = std::array<Box, 2>;

    Places placesBetween(double begin, double end) const;
    /// False where the fighters do not hide each other.
    bool turnAside(const Places& places);
    void takeChanged();
    void bodiesChanged();
    void showPose();
    void showGhosts();
    void showColours();
    void showLabels();
    QString aroundAction() const;
    void markHandles(StageMarks& marks) const;
    void showCaption();
    void tellMeasured();
    void pointToOtherFighter();
    void applyCamera();
    void follow();
    void placeOverlays();
    void lookFrom(double yaw, double pitch);
    std::optional<int> fighterAt(const QPointF& position) const;
    std::optional<Eigen::Vector2d> floorAt(const QPointF& position) const;
    std::optional<Eigen::Vector3d> middle() const;
    std::optional<int> handleAt(const QPointF& position) const;
    std::optional<QPointF> placeInView(const Eigen::Vector3d& point) const;
    /// The ring at a point of the picture and where on it.
    std::optional<std::pair<int, double>> ringAt(const QPointF& position) const;
    bool beginDrag(const QMouseEvent& event);
    void dragTo(const QPointF& position);
    /// A point of the picture in the plane through `through` that faces the camera.
    Eigen::Vector3d facingPoint(const QPointF& position, const Eigen::Vector3d& through) const;
    void hoverAt(const QPointF& position);
    std::optional<JointRef> jointUnder(const QPointF& position) const;
    QString jointText(const JointRef& joint, bool withSpeed) const;
    std::optional<Eigen::Vector3d> jointPlace(const JointRef& joint) const;
    std::array<const FighterAnalysis*, 2> fighters() const;
    Viewport viewport() const;

    struct Scene;
    Session& session_;
    std::unique_ptr<Scene> scene_;
    Overlays overlays_;
    std::vector<double> ghostTimes_;  ///< seconds on the take's clock
    bool following_ = false;
    const QObject* live_ = nullptr;  ///< whose figures are shown instead of the take's
    bool pointsAtFloor_ = false;
    std::optional<Eigen::Vector3d> followed_;  ///< what the camera followed last
    QWidget* tools_ = nullptr;
    CameraHand hand_;
    QString measuringHint_;
    QString around_;   ///< "before the action"; empty: within it, or none is looped
    QString caption_;  ///< whole, where the view is too narrow for it
    QString told_;     ///< of what is measured
};

}  // namespace kumite::studio
