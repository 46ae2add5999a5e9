#pragma once

#include <initializer_list>
#include <optional>

class QEvent;
class QKeyEvent;

namespace kumite::studio {

/// A step over rows and columns.
struct GridStep {
    int rows = 0;
    int columns = 0;
};

/// Where an arrow key leads on a grid of cells: one on, ten with Shift; nothing for other keys and
/// other modifiers.
std::optional<GridStep> gridStep(const QKeyEvent& key);

/// For `event` of a grid: accepts that an arrow, or one of `others` without modifiers, is the
/// grid's while it has the focus and no command's. False for all other events.
bool claimsGridKey(QEvent* event, std::initializer_list<int> others = {});

}  // namespace kumite::studio
