#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/labelling/label.h"
#include "core/motion/contacts.h"
#include "core/segmentation/segmentation.h"

namespace kumite {

/// Thresholds of the rules (method A5).
struct RuleSettings {
    ContactSettings contacts;
    double closingSpeed = 1.0;  ///< m/s, at which a fist or foot must close on the body to count

    bool operator==(const RuleSettings&) const = default;
};

// ---- move --------------------------------------------------------------------------------------

enum class Stance { Left, Right, Flight };
char stanceLetter(Stance stance);

/// The stance at each frame: double stance becomes the single stance of the take that is nearer in
/// time, also across a flight (ties: the later; none anywhere: left). A side without contacts (no
/// leg) never stands.
std::vector<Stance> stances(const FootContacts& contacts);

/// Stances at an action's first and last boundary frame, so that symbols chain.
struct Move {
    Stance begin = Stance::Left;
    Stance end = Stance::Left;

    std::string symbol() const;  ///< "L-R"
    bool operator==(const Move&) const = default;
};
Move moveOf(const Action& action, std::span<const Stance> stances);

// ---- react -------------------------------------------------------------------------------------

/// What the react rule sees of a fighter.
struct FighterView {
    std::span<const Action> actions;
    double rate = 0;    ///< Hz
    double offset = 0;  ///< seconds on the take's clock of frame 0
    int frameCount = 0;
    /// The striking end of a limb and the trunk's and head's line (middle of the hips, neck, head)
    /// in the bout's space, metres.
    std::function<std::optional<Eigen::Vector3d>(int frame, Role limb)> limbEnd;
    std::function<std::array<Eigen::Vector3d, 3>(int frame)> body;
};

/// Why an action has its react qualifier.
struct Reaction {
    std::string qualifier;  ///< react's qualifier id, e.g. "kick"; empty: nothing to react to
    std::optional<int> opponentAction;  ///< the corresponding action; nothing: none overlaps
    std::optional<int> aspect;          ///< the attack seen in it
    int attack = kUnknown;              ///< its qualifier
    double closing = 0;                 ///< m/s, greatest speed at which it closes on the body
    bool open = false;                  ///< whether a strike of that action is not labelled yet

    bool operator==(const Reaction&) const = default;
};

/// Index of the opponent's action that overlaps longest in time (ties: the earlier); nothing if
/// none overlaps.
std::optional<int> correspondingAction(const FighterView& player, int action,
                                       const FighterView& opponent);

/// The greatest speed, m/s, at which the opponent's limb comes nearer to the player's trunk or head
/// during the opponent's action; 0 where it never does.
double closingSpeed(const FighterView& player, const FighterView& opponent, int opponentAction,
                    Role limb);

/// The react rule. `labels`: of the opponent's actions. Of several attacks at once, the one whose
/// strike stands first among react's qualifiers wins (kick before punch).
Reaction reactionOf(const Vocabulary& vocabulary, const Aspect& react, const FighterView& player,
                    int action, const FighterView& opponent, std::span<const Label> labels,
                    const RuleSettings& settings);

/// "opponent's right kick down and up, closing 4.1 m/s"
std::string reactionText(const Vocabulary& vocabulary, const Reaction& reaction);
/// "stands left at the beginning, right at the end"
std::string moveText(const Move& move);

}  // namespace kumite
