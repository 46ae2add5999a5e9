#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/editing/critical_joint.h"
#include "core/editing/key_track.h"
#include "core/editing/retrieval.h"
#include "core/motion/motion_library.h"

namespace kumite {

/// A library with the features of all of its poses: what key poses are looked up in. The clips of
/// `features` are the library's motions, in order; those that were made have no frames there.
struct KeyLibrary {
    std::shared_ptr<const MotionLibrary> library;
    FeatureLibrary features;

    const LibraryMotion& motion(int clip) const {
        return library->motions[static_cast<std::size_t>(clip)];
    }
};
KeyLibrary keyLibrary(std::shared_ptr<const MotionLibrary> library,
                      const PoseFeatureSettings& settings = {}, const Progress& progress = {});

/// The features of the track's keys at a library's rate. Throws Error as `validate` does.
KeySequence keySequence(const KeyTrack& track, double rate,
                        const PoseFeatureSettings& settings = {});

/// Matches as `findSimilar` gives them; those that differ in equally many features stand in the
/// order of how far their poses are from the keys'; of frames with equal features around a match
/// the one with the nearest pose is taken. `distance` in metres: mean over keys and the part's
/// joints, in the pelvis' frame. Nothing given: the whole body.
struct PoseMatch {
    KeyMatch match;
    double distance = 0;
};
std::vector<PoseMatch> findSimilar(const KeyLibrary& library, const KeyTrack& track,
                                   std::optional<BodyPart> part = {},
                                   const RetrievalSettings& settings = {},
                                   const Progress& progress = {});

/// Where a part comes from.
struct PartChoice {
    enum class Kind {
        /// From the body's clip, or from its own best match where that fits better; legs from the
        /// body's clip, because its way through space is theirs.
        Automatic,
        WithBody,  ///< from the body's clip
        Own,       ///< from its own best match, in `within` if that is given
        Match      ///< from `match`, as chosen from a list
    };
    Kind kind = Kind::Automatic;
    std::optional<ClipRange> within;
    std::optional<KeyMatch> match;
};

struct AssemblyChoices {
    std::optional<ClipRange> body;  ///< where the whole body is looked for; nothing: everywhere
    std::array<PartChoice, kBodyPartCount> parts;
};

/// What an assembly is made of.
struct AssemblyPlan {
    PoseMatch body;
    std::array<std::optional<PoseMatch>, kBodyPartCount> parts;  ///< nothing: with the body
};

/// Looks up the whole body and the parts. Throws Error if nothing is long enough.
AssemblyPlan planAssembly(const KeyLibrary& library, const KeyTrack& track,
                          const AssemblyChoices& choices = {}, const Progress& progress = {});

struct AssemblySettings {
    /// Junction joints of replaced parts get the query's mean and deviation (paper C, 4.2.2).
    bool adjusted = true;
    double meetKeys = 0;   ///< 0 … 1: how far the result is drawn to the keys' poses
    bool lockFeet = true;  ///< the same clean-up as everywhere
};

/// What the adjustment did to one junction joint.
struct AdjustedJunction {
    BodyPart part = BodyPart::LeftArm;
    int joint = 0;
    JointAdjustment values;
};

struct Assembly {
    Clip clip;
    std::vector<AdjustedJunction> junctions;
};

/// Puts the parts together over the keys' frames: each source mapped in time so that its feature
/// poses fall on the keys (time_mapping.h), placed where the first key stands and as it faces.
Assembly assemble(const KeyLibrary& library, const KeyTrack& track, const AssemblyPlan& plan,
                  const AssemblySettings& settings = {});

/// The joints in which a part hangs on the rest: from its first joint to shoulder or hip; the
/// trunk's first.
std::vector<int> junctionJoints(const Rig& rig, BodyPart part);

}  // namespace kumite
