#include "core/motion/survey.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"

namespace kumite {
namespace {

using enum Role;

struct Unit {
    std::string_view name;
    double metres;
};

// The CMU database's unit: 1/0.45 inch.
constexpr std::array<Unit, 7> kUnits = {{{"m", 1.0},
                                         {"dm", 0.1},
                                         {"cm", 0.01},
                                         {"mm", 0.001},
                                         {"inch", 0.0254},
                                         {"foot", 0.3048},
                                         {"cmu", 0.0254 / 0.45}}};

constexpr double kUsualLeg = 0.85;    // metres from hip to ankle of an adult
constexpr double kShortestLeg = 0.7;  // outside these the unit is doubtful
constexpr double kLongestLeg = 1.1;

const Unit& nearestUnit(double legInUnits) {
    const auto misfit = [&](const Unit& unit) {
        return std::abs(std::log(legInUnits * unit.metres / kUsualLeg));
    };
    return *std::min_element(kUnits.begin(), kUnits.end(),
                             [&](const Unit& a, const Unit& b) { return misfit(a) < misfit(b); });
}

/// A look at some frames, evenly spread, in the file's own axes and units.
JointPositions sampleFrames(const Motion& motion, int count) {
    Motion sample;
    sample.skeleton = motion.skeleton;
    sample.frameCount = std::min(count, motion.frameCount);
    for (int i = 0; i < sample.frameCount; ++i) {
        const auto row = motion.frame(
            static_cast<int>(static_cast<std::int64_t>(i) * motion.frameCount / sample.frameCount));
        sample.channels.insert(sample.channels.end(), row.begin(), row.end());
    }
    return forwardKinematics(sample, sample.frames(), {1.0, UpAxis::Y});
}

/// Mean length of both legs, hip to knee to ankle, over sampled frames, in the unit of `sample`; 0
/// without legs. Not from the offsets: position channels may hold the bones.
double legLength(const JointPositions& sample, const RoleMap& roles) {
    double sum = 0;
    int legs = 0;
    for (const bool left : {true, false}) {
        const auto hip = roles[left ? LeftHip : RightHip];
        const auto knee = roles[left ? LeftKnee : RightKnee];
        const auto ankle = roles[left ? LeftAnkle : RightAnkle];
        if (!hip || !knee || !ankle) continue;
        for (int frame = 0; frame < sample.frameCount; ++frame) {
            sum += (sample.at(frame, *knee) - sample.at(frame, *hip)).norm() +
                   (sample.at(frame, *ankle) - sample.at(frame, *knee)).norm();
        }
        ++legs;
    }
    return legs > 0 ? sum / (legs * sample.frameCount) : 0;
}

/// The axis along which the body stands over its feet, in most frames.
UpAxis findUpAxis(const JointPositions& sample, const RoleMap& roles, Findings& findings) {
    const auto top = roles.has(Neck) ? roles[Neck] : roles[Pelvis];
    const auto left = roles[LeftAnkle];
    const auto right = roles[RightAnkle];
    if (!top || !left || !right) return UpAxis::Y;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int frame = 0; frame < sample.frameCount; ++frame) {
        sum += sample.at(frame, *top) - 0.5f * (sample.at(frame, *left) + sample.at(frame, *right));
    }
    const Eigen::Vector3f size = sum.cwiseAbs();
    if (size.x() > size.y() && size.x() > size.z()) {
        findings.push_back(
            warning("The body lies along the x axis; y was taken for up. Say which axis is up."));
        return UpAxis::Y;
    }
    const UpAxis up = size.z() > size.y() ? UpAxis::Z : UpAxis::Y;
    if ((up == UpAxis::Z ? sum.z() : sum.y()) < 0) {
        findings.push_back(warning("The body stands on its head most of the time: is up right?"));
    }
    return up;
}

/// How far joints move between a frame and the next, the pelvis' own shift left out: the mean over
/// the joints, in the unit of `positions`.
double poseStep(const JointPositions& positions, int frame, int pelvis) {
    const Eigen::Vector3f shift = positions.at(frame + 1, pelvis) - positions.at(frame, pelvis);
    double sum = 0;
    for (int joint = 0; joint < positions.jointCount; ++joint) {
        sum += (positions.at(frame + 1, joint) - positions.at(frame, joint) - shift).norm();
    }
    return sum / positions.jointCount;
}

/// How much the distances between the joints that have roles differ from those with all rotations
/// zero: the mean over all pairs, in the unit of `positions`. Where the body stands and which way
/// it faces does not matter.
double differenceFromRest(const JointPositions& positions, int frame, const Skeleton& skeleton,
                          const RoleMap& roles, double unit) {
    const std::vector<Eigen::Vector3d> rest = skeleton.restPositions();
    double sum = 0;
    int pairs = 0;
    for (const Role a : allRoles()) {
        for (const Role b : allRoles()) {
            if (b >= a || !roles.has(a) || !roles.has(b)) continue;
            const double now =
                (positions.at(frame, *roles[a]) - positions.at(frame, *roles[b])).norm();
            const double then = unit * (rest[static_cast<std::size_t>(*roles[a])] -
                                        rest[static_cast<std::size_t>(*roles[b])])
                                           .norm();
            sum += std::abs(now - then);
            ++pairs;
        }
    }
    return pairs > 0 ? sum / pairs : 0;
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// A rest pose before the motion shows as frames that stand still and then a jump far beyond what
/// the motion after it does in one frame. Filtered data smears the jump over some frames: there
/// the pose itself must be the skeleton's rest pose, else filtered motion would be taken for one.
int findLeadingRest(const Motion& motion, const RoleMap& roles, double legInUnits) {
    constexpr int kWindow = 240;       // frames looked at in one go
    constexpr double kStill = 1e-3;    // of a leg: sensor noise
    constexpr double kJump = 0.04;     // of a leg, mean over all joints
    constexpr double kTimesUsual = 8;  // the jump against the median step after it
    constexpr double kTimesNext = 3;   // the jump against the next step: not smeared
    constexpr double kNearRest = 0.1;  // of a leg
    const double unit = 1.0 / legInUnits;
    const int pelvis = roles[Pelvis].value_or(0);
    const auto look = [&](int begin) {
        const FrameRange frames{begin, std::min(begin + kWindow, motion.frameCount)};
        return forwardKinematics(motion, frames, {unit, UpAxis::Y});
    };
    // The first step that is no standing still, however long that lasts.
    std::optional<int> jump;
    for (int begin = 0; begin + 1 < motion.frameCount && !jump; begin += kWindow - 1) {
        const JointPositions positions = look(begin);
        for (int i = 0; i + 1 < positions.frameCount && !jump; ++i) {
            if (poseStep(positions, i, pelvis) > kStill) jump = begin + i;
        }
    }
    if (!jump) return 0;
    const JointPositions positions = look(*jump);
    std::vector<double> after;
    for (int i = 1; i + 1 < positions.frameCount; ++i) {
        after.push_back(poseStep(positions, i, pelvis));
    }
    if (after.size() < 4) return 0;
    const double step = poseStep(positions, 0, pelvis);
    if (step < kJump || step < kTimesUsual * medianOf(after)) return 0;
    const bool sharp = step > kTimesNext * after.front();
    const bool atRest = differenceFromRest(positions, 0, *motion.skeleton, roles, unit) < kNearRest;
    return sharp || atRest ? *jump + 1 : 0;
}

}  // namespace

std::optional<double> metresPerUnitFromName(std::string_view name) {
    for (const Unit& unit : kUnits) {
        if (equalsIgnoringCase(unit.name, name)) return unit.metres;
    }
    const auto metres = parseNumber(name);
    return metres && *metres > 0 ? metres : std::nullopt;
}

std::string unitNameOf(double metresPerUnit) {
    for (const Unit& unit : kUnits) {
        if (std::abs(metresPerUnit - unit.metres) <= 1e-4 * unit.metres) {
            return std::string(unit.name);
        }
    }
    return shortest(metresPerUnit) + " m";
}

Survey surveyMotion(const Motion& motion, const SurveyOverrides& overrides) {
    Survey survey;
    survey.roles = mapRoles(*motion.skeleton);
    survey.findings = survey.roles.findings;
    const RoleMap& roles = survey.roles.roles;

    constexpr int kSamples = 64;
    const JointPositions sample = sampleFrames(motion, kSamples);
    const double leg = legLength(sample, roles);
    const auto found = leg > 0 ? std::optional(nearestUnit(leg)) : std::nullopt;
    survey.space.metresPerUnit = overrides.metresPerUnit.value_or(found ? found->metres : 0.01);
    survey.unitName = unitNameOf(survey.space.metresPerUnit);
    survey.legLength = leg * survey.space.metresPerUnit;
    if (!found && !overrides.metresPerUnit) {
        survey.findings.push_back(
            warning("Without legs the unit cannot be found; centimetres are assumed."));
    }
    if (found && (survey.legLength < kShortestLeg || survey.legLength > kLongestLeg)) {
        survey.findings.push_back(
            warning(fmt::format("The legs would be {} m long: is the unit ({}) right?",
                                fixed(survey.legLength, 2), survey.unitName)));
    }
    survey.space.up = overrides.up ? *overrides.up : findUpAxis(sample, roles, survey.findings);
    survey.rate = overrides.rate.value_or(rateOf(motion.frameTime));
    if (leg > 0) survey.leadingRestFrames = findLeadingRest(motion, roles, leg);
    if (survey.leadingRestFrames > 0) {
        survey.findings.push_back(note(
            survey.leadingRestFrames == 1
                ? std::string("Frame 0 is a rest pose, not motion; takes leave it out.")
                : fmt::format("Frames 0 to {} are a rest pose, not motion; takes leave them out.",
                              survey.leadingRestFrames - 1)));
    }
    return survey;
}

}  // namespace kumite
