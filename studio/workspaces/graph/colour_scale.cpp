#include "studio/workspaces/graph/colour_scale.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"

namespace kumite::studio {

double ColourScale::position(double value) const {
    if (!std::isfinite(value)) return 0;
    switch (kind) {
        case Kind::Linear:
            return std::clamp(value / top, 0.0, 1.0);
        case Kind::Logarithmic:
            if (value <= floor) return 0;
            return std::clamp(std::log(value / floor) / std::log(top / floor), 0.0, 1.0);
        case Kind::Difference:
            return std::clamp(value / top, -1.0, 1.0);
    }
    return 0;
}

QColor ColourScale::colourAt(double position) const {
    if (kind == Kind::Difference) {
        return mixed(nothing, position < 0 ? below : full, std::abs(position));
    }
    if (position < 0.6) return mixed(nothing, half, position / 0.6);
    return mixed(half, full, (position - 0.6) / 0.4);
}

std::vector<ColourScale::Tick> ColourScale::ticks() const {
    const auto number = [](double value) {
        QString text = QLocale().toString(value, 'g', 2);
        return text.replace(QLatin1Char('-'), QChar(0x2212));
    };
    std::vector<Tick> ticks;
    switch (kind) {
        case Kind::Linear:
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
                ticks.push_back({share, number(share * top)});
            break;
        case Kind::Logarithmic:
            ticks.push_back({0.0, QStringLiteral("≤ ") + number(floor)});
            for (double value = 10 * floor; value < top * 1.001; value *= 10)
                ticks.push_back({position(value), number(value)});
            break;
        case Kind::Difference:
            for (const double share : {-1.0, 0.0, 1.0}) {
                const QString sign = share > 0 ? QStringLiteral("+") : QString();
                ticks.push_back({share, sign + number(share * top)});
            }
            break;
    }
    return ticks;
}

double scaleTop(double largest) {
    for (const double top : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
        if (largest <= top) return top;
    }
    return 1;
}

ColourScale probabilityScale(const Colours& colours, int player, bool logarithmic, double top) {
    ColourScale scale;
    scale.top = top;
    scale.kind = logarithmic ? ColourScale::Kind::Logarithmic : ColourScale::Kind::Linear;
    scale.nothing = mixed(colours.ground, colours.line, colours.dark ? 0.25 : 0.35);
    scale.half = colours.fighters[player];
    scale.full = mixed(colours.fighters[player], colours.dark ? Qt::white : Qt::black,
                       colours.dark ? 0.75 : 0.55);
    return scale;
}

ColourScale differenceScale(const Colours& colours, double top) {
    ColourScale scale;
    scale.kind = ColourScale::Kind::Difference;
    scale.top = top;
    scale.nothing = mixed(colours.ground, colours.line, colours.dark ? 0.25 : 0.35);
    scale.full = QColor(colours.dark ? "#2fc99a" : "#00785a");
    scale.below = QColor(colours.dark ? "#e08cbc" : "#a8487c");
    return scale;
}

QColor inkOn(const QColor& colour) {
    const double light = 0.299 * colour.redF() + 0.587 * colour.greenF() + 0.114 * colour.blueF();
    return light > 0.52 ? QColor("#17181a") : QColor("#f2f2f2");
}

}  // namespace kumite::studio
