#include <algorithm>
#include <cmath>

#include "core/motion/feet.h"
#include "core/synthesis/bout.h"
#include "core/synthesis/draw.h"
#include "core/synthesis/moments.h"

namespace kumite {
namespace {

/// How long after its moment an action still counts as something to answer, seconds.
constexpr double kLatestAnswer = 0.25;
/// How far a target may bend the way of an action, metres.
constexpr double kMostSteering = 0.15;
/// A target nearer to the other one's pelvis is taken as this far from it, metres.
constexpr double kLeastDistance = 0.8;
/// A join takes as long as keeps what it adds below this acceleration, rad/s².
constexpr double kJoinAcceleration = 90;
/// Moments that would miss each other by more are not brought together, seconds.
constexpr double kWorstMiss = 0.2;
constexpr double kShortestJoin = 0.15;  ///< seconds
constexpr double kLongestJoin = 0.35;

/// Seconds over which one motion may become another. `later`: what both do in a frame more.
double joinSeconds(const Pose& before, const Pose& shown, const Pose& next, const Pose& later,
                   double rate) {
    const PoseOffset offset = offsetBetween(shown, next);
    const PoseOffset old = offsetBetween(shown, before);
    const PoseOffset coming = offsetBetween(later, next);
    double seconds = kShortestJoin;
    for (std::size_t j = 0; j < offset.turns.size(); ++j) {
        // The second derivatives of what is added are at most 5.77 of an offset that decays in 1 s,
        // and 3.94 of a speed.
        const double speed = rate * (old.turns[j] - coming.turns[j]).norm();
        seconds = std::max({seconds, std::sqrt(5.77 * offset.turns[j].norm() / kJoinAcceleration),
                            3.94 * speed / kJoinAcceleration});
    }
    return std::min(seconds, kLongestJoin);
}

/// Whether a reaction can be one to that strike: to a kick, a punch.
bool answersTo(const Vocabulary& vocabulary, const Label& reaction, const Label& strike) {
    for (std::size_t r = 0; r < reaction.size(); ++r) {
        const Aspect& react = vocabulary.aspects[r];
        if (react.classifier != Classifier::ReactRule || reaction[r] == kUnknown) continue;
        const std::string& to = react.qualifiers[static_cast<std::size_t>(reaction[r])].id;
        for (std::size_t a = 0; a < strike.size(); ++a) {
            const Aspect& aspect = vocabulary.aspects[a];
            if (strike[a] != kUnknown && aspect.strike == to &&
                aspect.qualifiers[static_cast<std::size_t>(strike[a])].attack)
                return true;
        }
    }
    return false;
}

}  // namespace

/// The numbers of an action as it is planned: where it stands in the scene over all frames, and
/// the poses as recorded.
ActionSummary Bout::summaryOf(int player, const Playing& playing) const {
    ActionSummary summary =
        library_->numbers
            ->summaries[static_cast<std::size_t>(player)][static_cast<std::size_t>(playing.action)];
    summary.rate = library_->rate;
    summary.frames = std::max(1, playing.total);
    summary.mean.root.setZero();
    summary.mean.yaw = 0;
    for (int at = 0; at < summary.frames; ++at) {
        const Station station = stationOf(playing, player, at);
        summary.mean.root += station.root / summary.frames;
        summary.mean.yaw += station.yaw / summary.frames;
        if (at == 0) summary.first.root = station.root, summary.first.yaw = station.yaw;
        summary.last.root = station.root;
        summary.last.yaw = station.yaw;
    }
    return summary;
}

Eigen::VectorXd Bout::momentNumbers(int player, const Playing& own, const Playing& opponent,
                                    const GroundFrame& ground) const {
    return transitionNumbers(ground, summaryOf(player, own), summaryOf(1 - player, opponent),
                             nullptr, *library_->poses, library_->components);
}

ChoiceRules Bout::rulesFor(int player, const Playing& own, const Playing& opponent) const {
    const LibraryFighter& fighter = library_->fighter(player);
    ChoiceRules rules;
    rules.temperature = settings_.temperature;
    rules.weights = of(player).weights;
    const auto nodes = static_cast<std::size_t>(library_->graph->nodeCount(player));
    const int stance = fighter.action(own.action).lastStance;
    if (stance >= 0) {
        for (const GraphNode& node : library_->graph->nodes[static_cast<std::size_t>(player)])
            rules.stance.push_back(stancesOf(library_->vocabulary(), node.label).first == stance);
    }
    if (settings_.mode == BoutMode::Passive && player != settings_.attacker) {
        rules.mode = strikingNodes(*library_, player);
        for (char& barred : rules.mode)
            barred = !barred;
    }
    if (settings_.mode == BoutMode::Avatar && player == settings_.avatar && !wishNodes_.empty()) {
        const BoutAction& theirs = library_->fighter(1 - player).action(opponent.action);
        const bool attacked =
            theirs.role == ActionRole::Strike && opponent.time.shownAt(theirs.moment) > opponent.at;
        if (!attacked || !settings_.reactFirst) {
            rules.command.assign(nodes, 0);
            for (const int node : wishNodes_)
                rules.command[static_cast<std::size_t>(node)] = 1;
        }
    }
    return rules;
}

/// The target, but not where the other one stands.
Eigen::Vector2d Bout::reachableTarget() const {
    const int other = 1 - settings_.avatar;
    const Eigen::Vector2d theirs = stationOf(of(other).playing, other, of(other).playing.at).root;
    const Eigen::Vector2d way = *target_ - theirs;
    if (way.norm() >= kLeastDistance) return *target_;
    const Eigen::Vector2d mine =
        stationOf(of(settings_.avatar).playing, settings_.avatar, of(settings_.avatar).playing.at)
            .root;
    const Eigen::Vector2d side = way.norm() > 0.05 ? way : Eigen::Vector2d(mine - theirs);
    return theirs + kLeastDistance * side.stableNormalized();
}

void Bout::choose(int player, const std::array<Playing, 2>& before) {
    FighterState& fighter = of(player);
    const Playing own = before[static_cast<std::size_t>(player)];
    // At simultaneous changes each sees what the other was doing (method A6).
    const Playing opponent = before[static_cast<std::size_t>(1 - player)];
    BoutChoice choice;
    choice.frame = frame_;
    choice.player = player;
    choice.own = own.node;
    choice.opponent = opponent.node;
    if (settings_.mode == BoutMode::Passive && player == settings_.attacker) {
        choice.action =
            settings_.attack[static_cast<std::size_t>(fighter.replayed) % settings_.attack.size()];
        ++fighter.replayed;
        choice.node = library_->fighter(player).action(choice.action).node;
        begin(player, std::move(choice));
        return;
    }
    const GroundFrame ground = groundNow(player);
    Eigen::VectorXd known = momentNumbers(player, own, opponent, ground);
    const ChoiceModel* model = &library_->fighter(player).model;
    if (target_ && player == settings_.avatar) {
        model = &*library_->fighter(player).avatarModel;
        known.conservativeResize(known.size() + 2);
        known.tail<2>() = ground.toLocal(reachableTarget());
        choice.steered = true;
    }
    Joining joining;
    if (settings_.joinSpread > 0) {
        joining.shown =
            &library_->numbers
                 ->summaries[static_cast<std::size_t>(player)][static_cast<std::size_t>(own.action)]
                 .last.pose;
        joining.spread = settings_.joinSpread;
    }
    choice.options =
        optionsOf(model->candidates(own.node, opponent.node, known, settings_.score, joining),
                  rulesFor(player, own, opponent));
    choice.number = drawn(settings_.seed, static_cast<std::uint64_t>(player),
                          static_cast<std::uint64_t>(fighter.choices++));
    const Option* chosen = &choice.options.drawn(choice.number);
    if (fighter.forced != kAnyNode) {
        const Option* forced = choice.options.find(fighter.forced);
        choice.forced = forced->candidate.transition >= 0;
        if (choice.forced) chosen = forced;
        fighter.forced = kAnyNode;
    }
    choice.node = chosen->candidate.node;
    choice.transition = chosen->candidate.transition;
    choice.action =
        library_->graph->transitionsOf(player)[static_cast<std::size_t>(choice.transition)].next;
    const bool serves =
        settings_.mode == BoutMode::Avatar && player == settings_.avatar &&
        std::find(wishNodes_.begin(), wishNodes_.end(), choice.node) != wishNodes_.end();
    if (serves) {
        choice.commanded = true;
        wish_.clear();
        wishNodes_.clear();
    }
    begin(player, std::move(choice));
}

/// What was planned after the pose that is shown counts no more.
void Bout::replan(int player) {
    FighterState& fighter = of(player);
    if (fighter.ahead.size() > 1) fighter.ahead.resize(1);
    if (fighter.standing.size() > 1) fighter.standing.resize(1);
}

/// Brings the moments of the chosen action and of the other's current one together, if they belong
/// together: a strike and a reaction.
std::optional<Coupling> Bout::couple(int player, Playing& own) {
    const bool replayed = settings_.mode == BoutMode::Passive && settings_.attacker == player;
    if (!settings_.coupling || replayed) return {};
    Playing& other = of(1 - player).playing;
    const BoutAction& mine = library_->fighter(player).action(own.action);
    const BoutAction& theirs = library_->fighter(1 - player).action(other.action);
    const bool answers = mine.role == ActionRole::Reaction && theirs.role == ActionRole::Strike;
    const bool answered = mine.role == ActionRole::Strike && theirs.role == ActionRole::Reaction;
    if (!answers && !answered) return {};
    const auto labelOf = [&](int who, const Playing& playing) -> const Label& {
        return library_->graph->node(who, playing.node).label;
    };
    const Label& reaction = answers ? labelOf(player, own) : labelOf(1 - player, other);
    const Label& strike = answers ? labelOf(1 - player, other) : labelOf(player, own);
    if (!answersTo(library_->vocabulary(), reaction, strike)) return {};
    const double rate = library_->rate;
    const double left = other.time.shownAt(theirs.moment) - other.at;
    if (left < -kLatestAnswer * rate) return {};
    Coupling coupling;
    coupling.lag = mine.lag.value_or(answers ? library_->typicalLag : -library_->typicalLag);
    const bool otherMayWarp =
        left > 0 && !(settings_.mode == BoutMode::Passive && settings_.attacker != player);
    const double source = other.time.sourceAt(other.at);
    const double natural = left > 0 && otherMayWarp ? theirs.moment - source : left;
    coupling.meeting = meet(mine.moment / rate, natural / rate, coupling.lag, otherMayWarp);
    // What would be missed all the same belongs to another exchange.
    if (std::abs(coupling.meeting.error) > kWorstMiss) return {};

    const auto warped = [](Playing& playing, const BoutAction& action, double from, double warp) {
        const double toMoment = warp * (action.moment - from);
        const double rest = action.frames - action.moment;
        const int frames = std::max(1, static_cast<int>(std::lround(toMoment + rest)));
        playing.time =
            playing.time.from(playing.at, action.moment, std::min(toMoment, frames - 0.5), frames);
        playing.total = playing.at + frames;
    };
    if (coupling.meeting.own != 1) warped(own, mine, 0, coupling.meeting.own);
    if (coupling.meeting.other != 1) {
        warped(other, theirs, source, coupling.meeting.other);
        replan(1 - player);
    }
    return coupling;
}

/// The feet as they are shown, and when and where an action that begins sets them down.
std::array<FootAtJoin, 2> Bout::feetAtJoin(int player, const Playing& next) const {
    const FighterState& fighter = of(player);
    const Rig& rig = *library_->fighter(player).rig;
    std::array<FootAtJoin, 2> feet;
    JointFrames frames;
    for (const std::size_t side : {0, 1}) {
        FootAtJoin& foot = feet[side];
        const auto point = footPoint(rig, side == 0);
        if (!point) continue;
        foot.place = fighter.feet[side];
        foot.velocity = library_->rate * (fighter.feet[side] - fighter.feetBefore[side]);
        foot.stands = fighter.standing.front()[side];
        const int last = std::max(1, static_cast<int>(JoinSteps::lookAhead() * library_->rate));
        for (int at = 0; at <= last; ++at) {
            // Beyond its end it is taken to stay as it is.
            const int frame = std::min(at, next.total);
            const bool stands = standingAt(player, next, frame)[side];
            if (stands && foot.landing < 0) foot.landing = foot.lift = at;
            if (stands && foot.lift == at) foot.lift = at + 1;
            jointFrames(rig, poseOf(player, next, frame), frames);
            foot.next.push_back(frames.positions[static_cast<std::size_t>(*point)]);
        }
    }
    return feet;
}

void Bout::begin(int player, BoutChoice choice) {
    FighterState& fighter = of(player);
    const BoutAction& action = library_->fighter(player).action(choice.action);
    const Station shown = stationOf(fighter.playing, player, fighter.playing.at);
    const GroundFrame ground = groundNow(player);
    Playing next;
    next.action = choice.action;
    next.node = action.node;
    next.time = TimeMap(action.frames);
    next.total = action.frames;
    next.placement =
        ActionPlacement(between(action.ground, ground),
                        library_->fighter(player).clipOf(action).stationAt(action.begin), shown);
    choice.distance = next.placement.distance();
    choice.turn = next.placement.turn();
    choice.coupling = couple(player, next);
    if (choice.steered) {
        const int at =
            std::min(next.total, static_cast<int>(std::lround(kTargetSeconds * library_->rate)));
        Eigen::Vector2d shift = reachableTarget() - stationOf(next, player, at).root;
        if (shift.norm() > kMostSteering) shift *= kMostSteering / shift.norm();
        next.placement.steer(shift, 0, next.time.sourceAt(at) / action.frames);
    }
    const Pose first = poseOf(player, next, 0);
    const Pose second = poseOf(player, next, 1);
    const Pose& now = fighter.ahead.front();
    JoinSettings join;
    join.duration = choice.joinSeconds =
        joinSeconds(fighter.before, now, first, second, library_->rate);
    fighter.join = Inertialisation(fighter.before, now, first, second, 1 / library_->rate, join);
    fighter.steps = JoinSteps(*library_->fighter(player).rig, first, feetAtJoin(player, next),
                              library_->rate, join.duration);
    for (const std::size_t side : {0, 1}) {
        if (fighter.steps.guides(side)) fighter.lock->settle(side == 0);
    }
    replan(player);
    fighter.sinceJoin = 0;
    fighter.playing = next;
    fighter.choice = std::make_shared<const BoutChoice>(std::move(choice));
}

}  // namespace kumite
