#pragma once

#include <QColor>

#include <vector>

namespace kumite::studio {

/// How an eye sees colours: as most do, or without the cones for long, middle or short waves.
enum class Vision { Usual, Protan, Deutan, Tritan };
inline constexpr Vision kVisions[] = {Vision::Usual, Vision::Protan, Vision::Deutan,
                                      Vision::Tritan};

/// A colour as it looks to such an eye (Machado, Oliveira and Fernandes 2009, severity 1).
QColor seenBy(const QColor& colour, Vision vision);
/// How far apart two colours look: the distance in CIE L*a*b* (ΔE, 1976); about 2 is just seen.
double colourDifference(const QColor& a, const QColor& b);
/// The same for the eye that tells them apart least.
double leastDifference(const QColor& a, const QColor& b);

/// From this difference on classes are told apart by colour alone, side by side and far apart.
inline constexpr double kToldApart = 10;

/// A pattern for each class of one aspect, so that any two differ by colour or by pattern to every
/// eye. The first ones of a kind are plain.
std::vector<Qt::BrushStyle> classPatterns(const std::vector<QColor>& colours);

}  // namespace kumite::studio
