#include "core/demo/posture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kumite::demo {
namespace {

constexpr double degrees(double value) {
    return value * std::numbers::pi / 180;
}

Control aside(Side side) {
    return side == Side::Left ? Control::LeftAside : Control::RightAside;
}
Control up(Side side) {
    return side == Side::Left ? Control::LeftUp : Control::RightUp;
}
Control ahead(Side side) {
    return side == Side::Left ? Control::LeftAhead : Control::RightAhead;
}
Control pivot(Side side) {
    return side == Side::Left ? Control::LeftPivot : Control::RightPivot;
}

Posture guardOf(const Temper& temper) {
    const Side lead = leadOf(temper);
    const Side rear = other(lead);
    Posture p{};
    of(p, Control::PelvisYaw) = -sign(lead) * degrees(30);
    of(p, Control::PelvisLean) = degrees(5);
    of(p, Control::SpineYaw) = sign(lead) * degrees(8);
    of(p, Control::SpineLean) = degrees(15);
    of(p, Control::HeadLean) = degrees(10);
    of(p, aside(lead)) = 0.10;
    of(p, up(lead)) = -0.05 + temper.guardHeight;
    of(p, ahead(lead)) = 0.42;
    of(p, aside(rear)) = 0.12;
    of(p, up(rear)) = -0.03 + temper.guardHeight;
    of(p, ahead(rear)) = 0.27;
    return p;
}

/// Turns the body behind a punch: the shoulder goes where the hand goes.
void turnInto(Posture& p, const Temper& temper, Side side, double share, Target target) {
    const bool lead = side == leadOf(temper);
    const double inward = -sign(side);
    const double pelvis = lead ? degrees(34) : degrees(14);
    const double spine = lead ? degrees(22) : degrees(28);
    of(p, Control::PelvisYaw) += share * (inward * pelvis - of(p, Control::PelvisYaw));
    of(p, Control::SpineYaw) += share * (inward * spine - of(p, Control::SpineYaw));
    of(p, Control::SpineLean) += share * degrees(target == Target::Trunk ? 14 : 5);
    if (target == Target::Trunk) of(p, Control::PelvisLean) += share * degrees(9);
    if (!lead) of(p, pivot(side)) += share * inward * degrees(35);  // the rear heel turns out
}

void leanForKick(Posture& p, const Temper& temper, const PlannedAction& action, Side side) {
    const bool lead = side == leadOf(temper);
    const double inward = -sign(side);
    const Side support = other(side);
    switch (action.style) {
        case KickStyle::Front:
            of(p, Control::PelvisYaw) = inward * degrees(lead ? 12 : 22);
            of(p, Control::PelvisLean) = degrees(-17);
            of(p, Control::SpineYaw) = -inward * degrees(12);
            of(p, Control::SpineLean) = degrees(14);
            of(p, pivot(support)) = -inward * degrees(12);
            break;
        case KickStyle::Round:
            of(p, Control::PelvisYaw) = inward * degrees(lead ? 62 : 70);
            of(p, Control::PelvisLean) = degrees(-12);
            of(p, Control::PelvisTilt) = inward * degrees(action.target == Target::Leg     ? -6
                                                          : action.target == Target::Trunk ? -18
                                                                                           : -30);
            of(p, Control::SpineYaw) = -inward * degrees(26);
            of(p, Control::SpineTilt) = inward * degrees(8);
            of(p, Control::SpineLean) = degrees(8);
            of(p, pivot(support)) = inward * degrees(48);
            break;
        case KickStyle::Knee:
            of(p, Control::PelvisYaw) = inward * degrees(18);
            of(p, Control::PelvisLean) = degrees(-14);
            of(p, Control::SpineLean) = degrees(20);
            break;
    }
    // The arms keep the balance: the kicking side's swings back, the other stays up.
    of(p, ahead(side)) = 0.16;
    of(p, up(side)) = -0.32;
    of(p, aside(side)) = 0.36;
}

}  // namespace

double minimumJerk(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s * s * s * (10 + s * (-15 + 6 * s));
}

