#include "core/synthesis/bout_library.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/synthesis/moments.h"

namespace kumite {
namespace {

/// Position among frames as a whole frame and the share of the way to the next.
struct Between {
    std::size_t frame = 0;
    double share = 0;
};
Between between(double frame, std::size_t count) {
    const double inside = std::clamp(frame, 0.0, static_cast<double>(count - 1));
    const auto whole = std::min(static_cast<std::size_t>(inside), count > 1 ? count - 2 : 0);
    return {whole, count > 1 ? inside - static_cast<double>(whole) : 0.0};
}

std::vector<BoutAction> actionsOf(const CoupledGraph& graph, int player,
                                  const std::vector<LibraryClip>& clips,
                                  const std::vector<LibraryClip>& others) {
    std::vector<BoutAction> actions;
    for (const BasicAction& basic : graph.actions[static_cast<std::size_t>(player)]) {
        BoutAction& action = actions.emplace_back();
        action.node = basic.node;
        const auto take = static_cast<std::size_t>(basic.take);
        if (take >= clips.size() || clips[take].empty()) continue;
        const LibraryClip& clip = clips[take];
        action.begin = clip.frameAt(basic.beginSeconds);
        action.frames = clip.frameAt(basic.endSeconds) - action.begin;
        // An action of a single frame at the end of a take cannot be shown.
        if (action.frames < 1) continue;
        action.clip = basic.take;
        if (take >= others.size() || others[take].empty()) continue;
        const LibraryClip& other = others[take];
        const int theirs = other.frameAt(clip.secondsAt(action.begin));
        action.ground = groundFrame(clip.com[static_cast<std::size_t>(action.begin)],
                                    other.com[static_cast<std::size_t>(theirs)],
                                    clip.stations[static_cast<std::size_t>(action.begin)].yaw);
    }
    return actions;
}

/// The transitions of a mover whose next action can be shown.
std::vector<int> playable(const CoupledGraph& graph, int mover,
                          const std::vector<BoutAction>& actions) {
    std::vector<int> list;
    const auto& all = graph.transitionsOf(mover);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (actions[static_cast<std::size_t>(all[i].next)].clip >= 0)
            list.push_back(static_cast<int>(i));
    }
    return list;
}

std::vector<LabelTriple> triplesOf(const CoupledGraph& graph, int mover,
                                   const std::vector<int>& transitions) {
    const auto all = labelTriples(graph.transitionsOf(mover));
    std::vector<LabelTriple> some;
    for (const int each : transitions)
        some.push_back(all[static_cast<std::size_t>(each)]);
    return some;
}

/// The local poses with which the next actions of transitions begin, column by column.
Eigen::MatrixXf firstPoses(const CoupledGraph& graph, const BoutNumbers& numbers, int mover,
                           const std::vector<int>& transitions) {
    Eigen::MatrixXf poses(kPoseNumbers, static_cast<Eigen::Index>(transitions.size()));
    const auto slot = static_cast<std::size_t>(mover);
    for (std::size_t i = 0; i < transitions.size(); ++i) {
        const int next = graph.transitions[slot][static_cast<std::size_t>(transitions[i])].next;
        poses.col(static_cast<Eigen::Index>(i)) =
            numbers.summaries[slot][static_cast<std::size_t>(next)].first.pose.cast<float>();
    }
    return poses;
}

ChoiceModel modelOf(const CoupledGraph& graph, const BoutNumbers& numbers, int mover,
                    LabelTerm labels, GeometryTerm geometry, const Eigen::MatrixXd& rows,
                    const std::vector<BoutAction>& actions) {
    const std::vector<int> list = playable(graph, mover, actions);
    Eigen::MatrixXd some(static_cast<Eigen::Index>(list.size()), rows.cols());
    for (std::size_t i = 0; i < list.size(); ++i)
        some.row(static_cast<Eigen::Index>(i)) = rows.row(list[i]);
    return ChoiceModel(std::move(labels), std::move(geometry), some, triplesOf(graph, mover, list),
                       list, static_cast<int>(rows.cols() / 3),
                       firstPoses(graph, numbers, mover, list));
}

/// Of the rows that both models learnt from, and of their nodes.
std::string hashOf(const CoupledGraph& graph, const std::array<Eigen::MatrixXd, 2>& rows) {
    std::string bytes;
    for (const std::size_t mover : {0, 1}) {
        for (const Transition& t : graph.transitions[mover])
            bytes += fmt::format("{} {} {} {} {} {};", t.own, t.opponent, t.next, t.ownNode,
                                 t.opponentNode, t.nextNode);
        const std::size_t size = static_cast<std::size_t>(rows[mover].size()) * sizeof(double);
        const std::size_t begin = bytes.size();
        bytes.resize(begin + size);
        if (size > 0) std::memcpy(bytes.data() + begin, rows[mover].data(), size);
    }
    return sha256(bytes);
}

}  // namespace

Station LibraryClip::stationAt(double frame) const {
    const Between at = between(frame, stations.size());
    const Station& a = stations[at.frame];
    if (at.share == 0) return a;
    const Station& b = stations[at.frame + 1];
    return {a.root + at.share * (b.root - a.root), a.yaw + at.share * (b.yaw - a.yaw)};
}

Eigen::Vector2d LibraryClip::comAt(double frame) const {
    const Between at = between(frame, com.size());
    if (at.share == 0) return com[at.frame];
    return com[at.frame] + at.share * (com[at.frame + 1] - com[at.frame]);
}

