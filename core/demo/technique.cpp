#include "core/demo/technique.h"

#include <algorithm>

namespace kumite::demo {
namespace {

constexpr std::array<Side, 2> kSides = {Side::Left, Side::Right};

Technique punching(Side side, Punch punch) {
    Technique t;
    t.punch[static_cast<std::size_t>(side)] = punch;
    return t;
}

Technique kicking(Side side, Kick kick) {
    Technique t;
    t.kick[static_cast<std::size_t>(side)] = kick;
    return t;
}

Technique both(const Technique& a, const Technique& b) {
    Technique t = a;
    for (std::size_t i = 0; i < 2; ++i) {
        if (b.punch[i] != Punch::Others) t.punch[i] = b.punch[i];
        if (b.kick[i] != Kick::Others) t.kick[i] = b.kick[i];
    }
    if (b.jump != Jump::Others) t.jump = b.jump;
    return t;
}

Technique jumping(Jump jump) {
    Technique t;
    t.jump = jump;
    return t;
}

std::vector<Technique> makeTechniques() {
    std::vector<Technique> all = {Technique{}};
    for (const Side side : kSides) {
        for (const Punch punch : {Punch::Fwd, Punch::Bwd, Punch::BwdFwd, Punch::FwdBwd}) {
            all.push_back(punching(side, punch));
        }
        for (const Kick kick : {Kick::Up, Kick::Down, Kick::DownUp}) {
            all.push_back(kicking(side, kick));
        }
        // One hand back, the other forward; a punch into a kick of the other side; a kick that
        // lands in a punch of the other side.
        all.push_back(both(punching(side, Punch::Bwd), punching(other(side), Punch::Fwd)));
        all.push_back(both(punching(side, Punch::Bwd), kicking(other(side), Kick::Up)));
        all.push_back(both(kicking(side, Kick::Down), punching(other(side), Punch::Fwd)));
        all.push_back(both(jumping(Jump::Up), kicking(side, Kick::Up)));
        all.push_back(both(jumping(Jump::Down), kicking(side, Kick::Down)));
    }
    all.push_back(jumping(Jump::Up));
    all.push_back(jumping(Jump::Down));
    return all;
}

}  // namespace

const char* name(Punch value) {
    constexpr std::array names = {"others", "fwd", "bwd", "bwdfwd", "fwdbwd"};
    return names[static_cast<std::size_t>(value)];
}

const char* name(Kick value) {
    constexpr std::array names = {"others", "up", "down", "downup"};
    return names[static_cast<std::size_t>(value)];
}

const char* name(Jump value) {
    constexpr std::array names = {"others", "up", "down"};
    return names[static_cast<std::size_t>(value)];
}

const char* name(Manner manner) {
    constexpr std::array names = {"guard", "step_in", "step_out", "circle", "hop",
                                  "feint", "block",   "slip",     "duck",   "retreat"};
    return names[static_cast<std::size_t>(manner)];
}

const char* name(KickStyle style) {
    constexpr std::array names = {"front", "round", "knee"};
    return names[static_cast<std::size_t>(style)];
}

const char* name(Target target) {
    constexpr std::array names = {"head", "trunk", "leg"};
    return names[static_cast<std::size_t>(target)];
}

bool Technique::armOutAtEnd(Side side) const {
    return punchOf(side) == Punch::Fwd || punchOf(side) == Punch::BwdFwd;
}
bool Technique::armOutAtBegin(Side side) const {
    return punchOf(side) == Punch::Bwd || punchOf(side) == Punch::BwdFwd;
}
bool Technique::legOutAtEnd(Side side) const {
    return kickOf(side) == Kick::Up || kickOf(side) == Kick::DownUp;
}
bool Technique::legOutAtBegin(Side side) const {
    return kickOf(side) == Kick::Down || kickOf(side) == Kick::DownUp;
}

bool Technique::anyOutAtEnd() const {
    return jump == Jump::Up || std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
               return armOutAtEnd(side) || legOutAtEnd(side);
           });
}

bool Technique::punches() const {
    return std::any_of(punch.begin(), punch.end(),
                       [](Punch p) { return p != Punch::Others && p != Punch::Bwd; });
}

bool Technique::kicks() const {
    return legOutAtEnd(Side::Left) || legOutAtEnd(Side::Right);
}

std::string Technique::label() const {
    std::string text;
    const auto add = [&](const char* aspect, const char* qualifier) {
        if (std::string_view(qualifier) == "others") return;
        if (!text.empty()) text += '+';
        text += aspect;
        text += ':';
        text += qualifier;
    };
    add("left_punch", name(punch[0]));
    add("right_punch", name(punch[1]));
    add("left_kick", name(kick[0]));
    add("right_kick", name(kick[1]));
    add("jump", name(jump));
    return text.empty() ? "others" : text;
}

const std::vector<Technique>& techniques() {
    static const std::vector<Technique> all = makeTechniques();
    return all;
}

int indexOf(const Technique& technique) {
    const auto& all = techniques();
    return static_cast<int>(std::find(all.begin(), all.end(), technique) - all.begin());
}

bool mayFollow(const Technique& own, const Technique& next) {
    const bool inTheAir = own.jump == Jump::Up;
    if (inTheAir != (next.jump == Jump::Down)) return false;
    return std::all_of(kSides.begin(), kSides.end(), [&](Side side) {
        return own.armOutAtEnd(side) == next.armOutAtBegin(side) &&
               own.legOutAtEnd(side) == next.legOutAtBegin(side);
    });
}

}  // namespace kumite::demo