PosturePlan::PosturePlan(const Script& script, const std::vector<Strike>& received,
                         std::uint64_t seed)
    : temper_(script.temper), seed_(seed), guard_(guardOf(script.temper)) {
    Random random(seed, 6);
    for (int c = 0; c < kControlCount; ++c) {
        const auto control = static_cast<Control>(c);
        add(control, -1.0, of(guard_, control));
    }
    for (const PlannedAction& action : script.actions) {
        addMiddle(action, random);
        addBoundary(action, random);
    }
    for (auto& keys : keys_) {
        std::stable_sort(keys.begin(), keys.end(),
                         [](const Key& a, const Key& b) { return a.time < b.time; });
    }
    for (const Strike& strike : received) {
        if (strike.outcome != Outcome::Lands || strike.feint) continue;
        const double strength = strike.effort * (strike.kick ? 1.2 : 1.0);
        knocks_.push_back({strike.hit, strength,
                           sign(strike.side) * (strike.style == KickStyle::Round ? 1.0 : 0.4),
                           strike.target == Target::Head});
    }
}

void PosturePlan::add(Control control, double time, double value) {
    keys_[static_cast<std::size_t>(control)].push_back({time, value});
}

void PosturePlan::addBoundary(const PlannedAction& ending, Random& random) {
    Posture p = guard_;
    const Technique& t = ending.technique;
    for (const Side side : {Side::Left, Side::Right}) {
        if (t.legOutAtEnd(side)) leanForKick(p, temper_, ending, side);
    }
    for (const Side side : {Side::Left, Side::Right}) {
        if (t.armOutAtEnd(side)) turnInto(p, temper_, side, ending.effort, ending.target);
    }
    if (t.jump == Jump::Up) of(p, Control::SpineLean) += degrees(6);
    // The hips lead, the shoulders follow, the head is last.
    constexpr std::array<double, 3> kLead = {-0.035, -0.015, 0.0};
    for (int c = 0; c < kControlCount; ++c) {
        const auto control = static_cast<Control>(c);
        const bool hand = control >= Control::LeftAside && control <= Control::RightAhead;
        const double spread = hand ? 0.022 : degrees(2.2);
        const std::size_t group = control <= Control::PelvisTilt  ? 0
                                  : control <= Control::SpineTilt ? 1
                                                                  : 2;
        const bool foot = control >= Control::LeftPivot;
        add(control, ending.end + kLead[group] + random.normal(0, 0.008),
            of(p, control) + (foot ? 0.0 : random.normal(0, spread)));
    }
}

void PosturePlan::addMiddle(const PlannedAction& action, Random& random) {
    const Technique& t = action.technique;
    const double middle = action.begin + 0.5 * action.duration();
    for (const Side side : {Side::Left, Side::Right}) {
        if (t.punchOf(side) == Punch::FwdBwd || t.punchOf(side) == Punch::BwdFwd) {
            Posture p = guard_;
            // Without the body's weight: a third of the turn, out of the shoulders.
            const bool quick = t.punchOf(side) == Punch::FwdBwd;
            if (quick) turnInto(p, temper_, side, 0.45 * action.effort, action.target);
            for (const Control c : {Control::PelvisYaw, Control::SpineYaw, Control::SpineLean}) {
                add(c, middle, of(p, c) + random.normal(0, degrees(2)));
            }
        }
        if (t.kickOf(side) == Kick::DownUp) {
            for (const Control c : {Control::PelvisYaw, Control::PelvisLean, Control::PelvisTilt,
                                    Control::SpineYaw, Control::SpineLean, Control::SpineTilt}) {
                add(c, middle, of(guard_, c) + random.normal(0, degrees(2)));
            }
        }
    }
    if (!t.isOthers()) return;
    if (action.manner == Manner::Feint) {
        const Side lead = leadOf(temper_);
        Posture p = guard_;
        turnInto(p, temper_, lead, 0.35, Target::Head);
        add(Control::PelvisYaw, middle, of(p, Control::PelvisYaw));
        add(Control::SpineYaw, middle, of(p, Control::SpineYaw));
    }
    if (isDefence(action.manner)) addDefence(action, random);
}

