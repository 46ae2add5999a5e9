#include "core/editing/assembly.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/editing/time_mapping.h"
#include "core/motion/blend.h"
#include "core/motion/foot_lock.h"
#include "core/motion/inertialise.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::vector<std::optional<BodyPart>> partsOf(const Rig& rig) {
    std::vector<int> parents;
    for (const Rig::Joint& joint : rig.joints)
        parents.push_back(joint.parent);
    return partsOfJoints(parents, rig.roles);
}

/// Places of the joints with roles (of one part) in the pelvis' frame: over the floor's point below
/// the pelvis, turned by the heading.
class BodyPoints {
public:
    BodyPoints(const Rig& rig, std::optional<BodyPart> part) : rig_(rig) {
        const auto parts = partsOf(rig);
        std::set<int> joints;
        for (const Role role : allRoles()) {
            const auto joint = rig.roles[role];
            if (joint && (!part || parts[static_cast<std::size_t>(*joint)] == part))
                joints.insert(*joint);
        }
        joints_.assign(joints.begin(), joints.end());
    }
    std::vector<Vector3d> of(const Pose& pose) {
        jointFrames(rig_, pose, frames_);
        const auto pelvis = static_cast<std::size_t>(rig_.roles[Role::Pelvis].value_or(0));
        const GroundTransform back{-headingOf(rig_, pose).value_or(0.0), 0, 0};
        std::vector<Vector3d> points;
        for (const int joint : joints_)
            points.push_back(back * (frames_.positions[static_cast<std::size_t>(joint)] -
                                     frames_.positions[pelvis]));
        return points;
    }

private:
    const Rig& rig_;
    std::vector<int> joints_;
    JointFrames frames_;
};

double meanDistance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]).norm();
    return a.empty() ? 0 : sum / static_cast<double>(a.size());
}

/// Moves each key's frame to the nearest pose around it that has the same features: features alone
/// tell a stretch of frames, not a frame. Returns the mean distance of the poses.
double refineFrames(KeyMatch& match, const KeyLibrary& library, BodyPoints& points,
                    const std::vector<std::vector<Vector3d>>& wanted) {
    const Clip& clip = library.motion(match.clip).clip;
    const auto& features = library.features;
    const int begin = features.clips[static_cast<std::size_t>(match.clip)].begin;
    const auto bitsAt = [&](int f) { return features.bits[static_cast<std::size_t>(begin + f)]; };
    const auto distanceAt = [&](int f, std::size_t k) {
        return meanDistance(wanted[k], points.of(clip.frames[static_cast<std::size_t>(f)]));
    };
    const int reach = static_cast<int>(std::lround(0.1 * features.rate));
    double sum = 0;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const int own = match.frames[k];
        const int first = k > 0 ? match.frames[k - 1] + 1 : 0;
        const int last = k + 1 < wanted.size() ? match.frames[k + 1] - 1 : clip.frameCount() - 1;
        double least = distanceAt(own, k);
        for (const int step : {-1, 1}) {
            for (int f = own + step;
                 std::abs(f - own) <= reach && f >= first && f <= last && bitsAt(f) == bitsAt(own);
                 f += step) {
                const double distance = distanceAt(f, k);
                if (distance >= least) continue;
                least = distance;
                match.frames[k] = f;
            }
        }
        sum += least;
    }
    return sum / static_cast<double>(wanted.size());
}

/// Poses of a source over the query's frames.
class Source {
public:
    Source(const KeyLibrary& library, const KeyTrack& track, const KeyMatch& match)
        : motion_(library.motion(match.clip)),
          map_(keyFrames(track), {match.frames.begin(), match.frames.end()}) {}

    Pose at(double queryFrame) const {
        return poseAt(motion_.clip, map_(queryFrame) / motion_.clip.rate);
    }
    Standing standingAt(double queryFrame) const {
        const int last = static_cast<int>(motion_.standing.size()) - 1;
        const int frame = static_cast<int>(std::lround(map_(queryFrame)));
        return motion_.standing[static_cast<std::size_t>(std::clamp(frame, 0, last))];
    }

private:
    static std::vector<double> keyFrames(const KeyTrack& track) {
        std::vector<double> frames;
        for (const KeyPose& key : track.keys)
            frames.push_back(key.frame);
        return frames;
    }
    const LibraryMotion& motion_;
    TimeMapping map_;
};

PoseMatch bestMatch(const KeyLibrary& library, const KeyTrack& track, std::optional<BodyPart> part,
                    const std::optional<ClipRange>& within) {
    RetrievalSettings settings;
    if (within) settings.within = {*within};
    // Where keys lie farther apart or nearer than any clip has it, time is stretched more.
    for (int attempt = 0; attempt < 4; ++attempt) {
        const auto found = findSimilar(library, track, part, settings);
        if (!found.empty()) return found.front();
        settings.fastest /= 3;
        settings.slowest *= 3;
    }
    throw Error(fmt::format("{} has too few frames for {} key poses.",
                            within ? library.motion(within->clip).name : "Every motion",
                            track.keys.size()));
}

