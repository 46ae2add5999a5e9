#pragma once

#include <QColor>
#include <QPalette>

#include <optional>

namespace kumite::studio {

/// Which colours the user asked for. System: whatever the platform's palette is.
enum class ThemeChoice { System, Light, Dark };

/// The colours that the studio paints with.
struct Colours {
    bool dark = false;
    QColor ground;  ///< behind content: 3D view, tracks
    QColor panel;   ///< panels, menus, fields
    QColor line;    ///< separators, grids, axes
    QColor text;
    QColor secondText;  ///< units, captions, hints
    QColor accent;      ///< focus and playhead
    QColor fighters[2];
    QColor fighterText[2];  ///< the fighters' colours where they are read as text or thin lines
};

/// The colours that go with a palette: dark ones for a dark window colour.
const Colours& coloursFor(const QPalette& palette);
const Colours& colours(bool dark);

/// Whether the desktop asks for dark windows. Until it has said so (nothing), the platform's
/// palette at the start decides. Counts from the next `applyTheme`.
void setSystemDark(std::optional<bool> dark);

/// Gives the whole application the palette and the style sheet of a theme. Views learn of it by
/// QEvent::PaletteChange.
void applyTheme(ThemeChoice choice);

/// `a` mixed with `b`; share 0 gives a, 1 gives b.
QColor mixed(const QColor& a, const QColor& b, double share);
QColor withAlpha(QColor colour, double alpha);

}  // namespace kumite::studio