int LibraryClip::frameAt(double seconds) const {
    return static_cast<int>(std::clamp(std::lround((seconds - offset) * clip.rate), 0L,
                                       static_cast<long>(clip.frameCount() - 1)));
}

std::shared_ptr<const BoutLibrary> boutLibrary(LibrarySource source) {
    auto library = std::make_shared<BoutLibrary>();
    library->rate = source.rate;
    library->components = source.components;
    library->geometry = source.geometry;
    library->graph = source.graph;
    library->numbers = source.numbers;
    library->poses = source.poses;
    library->hash = hashOf(*source.graph, source.rows);
    library->findings = std::move(source.findings);
    for (const std::size_t p : {0, 1}) {
        LibraryFighter& fighter = library->fighters[p];
        const int player = static_cast<int>(p);
        fighter.actions = actionsOf(*source.graph, player, source.clips[p], source.clips[1 - p]);
        fighter.model =
            modelOf(*source.graph, *source.numbers, player, std::move(source.labelTerms[p]),
                    std::move(source.geometryTerms[p]), source.rows[p], fighter.actions);
    }
    for (const std::size_t p : {0, 1}) {
        LibraryFighter& fighter = library->fighters[p];
        fighter.clips = std::move(source.clips[p]);
        for (const LibraryClip& clip : *fighter.clips) {
            if (clip.empty() || fighter.rig) continue;
            fighter.rig = clip.clip.rig;
            fighter.footRest = clip.footRest;
        }
    }
    findMoments(*library);
    return library;
}

std::shared_ptr<const BoutLibrary> withAvatar(std::shared_ptr<const BoutLibrary> library,
                                              int player, const Progress& progress) {
    const auto slot = static_cast<std::size_t>(player);
    if (library->fighters[slot].avatarModel) return library;
    const CoupledGraph& graph = *library->graph;
    const Eigen::MatrixXd rows =
        transitionMatrix(graph, *library->numbers, player, *library->poses, library->components);
    const Eigen::Index third = rows.cols() / 3;
    std::vector<int> list;
    for (const int each : playable(graph, player, library->fighters[slot].actions)) {
        if (library->numbers->grounds[slot][static_cast<std::size_t>(each)].target)
            list.push_back(each);
    }
    if (list.empty())
        throw Error("No action of the avatar is followed by half a second of its take.");
    Eigen::MatrixXd samples(static_cast<Eigen::Index>(list.size()), rows.cols() + 2);
    std::vector<int> classes;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const Eigen::Vector2d target =
            *library->numbers->grounds[slot][static_cast<std::size_t>(list[i])].target;
        samples.row(row) << rows.row(list[i]).head(2 * third), target.transpose(),
            rows.row(list[i]).tail(third);
        classes.push_back(graph.transitionsOf(player)[static_cast<std::size_t>(list[i])].nextNode);
    }
    GeometryTerm geometry(library->geometry, samples, classes, graph.nodeCount(player), progress);
    auto with = std::make_shared<BoutLibrary>(*library);
    LibraryFighter& fighter = with->fighters[slot];
    fighter.avatarModel = ChoiceModel(fighter.model.labelTerm(), std::move(geometry), samples,
                                      triplesOf(graph, player, list), list, static_cast<int>(third),
                                      firstPoses(graph, *library->numbers, player, list));
    return with;
}

std::vector<char> strikingNodes(const BoutLibrary& library, int player) {
    std::vector<char> list;
    for (const GraphNode& node : library.graph->nodes[static_cast<std::size_t>(player)])
        list.push_back(strikes(library.vocabulary(), node.label));
    return list;
}

std::vector<int> commandedNodes(const BoutLibrary& library, int player, const std::string& words) {
    const Vocabulary& vocabulary = library.vocabulary();
    const auto colon = words.find(':');
    const std::string name = words.substr(0, colon);
    std::vector<int> nodes;
    bool known = false;
    for (int a = 0; a < vocabulary.size(); ++a) {
        const Aspect& aspect = vocabulary[a];
        if (aspect.id != name && (aspect.strike.empty() || aspect.strike != name)) continue;
        std::vector<int> qualifiers;
        if (colon != std::string::npos) {
            const auto found = aspect.find(words.substr(colon + 1));
            if (!found) continue;
            qualifiers.push_back(*found);
        } else {
            for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q) {
                if (aspect.qualifiers[q].attack) qualifiers.push_back(static_cast<int>(q));
            }
            if (qualifiers.empty()) qualifiers.push_back(aspect.fallback == 0 ? 1 : 0);
        }
        known = true;
        for (const int q : qualifiers) {
            const auto& table =
                library.graph
                    ->repertoire[static_cast<std::size_t>(player)][static_cast<std::size_t>(a)];
            if (static_cast<std::size_t>(q) >= table.size()) continue;
            for (const int node : table[static_cast<std::size_t>(q)]) {
                if (library.fighter(player).model.hasSample(node)) nodes.push_back(node);
            }
        }
    }
    if (!known) {
        std::string list;
        for (const Aspect& aspect : vocabulary.aspects) {
            if (aspect.classifier == Classifier::Msvm)
                list += (list.empty() ? "" : ", ") + aspect.id;
        }
        throw Error(
            fmt::format("\"{}\" is no action that can be asked for; there are {}, what they "
                        "strike with, and ASPECT:QUALIFIER.",
                        words, list));
    }
    if (nodes.empty()) {
        throw Error(fmt::format("Player {} never shows \"{}\" after another labelled action.",
                                player + 1, words));
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace kumite