/// Adds what the keys' poses are ahead of the clip's, interpolated between the keys.
void drawToKeys(Clip& clip, const KeyTrack& track, double share) {
    const int first = track.keys.front().frame;
    std::vector<PoseOffset> offsets;
    for (const KeyPose& key : track.keys)
        offsets.push_back(
            offsetBetween(key.pose, clip.frames[static_cast<std::size_t>(key.frame - first)]));
    for (int f = 0; f < clip.frameCount(); ++f) {
        std::size_t k = 0;
        while (k + 1 < track.keys.size() && track.keys[k + 1].frame <= f + first)
            ++k;
        const std::size_t next = std::min(k + 1, track.keys.size() - 1);
        const int span = track.keys[next].frame - track.keys[k].frame;
        const double way = span > 0 ? double(f + first - track.keys[k].frame) / span : 0.0;
        const double later = eased(Easing::Smooth, way);
        Pose& pose = clip.frames[static_cast<std::size_t>(f)];
        pose.root += share * ((1 - later) * offsets[k].root + later * offsets[next].root);
        for (std::size_t j = 0; j < pose.turns.size(); ++j) {
            const Vector3d v =
                share * ((1 - later) * offsets[k].turns[j] + later * offsets[next].turns[j]);
            if (v.norm() > 0)
                pose.turns[j] =
                    (Quaterniond(Eigen::AngleAxisd(v.norm(), v.normalized())) * pose.turns[j])
                        .normalized();
        }
    }
}

}  // namespace

KeyLibrary keyLibrary(std::shared_ptr<const MotionLibrary> library,
                      const PoseFeatureSettings& settings, const Progress& progress) {
    KeyLibrary keys;
    keys.features.rate = library->rate;
    const double count = static_cast<double>(library->motions.size());
    for (const LibraryMotion& motion : library->motions) {
        // Of what was made itself nothing is found: it has no frames here.
        const auto bits = motion.made
                              ? std::vector<PoseBits>()
                              : poseBits(positionsOf(motion.clip), library->rig->roles, settings);
        keys.features.add(motion.name, bits);
        progress.update(static_cast<double>(keys.features.clips.size()) / count);
    }
    keys.library = std::move(library);
    return keys;
}

KeySequence keySequence(const KeyTrack& track, double rate, const PoseFeatureSettings& settings) {
    validate(track);
    Clip keys{track.rig, track.rate, {}};
    KeySequence sequence;
    for (const KeyPose& key : track.keys) {
        keys.frames.push_back(key.pose);
        const int frame = static_cast<int>(std::lround(key.frame * rate / track.rate));
        // At a lower rate two keys may fall into one frame; they stay in order.
        sequence.frames.push_back(
            sequence.frames.empty() ? frame : std::max(frame, sequence.frames.back() + 1));
    }
    sequence.bits = poseBits(positionsOf(keys), track.rig->roles, settings);
    return sequence;
}

std::vector<PoseMatch> findSimilar(const KeyLibrary& library, const KeyTrack& track,
                                   std::optional<BodyPart> part, const RetrievalSettings& given,
                                   const Progress& progress) {
    RetrievalSettings settings = given;
    if (part) settings.mask &= maskOf(*part);
    // More than are wanted: of those with equal features the nearest poses are the best.
    settings.results = 2 * given.results;
    const KeySequence keys = keySequence(track, library.features.rate);
    BodyPoints points(*track.rig, part);
    std::vector<std::vector<Vector3d>> wanted;
    for (const KeyPose& key : track.keys)
        wanted.push_back(points.of(key.pose));
    std::vector<PoseMatch> matches;
    for (KeyMatch& match : findSimilar(library.features, keys, settings, progress)) {
        const double distance = refineFrames(match, library, points, wanted);
        matches.push_back({std::move(match), distance});
    }
    std::stable_sort(matches.begin(), matches.end(), [](const PoseMatch& a, const PoseMatch& b) {
        return std::pair(a.match.mismatches, a.distance) <
               std::pair(b.match.mismatches, b.distance);
    });
    if (static_cast<int>(matches.size()) > given.results)
        matches.resize(static_cast<std::size_t>(given.results));
    return matches;
}

