#include "tests/support/bout_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "core/motion/feet.h"
#include "core/motion/overlap.h"
#include "core/project/edits.h"

namespace kumite::test {
namespace {

using nlohmann::json;

Eigen::Vector3f at(const FighterAnalysis& fighter, int frame, Role role) {
    const auto joint = fighter.input.roles[role];
    return joint ? fighter.motion->positions.at(frame, *joint) : Eigen::Vector3f::Zero().eval();
}

double angleAt(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const float cosine = (a - b).normalized().dot((c - b).normalized());
    return std::acos(std::clamp(static_cast<double>(cosine), -1.0, 1.0));
}

std::vector<Eigen::Vector3f> track(const FighterAnalysis& fighter, Role role) {
    std::vector<Eigen::Vector3f> points;
    for (int f = 0; f < fighter.frameCount(); ++f)
        points.push_back(at(fighter, f, role));
    return points;
}

double fastest(const std::vector<Eigen::Vector3f>& points, double rate) {
    float most = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        most = std::max(most, (points[i] - points[i - 1]).norm());
    }
    return most * rate;
}

/// The five learnt aspects of a true label, as one word.
std::string techniqueOf(const json& action) {
    std::string text;
    for (const auto& [aspect, qualifier] : action["label"].items()) {
        if (aspect == "move" || aspect == "react" || qualifier == "others") continue;
        text += (text.empty() ? "" : "+") + aspect + ":" + qualifier.get<std::string>();
    }
    return text.empty() ? "others" : text;
}

double mutualInformation(const std::vector<std::pair<std::string, std::string>>& pairs) {
    std::map<std::string, double> first;
    std::map<std::string, double> second;
    std::map<std::pair<std::string, std::string>, double> both;
    const double n = static_cast<double>(pairs.size());
    for (const auto& pair : pairs) {
        first[pair.first] += 1 / n;
        second[pair.second] += 1 / n;
        both[pair] += 1 / n;
    }
    double bits = 0;
    for (const auto& [pair, p] : both) {
        bits += p * std::log2(p / (first[pair.first] * second[pair.second]));
    }
    return bits;
}

}  // namespace

namespace {

/// A minimum that cuts, and what the plan says of it.
struct Found {
    int frame;
    double suspicion;
    bool judged;    ///< by a hand
    bool matched;   ///< a planned boundary is its own
    bool spurious;  ///< the plan has a spurious minimum here
};

std::vector<Found> foundMinima(const FighterAnalysis& fighter, const json& truePlayer,
                               double rate) {
    const auto planned = truePlayer["boundaries"].get<std::vector<int>>();
    const auto spurious = truePlayer["spurious"].get<std::vector<int>>();
    const double tolerance = 0.0334 * rate;
    std::vector<Found> found;
    const Segmentation& cut = *fighter.segmentation;
    for (const Boundary& boundary : cut.boundaries) {
        if (boundary.source == BoundarySource::End || !boundary.minimum) continue;
        found.push_back({boundary.frame,
                         (*fighter.suspicion)[static_cast<std::size_t>(*boundary.minimum)],
                         boundary.source != BoundarySource::Detected, false, false});
    }
    for (std::size_t i = 1; i + 1 < planned.size(); ++i) {
        std::size_t best = found.size();
        for (std::size_t k = 0; k < found.size(); ++k) {
            const int distance = std::abs(found[k].frame - planned[i]);
            if (distance > tolerance || found[k].matched) continue;
            if (best == found.size() || distance < std::abs(found[best].frame - planned[i]))
                best = k;
        }
        if (best < found.size()) found[best].matched = true;
    }
    for (Found& each : found) {
        for (const int frame : spurious) {
            if (!each.matched && std::abs(each.frame - frame) <= 3 * tolerance)
                each.spurious = true;
        }
    }
    return found;
}

}  // namespace

CutFigures compareCut(const FighterAnalysis& fighter, const json& truePlayer, double rate) {
    std::vector<Found> found = foundMinima(fighter, truePlayer, rate);
    CutFigures figures;
    figures.planned = static_cast<int>(truePlayer["boundaries"].size()) - 2;
    figures.found = static_cast<int>(found.size());
    for (const Found& each : found) {
        figures.matched += each.matched;
        figures.spurious += each.spurious;
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.suspicion > b.suspicion; });
    const auto top = static_cast<std::size_t>(std::ceil(0.05 * static_cast<double>(found.size())));
    for (std::size_t k = 0; k < top; ++k)
        figures.spuriousInTop += found[k].spurious;
    return figures;
}

ReviewFigures reviewByTruth(Project project, const json& truePlayers, double rate) {
    ReviewFigures figures;
    Analysis analysis = analyse(project);
    for (;;) {
        std::optional<Found> worst;
        FighterAddress whose;
        int left = 0;
        for (int player = 0; player < 2; ++player) {
            const auto slot = static_cast<std::size_t>(player);
            for (const Found& each :
                 foundMinima(analysis.takes[0][slot], truePlayers[slot], rate)) {
                left += each.spurious && !each.judged;
                if (each.judged || each.suspicion < kSuspect) continue;
                if (worst && worst->suspicion >= each.suspicion) continue;
                worst = each;
                whose = {0, player};
            }
        }
        figures.spuriousLeft = left;
        if (!worst) return figures;
        const MaybeEdit edit = worst->spurious
                                   ? removeBoundary(project, analysis, whose, worst->frame)
                                   : acceptBoundary(project, analysis, whose, worst->frame);
        if (!edit) throw Error(fmt::format("Frame {} cannot be judged.", worst->frame));
        ++figures.decisions;
        figures.removed += worst->spurious;
        project = edit->project;
        analysis = analyse(project, analysis);
    }
}

