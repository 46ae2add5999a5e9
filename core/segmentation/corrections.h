#pragma once

#include <optional>
#include <string>

namespace kumite {

/// What a user decided about one boundary, kept apart from detection (method A2).
///
/// Remove: the minimum at `frame` is spurious.
/// Add: there is a boundary at `frame`.
/// Move: the minimum at `frame` is a boundary that stands at `to`.
/// Keep: the minimum at `frame` was looked at and is a boundary, whatever the threshold says.
///
/// Remove, Move and Keep refer to a minimum by nearness, within 0.1 s, so that a correction
/// survives a change of cutoff or threshold.
struct Correction {
    enum class Kind { Remove, Add, Move, Keep };

    Kind kind = Kind::Remove;
    int frame = 0;
    int to = 0;  ///< Move only
    /// Add only: made while another boundary stood within 0.1 s, so it is never taken for that one.
    bool beside = false;
    /// Add only: taken away again; kept so that it can be restored.
    bool removed = false;

    bool operator==(const Correction&) const = default;
};

/// The correction in words: "remove 120", "add 64", "move 88 to 91",
/// "keep 33".
std::string correctionText(const Correction& correction);

/// Where a correction leaves a boundary: of a move its target, of an addition or an acceptance its
/// frame. Nothing for what removes one.
std::optional<int> boundaryOf(const Correction& correction);

/// How far a minimum may wander and still be the one that a correction means, seconds.
inline constexpr double kCorrectionReach = 0.1;

}  // namespace kumite
