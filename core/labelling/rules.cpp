#include "core/labelling/rules.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"

namespace kumite {
namespace {

const char* stanceText(Stance stance) {
    switch (stance) {
        case Stance::Left:
            return "stands left";
        case Stance::Right:
            return "stands right";
        case Stance::Flight:
            break;
    }
    return "in the air";
}

double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b) {
    const Eigen::Vector3d along = b - a;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - a - share * along).norm();
}

/// The body's line at a moment on the take's clock, between frames.
std::array<Eigen::Vector3d, 3> bodyAt(const FighterView& fighter, double seconds) {
    const double frame = std::clamp((seconds - fighter.offset) * fighter.rate, 0.0,
                                    static_cast<double>(fighter.frameCount - 1));
    const int before = static_cast<int>(frame);
    const int after = std::min(before + 1, fighter.frameCount - 1);
    const double share = frame - before;
    auto body = fighter.body(before);
    if (share < 1e-9) return body;
    const auto next = fighter.body(after);
    for (std::size_t i = 0; i < body.size(); ++i)
        body[i] = (1 - share) * body[i] + share * next[i];
    return body;
}

struct Span {
    double begin, end;
};
Span spanOf(const FighterView& fighter, const Action& action) {
    return {fighter.offset + action.begin / fighter.rate,
            fighter.offset + action.end / fighter.rate};
}

}  // namespace

char stanceLetter(Stance stance) {
    return stance == Stance::Left ? 'L' : stance == Stance::Right ? 'R' : 'F';
}

std::vector<Stance> stances(const FootContacts& contacts) {
    const std::size_t frames = std::max(contacts.left.size(), contacts.right.size());
    const auto stands = [](const std::vector<std::uint8_t>& foot, std::size_t frame) {
        return frame < foot.size() && foot[frame] != 0;
    };
    std::vector<Stance> result(frames, Stance::Flight);
    std::vector<std::size_t> both;
    std::vector<std::size_t> single;
    for (std::size_t i = 0; i < frames; ++i) {
        const bool left = stands(contacts.left, i);
        const bool right = stands(contacts.right, i);
        if (left && right) {
            both.push_back(i);
        } else if (left || right) {
            result[i] = left ? Stance::Left : Stance::Right;
            single.push_back(i);
        }
    }
    for (const std::size_t frame : both) {
        const auto later = std::lower_bound(single.begin(), single.end(), frame);
        if (single.empty()) {
            result[frame] = Stance::Left;
        } else if (later == single.end()) {
            result[frame] = result[single.back()];
        } else if (later == single.begin() || *later - frame <= frame - *(later - 1)) {
            result[frame] = result[*later];
        } else {
            result[frame] = result[*(later - 1)];
        }
    }
    return result;
}

std::string Move::symbol() const {
    return {stanceLetter(begin), '-', stanceLetter(end)};
}

Move moveOf(const Action& action, std::span<const Stance> stances) {
    return {stances[static_cast<std::size_t>(action.begin)],
            stances[static_cast<std::size_t>(action.end)]};
}

std::optional<int> correspondingAction(const FighterView& player, int action,
                                       const FighterView& opponent) {
    const Span own = spanOf(player, player.actions[static_cast<std::size_t>(action)]);
    std::optional<int> best;
    // Less than a microsecond more is no longer overlap: frames of equal rate must tie exactly.
    double longest = 1e-6;
    const auto first = std::partition_point(
        opponent.actions.begin(), opponent.actions.end(),
        [&](const Action& other) { return spanOf(opponent, other).end <= own.begin; });
    for (auto other = first; other != opponent.actions.end(); ++other) {
        const Span theirs = spanOf(opponent, *other);
        if (theirs.begin >= own.end) break;
        const double overlap = std::min(own.end, theirs.end) - std::max(own.begin, theirs.begin);
        if (overlap <= longest + (best ? 1e-6 : 0.0)) continue;
        longest = overlap;
        best = static_cast<int>(other - opponent.actions.begin());
    }
    return best;
}

double closingSpeed(const FighterView& player, const FighterView& opponent, int opponentAction,
                    Role limb) {
    const Action& attack = opponent.actions[static_cast<std::size_t>(opponentAction)];
    const int begin = std::max(0, attack.begin - 1);
    const int end = std::min(opponent.frameCount - 1, attack.end + 1);
    std::vector<double> distance;
    for (int frame = begin; frame <= end; ++frame) {
        const auto fist = opponent.limbEnd(frame, limb);
        if (!fist) return 0;
        const auto body = bodyAt(player, opponent.offset + frame / opponent.rate);
        distance.push_back(std::min(distanceToSegment(*fist, body[0], body[1]),
                                    distanceToSegment(*fist, body[1], body[2])));
    }
    double fastest = 0;
    for (std::size_t i = 1; i + 1 < distance.size(); ++i)
        fastest = std::max(fastest, 0.5 * (distance[i - 1] - distance[i + 1]) * opponent.rate);
    return fastest;
}

Reaction reactionOf(const Vocabulary& vocabulary, const Aspect& react, const FighterView& player,
                    int action, const FighterView& opponent, std::span<const Label> labels,
                    const RuleSettings& settings) {
    Reaction reaction;
    reaction.opponentAction = correspondingAction(player, action, opponent);
    if (!reaction.opponentAction) return reaction;
    const Label& attack = labels[static_cast<std::size_t>(*reaction.opponentAction)];
    int rank = static_cast<int>(react.qualifiers.size());
    for (int i = 0; i < vocabulary.size(); ++i) {
        const Aspect& aspect = vocabulary[i];
        const int qualifier = attack[static_cast<std::size_t>(i)];
        if (aspect.strike.empty() || !aspect.limb) continue;
        reaction.open = reaction.open || qualifier == kUnknown;
        if (qualifier == kUnknown) continue;
        if (!aspect.qualifiers[static_cast<std::size_t>(qualifier)].attack) continue;
        const double closing =
            closingSpeed(player, opponent, *reaction.opponentAction, *aspect.limb);
        const bool counts = closing > settings.closingSpeed;
        const int own = counts ? react.find(aspect.strike).value_or(rank) : rank;
        // An attack that does not count is remembered as the reason only while none does.
        const bool better = own < rank || (reaction.qualifier.empty() && !counts &&
                                           (!reaction.aspect || closing > reaction.closing));
        if (!better) continue;
        rank = own;
        reaction.qualifier = counts ? aspect.strike : std::string();
        reaction.aspect = i;
        reaction.attack = qualifier;
        reaction.closing = closing;
    }
    return reaction;
}

std::string reactionText(const Vocabulary& vocabulary, const Reaction& reaction) {
    if (!reaction.opponentAction) return "no action of the opponent at that time";
    if (!reaction.aspect) {
        return reaction.open ? "the opponent's action is not labelled yet"
                             : "the opponent's action is no attack";
    }
    const Aspect& aspect = vocabulary[*reaction.aspect];
    const std::string what = lowerCase(aspect.name) + " " +
                             aspect.qualifiers[static_cast<std::size_t>(reaction.attack)].name;
    return fmt::format("opponent's {}, closing {}{} m/s", what,
                       reaction.qualifier.empty() ? "only " : "", fixed(reaction.closing, 1));
}

std::string moveText(const Move& move) {
    return fmt::format("{} at the beginning, {} at the end", stanceText(move.begin),
                       stanceText(move.end));
}

}  // namespace kumite
