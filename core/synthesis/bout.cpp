#include "core/synthesis/bout.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/synthesis/draw.h"
#include "core/synthesis/moments.h"

namespace kumite {
namespace {

constexpr std::uint64_t kStartStream = 2;  ///< players draw from streams 0 and 1
constexpr int kLookAhead = 10;             ///< frames planned, the one to show with them
/// Frames after which a body has to be out of the other's way.
constexpr std::size_t kForesight = 8;
constexpr std::size_t kLimbForesight = 4;  ///< and a hand or a foot

/// Nodes of a player whose label holds what a spelled label says.
std::vector<int> nodesHolding(const BoutLibrary& library, int player, const std::string& words) {
    const Vocabulary& vocabulary = library.vocabulary();
    const Label wanted = parseLabel(vocabulary, words);
    std::vector<int> nodes;
    for (int n = 0; n < library.graph->nodeCount(player); ++n) {
        const Label& label = library.graph->node(player, n).label;
        bool holds = true;
        for (int a = 0; a < vocabulary.size(); ++a) {
            const auto slot = static_cast<std::size_t>(a);
            const bool asked = wanted[slot] != kUnknown && vocabulary[a].fallback != wanted[slot];
            holds = holds && (!asked || label[slot] == wanted[slot]);
        }
        if (holds) nodes.push_back(n);
    }
    return nodes;
}

}  // namespace

Bout::Bout(std::shared_ptr<const BoutLibrary> library, const BoutSettings& settings)
    : library_(std::move(library)), settings_(settings) {
    for (const int player : {0, 1}) {
        const bool replays = settings_.mode == BoutMode::Passive && settings_.attacker == player;
        if (replays || library_->fighter(player).model.sampleCount() > 0) continue;
        throw Error(fmt::format(
            "Player {} has no labelled action that follows another labelled one: label more of it.",
            player + 1));
    }
    if (settings_.mode == BoutMode::Passive && settings_.attack.empty()) {
        throw Error("The captured attack holds no action.");
    }
    for (const int player : {0, 1}) {
        const LibraryFighter& fighter = library_->fighter(player);
        if (!fighter.rig) {
            throw Error(fmt::format("No take of two shows player {}.", player + 1));
        }
        FootLockSettings lock;
        lock.floor = fighter.footRest;
        of(player).lock.emplace(fighter.rig, library_->rate, lock);
    }
    SeparationSettings separation;
    separation.floor = {library_->fighter(0).footRest, library_->fighter(1).footRest};
    separation_ = Separation({library_->fighter(0).rig, library_->fighter(1).rig}, library_->rate,
                             separation);
    start();
}

// ---- start -------------------------------------------------------------------------------------

/// Where the transition that the bout starts from stands in the scene: its mid-point at the origin,
/// player 1 to the left of player 2 as one looks along z.
static GroundTransform startOf(const GroundFrame& ground, int mover) {
    const double facing = mover == 0 ? 0.5 * std::numbers::pi : -0.5 * std::numbers::pi;
    return between(ground, GroundFrame{Eigen::Vector2d::Zero(), facing});
}

void Bout::start() {
    const CoupledGraph& graph = *library_->graph;
    if (settings_.mode == BoutMode::Passive) {
        // The attack as it was captured; the other one begins with an action of its own, where the
        // attack's opponent stood.
        const int attacker = settings_.attacker;
        const int defender = 1 - attacker;
        const LibraryFighter& mover = library_->fighter(attacker);
        const BoutAction& first = mover.action(settings_.attack.front());
        if (first.clip < 0)
            throw Error("The captured attack cannot be shown: its take is missing.");
        const GroundTransform scene = startOf(first.ground, attacker);
        startPlaying(attacker, settings_.attack.front(), scene, 0);
        of(attacker).replayed = 1;
        std::vector<int> calm;
        const std::vector<char> strike = strikingNodes(*library_, defender);
        for (const Transition& t : graph.transitionsOf(defender)) {
            if (library_->fighter(defender).action(t.next).clip >= 0 &&
                !strike[static_cast<std::size_t>(t.nextNode)])
                calm.push_back(t.next);
        }
        if (calm.empty()) {
            throw Error(fmt::format(
                "Player {} shows nothing but attacks outside of the captured one.", defender + 1));
        }
        const double number = drawn(settings_.seed, kStartStream, 0);
        const int action =
            calm[static_cast<std::size_t>(number * static_cast<double>(calm.size()))];
        const BoutAction& shown = library_->fighter(defender).action(action);
        const GroundFrame seen{first.ground.origin, first.ground.yaw + std::numbers::pi};
        startPlaying(defender, action, scene * between(shown.ground, seen), 0);
    } else {
        struct Moment {
            int mover;
            Transition transition;
        };
        std::vector<Moment> moments;
        for (const int mover : {0, 1}) {
            for (const Transition& t : graph.transitionsOf(mover)) {
                if (library_->fighter(mover).action(t.next).clip >= 0 &&
                    library_->fighter(1 - mover).action(t.opponent).clip >= 0)
                    moments.push_back({mover, t});
            }
        }
        if (moments.empty()) throw Error("No recorded moment shows both fighters labelled.");
        const double number = drawn(settings_.seed, kStartStream, 0);
        const Moment& moment =
            moments[static_cast<std::size_t>(number * static_cast<double>(moments.size()))];
        const LibraryFighter& own = library_->fighter(moment.mover);
        const LibraryFighter& other = library_->fighter(1 - moment.mover);
        const BoutAction& next = own.action(moment.transition.next);
        const BoutAction& theirs = other.action(moment.transition.opponent);
        const GroundTransform scene = startOf(next.ground, moment.mover);
        const double seconds = own.clipOf(next).secondsAt(next.begin);
        startPlaying(moment.mover, moment.transition.next, scene, 0);
        startPlaying(1 - moment.mover, moment.transition.opponent, scene,
                     other.clipOf(theirs).frameAt(seconds) - theirs.begin);
    }
    show();
}

void Bout::startPlaying(int player, int action, const GroundTransform& wanted, double source) {
    FighterState& fighter = of(player);
    const BoutAction& recorded = library_->fighter(player).action(action);
    const LibraryClip& clip = library_->fighter(player).clipOf(recorded);
    Playing& playing = fighter.playing;
    playing.action = action;
    playing.node = recorded.node;
    playing.time = TimeMap(recorded.frames);
    playing.total = recorded.frames;
    playing.at = std::clamp(static_cast<int>(std::lround(source)), 0, recorded.frames);
    const Station first = clip.stationAt(recorded.begin);
    playing.placement = ActionPlacement(wanted, first, moved(first, wanted));
    fighter.before = poseOf(player, playing, std::max(0, playing.at - 1));
    fill(player);
}

// ---- what is shown when ------------------------------------------------------------------------

Station Bout::stationOf(const Playing& playing, int player, int at) const {
    const LibraryFighter& fighter = library_->fighter(player);
    const BoutAction& action = fighter.action(playing.action);
    const double source = playing.time.sourceAt(at);
    return playing.placement.at(fighter.clipOf(action).stationAt(action.begin + source),
                                source / action.frames);
}

Eigen::Vector2d Bout::comOf(int player) const {
    const Playing& playing = of(player).playing;
    const LibraryFighter& fighter = library_->fighter(player);
    const BoutAction& action = fighter.action(playing.action);
    const LibraryClip& clip = fighter.clipOf(action);
    const double source = playing.time.sourceAt(playing.at);
    const GroundTransform placed = playing.placement.transformAt(
        clip.stationAt(action.begin + source), source / action.frames);
    return moved(Station{clip.comAt(action.begin + source), 0}, placed).root;
}

GroundFrame Bout::groundNow(int player) const {
    const Playing& playing = of(player).playing;
    return groundFrame(comOf(player), comOf(1 - player),
                       stationOf(playing, player, playing.at).yaw);
}

Pose Bout::poseOf(int player, const Playing& playing, int at) const {
    const LibraryFighter& fighter = library_->fighter(player);
    const BoutAction& action = fighter.action(playing.action);
    const LibraryClip& clip = fighter.clipOf(action);
    const double source = playing.time.sourceAt(at);
    const double frame = std::min(action.begin + source, clip.clip.frameCount() - 1.0);
    const auto whole = static_cast<std::size_t>(frame);
    const double share = frame - static_cast<double>(whole);
    const GroundTransform placed =
        playing.placement.transformAt(clip.stationAt(frame), source / action.frames);
    if (share < 1e-9) return moved(clip.clip.frames[whole], placed);
    return moved(blend(clip.clip.frames[whole], clip.clip.frames[whole + 1], share), placed);
}

/// Which feet stand in a frame of an action, as recorded.
Standing Bout::standingAt(int player, const Playing& playing, int at) const {
    const BoutAction& action = library_->fighter(player).action(playing.action);
    const FootContacts& contacts = library_->fighter(player).clipOf(action).contacts;
    const auto source =
        static_cast<std::size_t>(std::lround(action.begin + playing.time.sourceAt(at)));
    const auto stands = [&](const std::vector<std::uint8_t>& foot) {
        return source < foot.size() && foot[source] != 0;
    };
    return {stands(contacts.left), stands(contacts.right)};
}

void Bout::step() {
    const std::array<Playing, 2> before = {of(0).playing, of(1).playing};
    for (const int player : {0, 1}) {
        if (of(player).playing.at >= of(player).playing.total) choose(player, before);
    }
    for (const int player : {0, 1}) {
        FighterState& fighter = of(player);
        fighter.before = std::move(fighter.ahead.front());
        fighter.ahead.erase(fighter.ahead.begin());
        fighter.standing.erase(fighter.standing.begin());
    }
    ++frame_;
    for (const int player : {0, 1}) {
        FighterState& fighter = of(player);
        ++fighter.playing.at;
        ++fighter.sinceJoin;
        fill(player);
    }
    show();
}

/// Plans poses from the frame to show on, as far as the action goes and the feet look ahead.
void Bout::fill(int player) {
    FighterState& fighter = of(player);
    const Playing& playing = fighter.playing;
    const int useful = std::min(kLookAhead, playing.total - playing.at + 1);
    while (static_cast<int>(fighter.ahead.size()) < useful) {
        const int at = playing.at + static_cast<int>(fighter.ahead.size());
        const Pose planned = poseOf(player, playing, at);
        Pose pose = planned;
        const double seconds = (fighter.sinceJoin + at - playing.at) / library_->rate;
        if (!fighter.join.over(seconds)) fighter.join.apply(pose, seconds);
        Standing standing = standingAt(player, playing, at);
        if (!fighter.steps.over(seconds))
            fighter.steps.apply(*library_->fighter(player).rig, pose, planned, standing, seconds);
        fighter.ahead.push_back(std::move(pose));
        fighter.standing.push_back(standing);
    }
}

void Bout::show() {
    if (settings_.separation) {
        const auto later = [&](int player, std::size_t frames) {
            const std::vector<Pose>& ahead = of(player).ahead;
            return &ahead[std::min(frames, ahead.size() - 1)];
        };
        separation_.foresee({later(0, kForesight), later(1, kForesight)},
                            {later(0, kLimbForesight), later(1, kLimbForesight)},
                            {of(0).standing.front(), of(1).standing.front()});
    }
    for (const int player : {0, 1}) {
        FighterState& fighter = of(player);
        const Playing& playing = fighter.playing;
        const BoutAction& action = library_->fighter(player).action(playing.action);
        FighterShown& shown = fighter.shown;
        const Eigen::Vector3d& push = separation_.push(player);
        std::vector<Pose> pushed;
        if (!push.isZero(1e-6)) {
            pushed = fighter.ahead;
            for (Pose& pose : pushed)
                pose.root += push;
        }
        const std::vector<Pose>& ahead = pushed.empty() ? fighter.ahead : pushed;
        shown.pose = settings_.footLocking ? fighter.lock->show(ahead, fighter.standing) : ahead[0];
        const Rig& rig = *library_->fighter(player).rig;
        jointFrames(rig, shown.pose, shown.joints);
        fighter.feetBefore = fighter.feet;
        for (const bool left : {true, false}) {
            const auto point = footPoint(rig, left);
            if (point) {
                fighter.feet[left ? 0 : 1] =
                    shown.joints.positions[static_cast<std::size_t>(*point)] - push;
            }
        }
        shown.node = playing.node;
        shown.action = playing.action;
        shown.actionBegin = frame_ - playing.at;
        shown.actionEnd = shown.actionBegin + playing.total;
        shown.momentFrame = action.role == ActionRole::Neither
                                ? -1
                                : shown.actionBegin + playing.time.shownAt(action.moment);
        shown.standing = fighter.standing.front();
    }
    if (settings_.separation) {
        FighterShown& one = of(0).shown;
        FighterShown& two = of(1).shown;
        separation_.part({&one.pose, &two.pose}, {&one.joints, &two.joints},
                         {one.standing, two.standing});
    }
}

std::vector<std::shared_ptr<const BoutChoice>> Bout::newChoices() const {
    std::vector<std::shared_ptr<const BoutChoice>> list;
    for (const int player : {0, 1}) {
        const auto& choice = of(player).choice;
        if (choice && choice->frame == frame_ - 1) list.push_back(choice);
    }
    return list;
}

// ---- commands ----------------------------------------------------------------------------------

void Bout::apply(const BoutCommand& command) {
    using Kind = BoutCommand::Kind;
    const bool avatar = settings_.mode == BoutMode::Avatar;
    const auto needsAvatar = [&] {
        if (!avatar) throw Error("Only a bout with an avatar can be steered.");
    };
    switch (command.kind) {
        case Kind::Act:
            needsAvatar();
            wishNodes_ = commandedNodes(*library_, settings_.avatar, command.words);
            wish_ = command.words;
            break;
        case Kind::Release:
            wish_.clear();
            wishNodes_.clear();
            break;
        case Kind::Target:
            needsAvatar();
            if (!library_->fighter(settings_.avatar).avatarModel) {
                throw Error("The library was made without an avatar's model.");
            }
            target_ = command.target;
            break;
        case Kind::NoTarget:
            target_.reset();
            break;
        case Kind::Choose: {
            const auto node = library_->graph->find(
                command.player, parseLabel(library_->vocabulary(), command.words));
            if (!node || !library_->fighter(command.player).model.hasSample(*node)) {
                throw Error(
                    fmt::format("Player {} never shows \"{}\" after another labelled action.",
                                command.player + 1, command.words));
            }
            of(command.player).forced = *node;
            break;
        }
        case Kind::Weigh: {
            if (!(command.number >= 0) || !std::isfinite(command.number)) {
                throw Error("A weight is 0 (never) or a positive factor.");
            }
            std::vector<double>& weights = of(command.player).weights;
            weights.resize(static_cast<std::size_t>(library_->graph->nodeCount(command.player)), 1);
            for (const int node : nodesHolding(*library_, command.player, command.words))
                weights[static_cast<std::size_t>(node)] = command.number;
            break;
        }
        case Kind::Seed:
            settings_.seed = command.seed;
            break;
        case Kind::Temperature:
            if (!(command.number >= 0) || !std::isfinite(command.number)) {
                throw Error("A temperature is 0 or positive.");
            }
            settings_.temperature = command.number;
            break;
    }
}

}  // namespace kumite
