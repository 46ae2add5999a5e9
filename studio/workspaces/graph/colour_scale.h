#pragma once

#include <QColor>
#include <QString>

#include <vector>

namespace kumite::studio {

struct Colours;

/// How a number becomes a colour: probabilities from 0 to 1 in shades of a fighter's colour, linear
/// or logarithmic, or differences from -1 to 1 between two colours with nothing in the middle.
struct ColourScale {
    enum class Kind { Linear, Logarithmic, Difference };

    Kind kind = Kind::Linear;
    double top = 1;       ///< what gets the full colour, above 0
    double floor = 1e-3;  ///< Logarithmic: what is not told from nothing, below top
    QColor nothing;
    QColor half;  ///< in the middle of a scale of one side
    QColor full;
    QColor below;  ///< Difference: the full colour of -top

    /// Where a value lies: 0 … 1, of differences -1 … 1. Values beyond the ends count as the ends.
    double position(double value) const;
    QColor colourAt(double position) const;
    QColor colourOf(double value) const { return colourAt(position(value)); }

    struct Tick {
        double position = 0;
        QString text;
    };
    /// What to write beside a legend, from low to high.
    std::vector<Tick> ticks() const;
};

/// The scale of a fighter's probabilities up to `top` on the ground of a theme.
ColourScale probabilityScale(const Colours& colours, int player, bool logarithmic, double top = 1);
/// The end of a scale that values up to `largest` use well: 1, 2 or 5 times a power of ten, at most
/// 1.
double scaleTop(double largest);
/// The scale of differences; told apart without red and green.
ColourScale differenceScale(const Colours& colours, double top);

/// Black or white-ish, whichever reads better on a colour.
QColor inkOn(const QColor& colour);

}  // namespace kumite::studio
