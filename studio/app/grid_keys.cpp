#include "studio/app/grid_keys.h"

#include <QKeyEvent>

#include <algorithm>

namespace kumite::studio {

std::optional<GridStep> gridStep(const QKeyEvent& key) {
    const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeypadModifier;
    if (held & ~Qt::ShiftModifier) return std::nullopt;
    const int leap = held ? 10 : 1;
    switch (key.key()) {
        case Qt::Key_Left:
            return GridStep{0, -leap};
        case Qt::Key_Right:
            return GridStep{0, leap};
        case Qt::Key_Up:
            return GridStep{-leap, 0};
        case Qt::Key_Down:
            return GridStep{leap, 0};
        default:
            return std::nullopt;
    }
}

bool claimsGridKey(QEvent* event, std::initializer_list<int> others) {
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool other = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier &&
                       std::find(others.begin(), others.end(), key.key()) != others.end();
    if (!other && !gridStep(key)) return false;
    event->accept();
    return true;
}

}  // namespace kumite::studio
