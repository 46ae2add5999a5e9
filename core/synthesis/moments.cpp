#include "core/synthesis/moments.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

/// Lags beyond this belong to no exchange.
constexpr double kLongestLag = 0.7;  ///< seconds

/// The frame, counted from the action's begin, at which a limb is farthest from the own pelvis
/// toward the other fighter; nothing if no limb strikes.
std::optional<int> farthest(const BoutLibrary& library, int player, const BoutAction& action,
                            const Label& label) {
    const Vocabulary& vocabulary = library.vocabulary();
    const LibraryFighter& own = library.fighter(player);
    const LibraryClip& clip = own.clipOf(action);
    const LibraryClip& other =
        (*library.fighter(1 - player).clips)[static_cast<std::size_t>(action.clip)];
    std::vector<int> limbs;
    for (int a = 0; a < vocabulary.size(); ++a) {
        const int qualifier = label[static_cast<std::size_t>(a)];
        if (qualifier == kUnknown || !vocabulary[a].limb) continue;
        if (!vocabulary[a].qualifiers[static_cast<std::size_t>(qualifier)].attack) continue;
        if (const auto joint = own.rig->roles[*vocabulary[a].limb]) limbs.push_back(*joint);
    }
    std::optional<int> best;
    double most = 0;
    JointFrames frames;
    for (int i = 0; !limbs.empty() && i <= action.frames; ++i) {
        const int frame = action.begin + i;
        const Eigen::Vector2d pelvis = clip.stations[static_cast<std::size_t>(frame)].root;
        const Eigen::Vector2d ahead =
            other.empty() ? pelvis : other.comAt(other.frameAt(clip.secondsAt(frame)));
        const Eigen::Vector2d toward = (ahead - pelvis).stableNormalized();
        jointFrames(*own.rig, clip.clip.frames[static_cast<std::size_t>(frame)], frames);
        for (const int joint : limbs) {
            const Eigen::Vector3d& end = frames.positions[static_cast<std::size_t>(joint)];
            const double reach = toward.dot(Eigen::Vector2d(end.x(), end.z()) - pelvis);
            if (best && reach <= most) continue;
            best = i;
            most = reach;
        }
    }
    return best;
}

double beginOf(const LibraryFighter& fighter, const BoutAction& action) {
    return fighter.clipOf(action).secondsAt(action.begin);
}

double endOf(const LibraryFighter& fighter, const BoutAction& action) {
    return fighter.clipOf(action).secondsAt(action.begin + action.frames);
}

double momentOf(const LibraryFighter& fighter, const BoutAction& action) {
    return fighter.clipOf(action).secondsAt(action.begin + action.moment);
}

/// The opponent's action of a role that overlaps an action longest in time.
const BoutAction* partner(const LibraryFighter& own, const BoutAction& action,
                          const LibraryFighter& other, ActionRole role) {
    const BoutAction* best = nullptr;
    double longest = 0;
    for (const BoutAction& each : other.actions) {
        if (each.role != role || each.clip != action.clip) continue;
        const double shared = std::min(endOf(own, action), endOf(other, each)) -
                              std::max(beginOf(own, action), beginOf(other, each));
        if (shared <= longest) continue;
        longest = shared;
        best = &each;
    }
    return best;
}

}  // namespace

bool strikes(const Vocabulary& vocabulary, const Label& label) {
    for (std::size_t a = 0; a < label.size(); ++a) {
        const Aspect& aspect = vocabulary.aspects[a];
        if (label[a] != kUnknown && aspect.qualifiers[static_cast<std::size_t>(label[a])].attack)
            return true;
    }
    return false;
}

bool reacts(const Vocabulary& vocabulary, const Label& label) {
    for (std::size_t a = 0; a < label.size(); ++a) {
        const Aspect& aspect = vocabulary.aspects[a];
        if (aspect.classifier == Classifier::ReactRule && label[a] != kUnknown &&
            aspect.fallback != label[a])
            return true;
    }
    return false;
}

StancePair stancesOf(const Vocabulary& vocabulary, const Label& label) {
    for (std::size_t a = 0; a < label.size(); ++a) {
        const Aspect& aspect = vocabulary.aspects[a];
        if (aspect.classifier != Classifier::MoveRule || label[a] == kUnknown) continue;
        const std::string& symbol = aspect.qualifiers[static_cast<std::size_t>(label[a])].id;
        const auto dash = symbol.find('-');
        if (dash != 1 || symbol.size() != 3) continue;
        return {symbol[0], symbol[2]};
    }
    return {};
}

void findMoments(BoutLibrary& library) {
    const CoupledGraph& graph = *library.graph;
    for (const int player : {0, 1}) {
        LibraryFighter& fighter = library.fighters[static_cast<std::size_t>(player)];
        for (std::size_t i = 0; i < fighter.actions.size(); ++i) {
            BoutAction& action = fighter.actions[i];
            if (action.clip < 0 || action.node < 0) continue;
            const Label& label = graph.node(player, action.node).label;
            const StancePair stances = stancesOf(*graph.vocabulary, label);
            action.firstStance = stances.first;
            action.lastStance = stances.last;
            if (const auto extension = farthest(library, player, action, label)) {
                action.role = ActionRole::Strike;
                action.moment = *extension;
            } else if (reacts(*graph.vocabulary, label)) {
                const Action& recorded = graph.action(player, static_cast<int>(i)).frames;
                const double share = recorded.end > recorded.begin
                                         ? static_cast<double>(recorded.peak - recorded.begin) /
                                               (recorded.end - recorded.begin)
                                         : 0.0;
                action.role = ActionRole::Reaction;
                action.moment = share * action.frames;
            }
        }
    }
    std::vector<double> lags;
    for (const int player : {0, 1}) {
        LibraryFighter& own = library.fighters[static_cast<std::size_t>(player)];
        const LibraryFighter& other = library.fighter(1 - player);
        for (BoutAction& action : own.actions) {
            if (action.role == ActionRole::Neither) continue;
            const bool reaction = action.role == ActionRole::Reaction;
            const BoutAction* belongs =
                partner(own, action, other, reaction ? ActionRole::Strike : ActionRole::Reaction);
            if (!belongs) continue;
            const double lag = momentOf(own, action) - momentOf(other, *belongs);
            if (std::abs(lag) > kLongestLag) continue;
            action.lag = lag;
            if (reaction) lags.push_back(lag);
        }
    }
    if (lags.empty()) return;
    const auto middle = lags.begin() + static_cast<std::ptrdiff_t>(lags.size() / 2);
    std::nth_element(lags.begin(), middle, lags.end());
    library.typicalLag = *middle;
}

}  // namespace kumite
