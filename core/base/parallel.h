#pragma once

#include <functional>

#include "core/base/frame_range.h"

namespace kumite {

/// Calls `work` for consecutive blocks that together cover `range`, on as many threads as the
/// machine has cores. The blocks do not depend on the number of threads, and `work` must write
/// only what belongs to its block, so that results never depend on timing. The first exception
/// (by block order) is rethrown here.
void forBlocks(FrameRange range, int blockSize, const std::function<void(FrameRange)>& work);

}  // namespace kumite
