#pragma once

#include <array>
#include <string>
#include <vector>

namespace kumite::demo {

enum class Side { Left, Right };

inline Side other(Side side) {
    return side == Side::Left ? Side::Right : Side::Left;
}

/// 1 for the left, which is +x in a body's frame, −1 for the right.
inline double sign(Side side) {
    return side == Side::Left ? 1.0 : -1.0;
}

/// Qualifiers of the learnt aspects (method A3), spelt by `name`.
enum class Punch { Others, Fwd, Bwd, BwdFwd, FwdBwd };
enum class Kick { Others, Up, Down, DownUp };
enum class Jump { Others, Up, Down };

const char* name(Punch value);
const char* name(Kick value);
const char* name(Jump value);

/// What a fighter does in one action, as far as it does not depend on the opponent or the
/// footwork: five of the label's seven aspects.
struct Technique {
    std::array<Punch, 2> punch = {Punch::Others, Punch::Others};  ///< left, right
    std::array<Kick, 2> kick = {Kick::Others, Kick::Others};
    Jump jump = Jump::Others;

    bool operator==(const Technique&) const = default;

    Punch punchOf(Side side) const { return punch[static_cast<std::size_t>(side)]; }
    Kick kickOf(Side side) const { return kick[static_cast<std::size_t>(side)]; }

    /// The arm or leg is stretched out at the end (a hit is there), or begins that way.
    bool armOutAtEnd(Side side) const;
    bool armOutAtBegin(Side side) const;
    bool legOutAtEnd(Side side) const;
    bool legOutAtBegin(Side side) const;
    bool anyOutAtEnd() const;

    bool punches() const;  ///< fwd, bwdfwd or fwdbwd of either hand
    bool kicks() const;    ///< up or downup of either foot
    bool isOthers() const { return *this == Technique{}; }

    /// As labels are spelt: "left_punch:bwd+right_punch:fwd"; nothing but others: "others".
    std::string label() const;
};

/// Everything that a fighter may do, others first.
const std::vector<Technique>& techniques();
/// Index in `techniques()`.
int indexOf(const Technique& technique);
/// Whether `next` may follow: what is out must come back, who is in the air must land.
bool mayFollow(const Technique& own, const Technique& next);

/// How an action of others is spent.
enum class Manner { Guard, StepIn, StepOut, Circle, Hop, Feint, Block, Slip, Duck, Retreat };

const char* name(Manner manner);
inline constexpr int kMannerCount = 10;
inline bool isDefence(Manner manner) {
    return manner >= Manner::Block;
}

/// What a kick looks like.
enum class KickStyle { Front, Round, Knee };
enum class Target { Head, Trunk, Leg };

const char* name(KickStyle style);
const char* name(Target target);

}  // namespace kumite::demo
