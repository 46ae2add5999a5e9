#pragma once

#include <vector>

class QPagedPaintDevice;

namespace kumite::studio {

struct KeyGroup;

/// Paints the sheet of keys in columns, on as many pages as it takes: for paper and PDF, black on
/// white whatever the theme. False where the device cannot be painted on.
bool paintKeysSheet(const std::vector<KeyGroup>& groups, QPagedPaintDevice& device);

}  // namespace kumite::studio
