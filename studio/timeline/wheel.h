#pragma once

#include "studio/timeline/time_mapping.h"

class QWheelEvent;

namespace kumite::studio {

/// What a view over time shows after the wheel was turned above it: moved, or, with Ctrl, zoomed
/// about the pointer.
TimeMapping afterWheel(const TimeMapping& shown, const QWheelEvent& event);

}  // namespace kumite::studio
