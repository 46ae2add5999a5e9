#pragma once

#include <QObject>

#include <memory>
#include <optional>

#include "core/motion/motion_library.h"

namespace kumite::studio {

class SequenceSession;
class StageView;

/// Shows the sequence, or the action of the browser, in the 3D view in the take's place while the
/// Sequence workspace is shown.
class SequenceStage : public QObject {
    Q_OBJECT

public:
    SequenceStage(SequenceSession& sequence, StageView& stage, QObject* parent);

private:
    void begin();
    void show();

    SequenceSession& sequence_;
    StageView& stage_;
    std::shared_ptr<const MotionLibrary> library_;  ///< whose figure is shown; null: none is
    bool framed_ = false;
    std::optional<bool> followed_;  ///< whether the camera followed the take before
};

}  // namespace kumite::studio