void PosturePlan::addDefence(const PlannedAction& action, Random& random) {
    const double from = action.begin + 0.36 * action.duration();
    const double to = action.begin + 0.64 * action.duration();
    Posture p = guard_;
    const double way = action.variation % 2 ? 1.0 : -1.0;
    switch (action.manner) {
        case Manner::Block:
            for (const Side side : {Side::Left, Side::Right}) {
                of(p, up(side)) = 0.09 + random.normal(0, 0.025);
                of(p, ahead(side)) = 0.23 + random.normal(0, 0.02);
                of(p, aside(side)) = 0.07 + random.normal(0, 0.015);
            }
            of(p, Control::SpineLean) += degrees(8);
            of(p, Control::SpineYaw) += way * degrees(8);
            of(p, Control::HeadLean) += degrees(9);
            break;
        case Manner::Slip:
            of(p, Control::PelvisTilt) -= way * degrees(8);
            of(p, Control::SpineTilt) -= way * degrees(22);
            of(p, Control::SpineYaw) -= way * degrees(12);
            of(p, Control::SpineLean) += degrees(12);
            break;
        case Manner::Duck:
            of(p, Control::PelvisLean) += degrees(20);
            of(p, Control::SpineLean) += degrees(26);
            of(p, Control::HeadLean) -= degrees(6);
            for (const Side side : {Side::Left, Side::Right})
                of(p, up(side)) += 0.06;
            break;
        case Manner::Retreat:
            of(p, Control::PelvisLean) -= degrees(8);
            of(p, Control::SpineLean) -= degrees(10);
            of(p, Control::HeadLean) -= degrees(4);
            break;
        default:
            break;
    }
    for (int c = 0; c <= static_cast<int>(Control::RightAhead); ++c) {
        const auto control = static_cast<Control>(c);
        const double value = of(p, control) + (c < 9 ? random.normal(0, degrees(1.5)) : 0.0);
        add(control, from, value);
        add(control, to, value);
    }
}

double PosturePlan::valueOf(Control control, double time) const {
    const auto& keys = keys_[static_cast<std::size_t>(control)];
    const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                        [](double t, const Key& key) { return t < key.time; });
    if (after == keys.begin()) return keys.front().value;
    if (after == keys.end()) return keys.back().value;
    const Key& from = *(after - 1);
    const double span = std::max(1e-6, after->time - from.time);
    return from.value + (after->value - from.value) * minimumJerk((time - from.time) / span);
}

Posture PosturePlan::at(double time) const {
    Posture p;
    for (int c = 0; c < kControlCount; ++c) {
        const auto control = static_cast<Control>(c);
        const bool hand = control >= Control::LeftAside && control <= Control::RightAhead;
        double sway = hand ? 0.018 : degrees(1.6);
        if (control >= Control::LeftPivot) sway = 0;
        of(p, control) = valueOf(control, time) + sway * smoothNoise(seed_, c, time, 2.2);
    }
    constexpr double kRise = 0.07;  // seconds to a knock's peak
    constexpr double kOver = 12;    // in these
    auto knock = std::lower_bound(knocks_.begin(), knocks_.end(), time - kOver * kRise,
                                  [](const Knock& k, double t) { return k.time < t; });
    for (; knock != knocks_.end() && knock->time < time; ++knock) {
        const double since = (time - knock->time) / kRise;
        const double response = knock->strength * since * since / 4 * std::exp(2 - since);
        if (knock->head) {
            of(p, Control::HeadLean) -= response * degrees(15);
            of(p, Control::HeadYaw) -= response * knock->sideways * degrees(14);
            of(p, Control::SpineLean) -= response * degrees(5);
        } else {
            of(p, Control::SpineLean) += response * degrees(8);
            of(p, Control::SpineYaw) -= response * knock->sideways * degrees(6);
        }
    }
    return p;
}

}  // namespace kumite::demo