MotionFigures measureMotion(const FighterAnalysis& fighter) {
    const int frames = fighter.frameCount();
    const double rate = fighter.input.rate;
    MotionFigures m;
    m.seconds = frames / rate;
    m.actionsPerSecond = static_cast<double>(fighter.segmentation->actions.size()) / m.seconds;
    double square = 0;
    double sum = 0;
    for (int f = 0; f < frames; ++f) {
        const auto i = static_cast<std::size_t>(f);
        m.meanVerticalForce += fighter.force->force.force[i].y() / frames;
        sum += fighter.force->force.curve[i] / frames;
        square += fighter.force->force.curve[i] * fighter.force->force.curve[i] / frames;
    }
    m.forceDeviation = std::sqrt(std::max(0.0, square - sum * sum));
    const auto left = track(fighter, Role::LeftToe);
    const auto right = track(fighter, Role::RightToe);
    const double floor = fighter.body->floor;
    m.skate = measureFootSkate(left, right, rate, floor).ratio();
    m.sharpestKnee = m.sharpestElbow = std::numbers::pi;
    for (int f = 0; f < frames; ++f) {
        for (const Role role : {Role::LeftToe, Role::RightToe, Role::LeftAnkle, Role::RightAnkle}) {
            m.deepestUnderFloor = std::max(m.deepestUnderFloor,
                                           floor - static_cast<double>(at(fighter, f, role).y()));
        }
        for (const bool isLeft : {true, false}) {
            const auto side = [&](Role role) {
                return at(fighter, f, isLeft ? role : mirrored(role));
            };
            const double knee =
                angleAt(side(Role::LeftHip), side(Role::LeftKnee), side(Role::LeftAnkle));
            const double elbow =
                angleAt(side(Role::LeftShoulder), side(Role::LeftElbow), side(Role::LeftWrist));
            m.sharpestKnee = std::min(m.sharpestKnee, knee);
            m.straightestKnee = std::max(m.straightestKnee, knee);
            m.sharpestElbow = std::min(m.sharpestElbow, elbow);
            m.straightestElbow = std::max(m.straightestElbow, elbow);
        }
    }
    m.fastestHand = std::max(fastest(track(fighter, Role::LeftWrist), rate),
                             fastest(track(fighter, Role::RightWrist), rate));
    m.fastestFoot = std::max(fastest(track(fighter, Role::LeftAnkle), rate),
                             fastest(track(fighter, Role::RightAnkle), rate));
    return m;
}

PairFigures measurePair(const Take& take, const std::vector<FighterAnalysis>& fighters) {
    PairFigures figures;
    figures.nearest = 1e9;
    figures.deepestOverlap = -1e9;
    const int frames = std::min(fighters[0].frameCount(), fighters[1].frameCount());
    const auto place = [&](std::size_t who, const Eigen::Vector3d& point) {
        return placed(take.fighters[who], fighters[who].body->floor, point);
    };
    for (int f = 0; f < frames; ++f) {
        const auto i = static_cast<std::size_t>(f);
        const Eigen::Vector3d way = place(0, fighters[0].body->com.position[i]) -
                                    place(1, fighters[1].body->com.position[i]);
        const double distance = std::hypot(way.x(), way.z());
        figures.nearest = std::min(figures.nearest, distance);
        figures.farthest = std::max(figures.farthest, distance);
        figures.mean += distance / frames;
        std::vector<std::vector<Capsule>> bodies;
        for (std::size_t who = 0; who < 2; ++who) {
            bodies.push_back(
                bodyCapsules(fighters[who].input.roles, fighters[who].motion->positions, f));
            for (Capsule& capsule : bodies.back()) {
                capsule.a = place(who, capsule.a);
                capsule.b = place(who, capsule.b);
            }
        }
        const double depth = overlap(bodies[0], bodies[1]);
        figures.deepestOverlap = std::max(figures.deepestOverlap, depth);
        figures.overlapShare += depth > 0.03 ? 1.0 / frames : 0.0;
    }
    return figures;
}

LabelFigures measureLabels(const json& truth) {
    LabelFigures figures;
    std::map<std::string, int> allOthers;  // by move
    std::vector<std::pair<std::string, std::string>> choices;
    std::vector<std::pair<std::string, std::string>> ranges;
    for (const json& player : truth["players"]) {
        for (const json& action : player["actions"]) {
            ++figures.actions;
            const std::string technique = techniqueOf(action);
            const std::string move = action["label"]["move"];
            const std::string react = action["label"]["react"];
            ++figures.techniques[technique];
            ++figures.moves[move];
            ++figures.reacts[react];
            if (technique == "others" && react == "others") ++allOthers[move];
            if (!action.contains("chosen")) continue;
            choices.emplace_back(technique, action["chosen"]["opponent"]);
            ranges.emplace_back(technique, action["chosen"]["range"]);
        }
    }
    int best = 0;
    for (const auto& [move, count] : allOthers)
        best = std::max(best, count);
    figures.baseline = static_cast<double>(best) / std::max(1, figures.actions);
    figures.information = mutualInformation(choices);
    figures.informationOfRange = mutualInformation(ranges);
    auto shifted = choices;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        shifted[i].second = choices[(i * 7919 + 13) % choices.size()].second;
    }
    figures.informationByChance = mutualInformation(shifted);
    return figures;
}

}  // namespace kumite::test