AssemblyPlan planAssembly(const KeyLibrary& library, const KeyTrack& track,
                          const AssemblyChoices& choices, const Progress& progress) {
    validate(track);
    if (track.keys.empty()) throw Error("There is no key pose to make a motion of.");
    if (!library.library || library.library->motions.empty())
        throw Error("The library holds no motion.");
    AssemblyPlan plan;
    plan.body = bestMatch(library, track, std::nullopt, choices.body);
    const KeySequence keys = keySequence(track, library.features.rate);
    const auto& bodyClip = library.features.clips[static_cast<std::size_t>(plan.body.match.clip)];
    for (const BodyPart part : allParts()) {
        progress.update(static_cast<double>(part) / kBodyPartCount);
        const PartChoice& choice = choices.parts[static_cast<std::size_t>(part)];
        auto& own = plan.parts[static_cast<std::size_t>(part)];
        switch (choice.kind) {
            case PartChoice::Kind::WithBody:
                break;
            case PartChoice::Kind::Match:
                if (choice.match) own = PoseMatch{*choice.match, 0};
                break;
            case PartChoice::Kind::Own:
                own = bestMatch(library, track, part, choice.within);
                break;
            case PartChoice::Kind::Automatic: {
                if (part == BodyPart::LeftLeg || part == BodyPart::RightLeg) break;
                int differing = 0;
                for (std::size_t k = 0; k < keys.bits.size(); ++k) {
                    const PoseBits bits = library.features.bits[static_cast<std::size_t>(
                        bodyClip.begin + plan.body.match.frames[k])];
                    differing += std::popcount((bits ^ keys.bits[k]) & maskOf(part));
                }
                if (differing == 0) break;
                PoseMatch best = bestMatch(library, track, part, {});
                if (best.match.mismatches < differing) own = std::move(best);
                break;
            }
        }
    }
    return plan;
}

std::vector<int> junctionJoints(const Rig& rig, BodyPart part) {
    const auto parts = partsOf(rig);
    const auto first = junctionOf(parts, part);
    if (!first) return {};
    std::optional<int> last;
    switch (part) {
        case BodyPart::LeftArm:
            last = rig.roles[Role::LeftShoulder];
            break;
        case BodyPart::RightArm:
            last = rig.roles[Role::RightShoulder];
            break;
        case BodyPart::LeftLeg:
            last = rig.roles[Role::LeftHip];
            break;
        case BodyPart::RightLeg:
            last = rig.roles[Role::RightHip];
            break;
        case BodyPart::Trunk:
            break;
    }
    std::vector<int> joints;
    for (int j = last.value_or(*first); j >= 0 && parts[static_cast<std::size_t>(j)] == part;
         j = rig.joint(j).parent)
        joints.insert(joints.begin(), j);
    return joints;
}

Assembly assemble(const KeyLibrary& library, const KeyTrack& track, const AssemblyPlan& plan,
                  const AssemblySettings& settings) {
    const Clip query = clipOf(track);
    if (query.frames.empty()) throw Error("There is no key pose to make a motion of.");
    const int first = track.keys.front().frame;
    Assembly result;
    result.clip = {track.rig, track.rate, {}};
    const Source body(library, track, plan.body.match);
    const GroundTransform place =
        groundAlignment(*track.rig, body.at(first), track.keys.front().pose);
    std::vector<Standing> standing;
    for (int f = 0; f < query.frameCount(); ++f) {
        result.clip.frames.push_back(moved(body.at(first + f), place));
        standing.push_back(body.standingAt(first + f));
    }

    const auto parts = partsOf(*track.rig);
    for (const BodyPart part : allParts()) {
        const auto& own = plan.parts[static_cast<std::size_t>(part)];
        if (!own) continue;
        const Source source(library, track, own->match);
        for (int f = 0; f < query.frameCount(); ++f) {
            const Pose pose = source.at(first + f);
            if (part == BodyPart::LeftLeg || part == BodyPart::RightLeg) {
                const std::size_t foot = part == BodyPart::LeftLeg ? 0 : 1;
                standing[static_cast<std::size_t>(f)][foot] = source.standingAt(first + f)[foot];
            }
            for (std::size_t j = 0; j < parts.size(); ++j) {
                if (parts[j] == part)
                    result.clip.frames[static_cast<std::size_t>(f)].turns[j] = pose.turns[j];
            }
        }
        for (const int joint : junctionJoints(*track.rig, part)) {
            const auto j = static_cast<std::size_t>(joint);
            std::vector<Quaterniond> retrieved, wanted;
            for (std::size_t f = 0; f < query.frames.size(); ++f) {
                retrieved.push_back(result.clip.frames[f].turns[j]);
                wanted.push_back(query.frames[f].turns[j]);
            }
            const JointAdjustment values = adjustJoint(retrieved, wanted);
            result.junctions.push_back({part, joint, values});
            for (std::size_t f = 0; settings.adjusted && f < query.frames.size(); ++f)
                result.clip.frames[f].turns[j] = retrieved[f];
        }
    }
    if (settings.meetKeys > 0) drawToKeys(result.clip, track, std::min(1.0, settings.meetKeys));
    if (settings.lockFeet)
        result.clip = withLockedFeet(result.clip, standing, library.library->feet);
    return result;
}

}  // namespace kumite
