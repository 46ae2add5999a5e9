#pragma once

#include <QPixmap>
#include <QWidget>

#include <optional>
#include <vector>

#include "studio/app/session.h"
#include "studio/timeline/loop_handles.h"
#include "studio/timeline/snapping.h"
#include "studio/timeline/time_mapping.h"
#include "studio/timeline/track.h"

namespace kumite::studio {

class LaneSource;
class NoteField;

/// What a menu is asked for on.
enum class TimelineSpot { Boundary, Action, Ruler };

/// The timeline: a ruler and one row per fighter with curves, minima, boundaries and actions.
/// Boundaries are selected by a click, dragged, removed and restored by a double-click or by the
/// button that appears above them; actions are selected by a click, looped by a double-click. The
/// right button does what a click does and asks for a menu. What stands still while the playhead
/// runs is painted once, into a picture that is kept.
class TimelineView : public QWidget {
    Q_OBJECT

public:
    explicit TimelineView(Session& session, QWidget* parent = nullptr);

    TimeMapping mapping() const;
    /// Where a boundary's line is, at the middle of its curve.
    QPointF pointOf(const BoundaryRef& boundary) const;
    /// The button that removes or restores a boundary while the pointer is near it.
    QRectF handleOf(const BoundaryRef& boundary) const;
    QRectF ruler() const;
    /// Where an action's block is; empty where it is not visible.
    QRectF blockOf(const ActionRef& action) const;

    /// Whether curves are still being made.
    bool isPreparing() const { return preparing_.isRunning(); }
    /// Lanes under the actions; null: none. Lives longer than it is shown.
    void setLanes(LaneSource* lanes);

    const TimelineOptions& options() const { return options_; }
    void setOptions(const TimelineOptions& options);
    /// Opens the field for the current action's note.
    void editNote();

    QSize sizeHint() const override;

Q_SIGNALS:
    /// Of what is selected now, at a point of the screen.
    void menuWanted(kumite::studio::TimelineSpot spot, const QPoint& at);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum class Gesture { None, Scrub, Pan, Press, Drag, Loop, Lanes };
    struct Dragged {
        BoundaryRef boundary;
        int frame = 0;  ///< where it would stand
        std::vector<SnapTarget> targets;
        std::optional<SnapKind> snap;  ///< what it is drawn to
    };

    void layOut();
    int speedRows() const;
    void refresh();
    void prepareCurves();
    void invalidate();
    void paintStill(QPainter& painter);
    void paintMoving(QPainter& painter);

    int playerAt(double y) const;
    std::optional<BoundaryRef> boundaryAt(const QPointF& position) const;
    std::optional<BoundaryRef> handleAt(const QPointF& position) const;
    const BoundaryMark* markOf(const BoundaryRef& boundary) const;
    bool choose(const QPointF& position);
    void scrubTo(double x);
    bool startDrag();
    void dragTo(double x, bool free);
    void endDrag(bool commit);
    std::vector<SnapTarget> snapTargets(int player) const;
    std::optional<ActionRef> blockAt(const QPointF& position) const;
    /// The action under a position on the strip or on the lanes, and the lane (-1: the strip).
    struct LaneHit {
        ActionRef action;
        int lane = -1;
    };
    std::optional<LaneHit> laneHitAt(const QPointF& position) const;
    bool openNote(const QPointF& position);
    bool pressLanes(const QMouseEvent& event);
    void dragLanes(const QPointF& position);
    bool event(QEvent* event) override;
    void hover(const QPointF& position);
    void hoverAgain();
    QString describe(int player, double seconds) const;

    Session& session_;
    std::vector<Track> tracks_;
    QPixmap still_;
    bool stillValid_ = false;
    Gesture gesture_ = Gesture::None;
    QPointF pressed_;
    QPointF last_;
    std::optional<QPointF> pointer_;
    std::optional<BoundaryRef> hovered_;
    std::optional<Dragged> dragged_;
    LoopEnd loopEnd_ = LoopEnd::In;
    TimelineOptions options_;
    JobRunner preparing_;
    NoteField* note_;
    LaneSource* lanes_ = nullptr;
    std::optional<ActionRef> laneDragged_;  ///< the action that the pointer was dragged over last
};

}  // namespace kumite::studio
