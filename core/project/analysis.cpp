#include "core/project/analysis.h"

#include <algorithm>
#include <cmath>

#include "core/motion/feet.h"
#include "core/motion/heading.h"

namespace kumite {
namespace {

std::shared_ptr<const FighterMotion> deriveMotion(const Fighter& fighter,
                                                  const Progress& progress) {
    auto motion = std::make_shared<FighterMotion>();
    motion->positions =
        forwardKinematics(*fighter.motion, framesOf(fighter), fighter.space, progress);
    return motion;
}

/// Speed of the faster foot at each frame, m/s.
std::vector<float> fasterFootSpeed(const Fighter& fighter, const JointPositions& positions) {
    std::vector<float> fastest;
    for (const bool left : {true, false}) {
        const auto joint = footPoint(*fighter.motion->skeleton, fighter.roles, left);
        if (!joint || positions.frameCount < 2) continue;
        const std::vector<float> speed = jointSpeed(positions, *joint, fighter.rate);
        if (fastest.empty()) fastest = speed;
        std::transform(fastest.begin(), fastest.end(), speed.begin(), fastest.begin(),
                       [](float a, float b) { return std::max(a, b); });
    }
    return fastest;
}

std::shared_ptr<const FighterBody> deriveBody(const Fighter& fighter, const Project& project,
                                              const JointPositions& positions) {
    auto body = std::make_shared<FighterBody>();
    const Skeleton& skeleton = *fighter.motion->skeleton;
    body->com = centreOfMass(project.bodyModel, skeleton, fighter.roles, positions);
    body->floor = fighter.floor ? *fighter.floor
                                : floorHeight(skeleton, fighter.roles, positions).value_or(0.0);
    body->footSpeed = fasterFootSpeed(fighter, positions);
    body->contacts = footContacts(skeleton, fighter.roles, positions, fighter.rate,
                                  project.labelling.rules.contacts);
    body->heading = headings(*fighter.motion, framesOf(fighter), fighter.space, fighter.roles);
    return body;
}

std::shared_ptr<const FighterForce> deriveForce(const Fighter& fighter,
                                                const SegmentationSettings& settings,
                                                const CentreOfMass& com) {
    auto force = std::make_shared<FighterForce>();
    force->force = contactForce(com.position, fighter.rate, settings.cutoff, settings.curve);
    force->minima = findMinima(force->force.curve);
    return force;
}

/// Runs the stages of one fighter up to the segmentation, taking over what did not change.
FighterAnalysis deriveFighter(const Fighter& fighter, const Project& project,
                              const Analysis& previous, const FighterAnalysis* old,
                              const Progress& progress) {
    FighterAnalysis now;
    now.input = fighter;
    if (!fighter.motion) return now;

    const auto unchanged = [&](auto... members) {
        return old && (... && (old->input.*members == fighter.*members));
    };
    const bool sameMotion =
        old && old->motion && unchanged(&Fighter::motion, &Fighter::frames, &Fighter::space);
    now.motion = sameMotion ? old->motion : deriveMotion(fighter, progress);

    const bool sameBody = sameMotion && previous.bodyModel == project.bodyModel &&
                          previous.contacts == project.labelling.rules.contacts &&
                          unchanged(&Fighter::roles, &Fighter::rate, &Fighter::floor);
    now.body = sameBody ? old->body : deriveBody(fighter, project, now.motion->positions);

    const SegmentationSettings& was = previous.settings;
    const SegmentationSettings& is = project.segmentation;
    const bool sameForce = sameBody && was.cutoff == is.cutoff && was.curve == is.curve;
    if (sameForce) {
        now.force = old->force;
    } else if (!now.body->com.position.empty()) {
        now.force = deriveForce(fighter, is, now.body->com);
    }

    if (sameForce && was.prominence == is.prominence && unchanged(&Fighter::corrections)) {
        now.segmentation = old->segmentation;
        return now;
    }
    // Without a body there is no force: a level curve, which only a hand can cut.
    const std::vector<double> level(now.force ? 0 : static_cast<std::size_t>(now.frameCount()),
                                    1.0);
    const std::span<const double> curve =
        now.force ? std::span<const double>(now.force->force.curve) : level;
    const std::span<const ForceMinimum> minima =
        now.force ? std::span<const ForceMinimum>(now.force->minima)
                  : std::span<const ForceMinimum>();
    now.segmentation = std::make_shared<Segmentation>(segment(
        curve, minima, is.prominence, fighter.corrections, kCorrectionReach * fighter.rate));
    return now;
}

/// Suspicion is learned from the whole project, so one correction changes it everywhere.
void deriveSuspicion(const Project& project, Analysis& analysis) {
    std::vector<SuspicionInput> inputs;
    std::vector<FighterAnalysis*> owners;
    for (auto& take : analysis.takes) {
        for (FighterAnalysis& fighter : take) {
            if (!fighter.force) continue;
            inputs.push_back({fighter.force->force.curve, fighter.force->minima,
                              fighter.segmentation.get(), fighter.body->footSpeed,
                              fighter.input.rate, project.segmentation.prominence});
            owners.push_back(&fighter);
        }
    }
    std::vector<SuspicionRanking> ranked = rankSuspicion(inputs);
    for (std::size_t i = 0; i < owners.size(); ++i) {
        owners[i]->suspicion = std::make_shared<Suspicion>(std::move(ranked[i].suspicion));
        owners[i]->evidence =
            std::make_shared<std::vector<SuspicionEvidence>>(std::move(ranked[i].evidence));
    }
}

}  // namespace

const FighterAnalysis& Analysis::at(FighterAddress address) const {
    return takes.at(static_cast<std::size_t>(address.take))
        .at(static_cast<std::size_t>(address.player));
}

Analysis analyse(const Project& project, const Analysis& previous, const Progress& progress) {
    // The old values of a fighter are found by its motion, so that takes may come, go and swap.
    const auto oldValuesOf = [&](const Fighter& fighter) -> const FighterAnalysis* {
        const FighterAnalysis* best = nullptr;
        for (const auto& take : previous.takes) {
            for (const FighterAnalysis& old : take) {
                if (!fighter.motion || old.input.motion != fighter.motion) continue;
                if (old.input == fighter) return &old;
                if (!best) best = &old;
            }
        }
        return best;
    };
    std::size_t fighters = 0;
    for (const Take& take : project.takes)
        fighters += take.fighters.size();

    Analysis analysis;
    analysis.settings = project.segmentation;
    analysis.bodyModel = project.bodyModel;
    analysis.contacts = project.labelling.rules.contacts;
    std::size_t done = 0;
    for (const Take& take : project.takes) {
        auto& values = analysis.takes.emplace_back();
        for (const Fighter& fighter : take.fighters) {
            const double from = static_cast<double>(done) / static_cast<double>(fighters);
            const double to = static_cast<double>(++done) / static_cast<double>(fighters);
            values.push_back(deriveFighter(fighter, project, previous, oldValuesOf(fighter),
                                           progress.part(from, to)));
        }
    }
    deriveSuspicion(project, analysis);
    progress.update(1.0);
    return analysis;
}

Eigen::Vector3d placed(const Fighter& fighter, double floor, const Eigen::Vector3d& point) {
    const double c = std::cos(fighter.placement.yaw);
    const double s = std::sin(fighter.placement.yaw);
    return {c * point.x() + s * point.z() + fighter.placement.x, point.y() - floor,
            c * point.z() - s * point.x() + fighter.placement.z};
}

double timeOfFrame(const Fighter& fighter, double frame) {
    return fighter.offset + frame / fighter.rate;
}

int frameAtTime(const Fighter& fighter, double seconds) {
    const int last = std::max(0, framesOf(fighter).size() - 1);
    const double frame = std::round((seconds - fighter.offset) * fighter.rate);
    return static_cast<int>(std::clamp(frame, 0.0, static_cast<double>(last)));
}

TimeSpan timeSpan(const Take& take) {
    if (take.fighters.empty()) return {};
    TimeSpan span{take.fighters.front().offset, take.fighters.front().offset};
    for (const Fighter& fighter : take.fighters) {
        span.begin = std::min(span.begin, fighter.offset);
        span.end =
            std::max(span.end, timeOfFrame(fighter, std::max(0, framesOf(fighter).size() - 1)));
    }
    return span;
}

}  // namespace kumite
