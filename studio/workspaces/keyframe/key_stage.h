#pragma once

#include <QObject>

#include <array>
#include <memory>

#include "core/editing/pose_handles.h"
#include "core/motion/motion_library.h"

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

    KeySession& keys_;
    HitSession& hit_;
    StageView& stage_;
    std::shared_ptr<const MotionLibrary> library_;  ///< whose figure is shown; null: none is
    std::vector<Handle> handles_;                   ///< those that the view has, in its order
    bool framed_ = false;
};

}  // namespace kumite::studio
