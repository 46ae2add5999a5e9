#pragma once

#include <QObject>

#include <array>
#include <memory>

#include "core/editing/pose_handles.h"
#include "core/motion/motion_library.h"
#include "studio/view3d/pose.h"
#include "studio/view3d/stage_handles.h"

namespace kumite::studio {

class HitSession;
class KeySession;
class StageView;

/// Shows keys and motion in the 3D view in the take's place while the Keyframe workspace is shown,
/// and leads what a hand draws at the
/// figure's handles to the chosen key, or at the target to the hit tool.
class KeyStage : public QObject {
    Q_OBJECT

public:
    KeyStage(KeySession& keys, HitSession& hit, StageView& stage, QObject* parent);

private:
    void begin();
    void show();
    bool isShown() const;
    std::vector<Eigen::Vector3f> jointsOf(const Pose& pose) const;
    void showNeighbours();
    /// Target, what is reached, and the opponent.
    void showTarget(StageHandles& shown, FigurePose& opponent);

    KeySession& keys_;
    HitSession& hit_;
    StageView& stage_;
    std::shared_ptr<const MotionLibrary> library_;  ///< whose figure is shown; null: none is
    std::vector<Handle> handles_;                   ///< those that the view has, in its order
    std::vector<Role> aims_;                        ///< the view's handles behind the target
    std::vector<StageGhost> ghosts_;                ///< those that the view shows
    bool framed_ = false;
};

}  // namespace kumite::studio
