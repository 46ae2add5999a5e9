#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/synthesis/choice.h"

namespace kumite {

/// Who decides (paper A, section 6). Automatic: the model, for both. Avatar: one fighter does what
/// keys and pointer ask for. Passive: one replays captured attacks, the other answers and may not
/// attack.
enum class BoutMode { Automatic, Avatar, Passive };
std::string_view modeName(BoutMode mode);  ///< "auto", "avatar", "passive"
std::optional<BoutMode> modeFromName(std::string_view name);

/// What a bout is started with. The same library and settings give the same bout, bit for bit.
struct BoutSettings {
    BoutMode mode = BoutMode::Automatic;
    std::uint64_t seed = 1;
    double temperature = 1;  ///< 0: always the likeliest; above 1: flatter
    ChoiceScore score = ChoiceScore::Evidence;
    /// Metres: how far a sample's first pose may be from the one shown, see Joining;
    /// 0: equation 12 alone chooses among a label's samples.
    double joinSpread = 0.14;
    int avatar = 0;           ///< player who is steered
    bool reactFirst = true;   ///< an avatar under attack may answer before it serves the command
    int attacker = 0;         ///< player who replays
    std::vector<int> attack;  ///< of B: what it replays, over and over
    bool coupling = true;     ///< time-warps, so that interaction moments meet
    bool footLocking = true;
    bool separation = true;  ///< bodies are kept out of each other

    bool operator==(const BoutSettings&) const = default;
};

/// What somebody wants from a moment on. Players 0 and 1; metres on the bout's floor.
struct BoutCommand {
    enum class Kind {
        Act,      ///< the avatar shall show `words` (see commandedNodes); stays until served
        Release,  ///< forgets what the avatar was asked for
        Target,   ///< where the avatar shall be half a second after its next action begins
        NoTarget,
        Choose,  ///< `player`'s next action shall have the label `words`
        Weigh,   ///< labels of `player` that hold `words` are `number` times as likely; 0: ban
        Seed,    ///< further draws are those of another seed
        Temperature
    };
    Kind kind = Kind::Act;
    int frame = 0;  ///< of the bout, from which on it counts
    int player = 0;
    std::string words;
    double number = 0;
    std::uint64_t seed = 0;
    Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< x and z

    bool operator==(const BoutCommand&) const = default;
};

/// A script of timed commands (schema: core/synthesis/README.md), in order of time; `rate` turns
/// seconds into frames. Throws InputError that names the place.
std::vector<BoutCommand> parseScript(std::string_view text, const std::string& file, double rate);
/// The same commands as such a script.
std::string scriptText(const std::vector<BoutCommand>& commands, double rate);

}  // namespace kumite
