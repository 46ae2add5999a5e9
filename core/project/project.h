#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/body_model.h"
#include "core/motion/kinematics.h"
#include "core/motion/roles.h"
#include "core/project/label_settings.h"
#include "core/segmentation/contact_force.h"
#include "core/segmentation/corrections.h"

namespace kumite {

/// Where a fighter stands in the bout's space: turned by `yaw` about the file's origin, then
/// shifted by x and z.
struct Placement {
    double x = 0;    ///< metres
    double z = 0;    ///< metres
    double yaw = 0;  ///< radians, positive turns +z toward +x

    bool operator==(const Placement&) const = default;
};

/// The file that a fighter comes from. Recordings are never modified; the project names them.
struct RecordingRef {
    std::filesystem::path path;  ///< absolute while in memory; relative in the project file
    std::filesystem::path asf;   ///< skeleton of an .amc; else empty
    std::string sha256;
    std::string root;  ///< which skeleton of the file, see motionOfRoot; empty: the first

    bool operator==(const RecordingRef&) const = default;
};

/// What a user wrote about an action: it belongs to the action that holds `frame` (its peak when
/// the note was written), wherever boundaries go.
struct ActionNote {
    int frame = 0;  ///< of the take
    std::string text;

    bool operator==(const ActionNote&) const = default;
};

/// One fighter of a take: a recording and how it is read.
struct Fighter {
    RecordingRef recording;
    SpaceConvention space;
    double rate = 0;  ///< Hz, of the recording
    /// Frames of the file that the take holds; frame 0 of the take is frames.begin. As decided: a
    /// recording that changed may have fewer, see `framesOf`.
    FrameRange frames;
    double offset = 0;  ///< seconds on the take's clock at which frame 0 of the take stands
    Placement placement;
    std::optional<double> floor;  ///< metres in the file's space; nothing: found (method A2b)
    RoleMap roles;
    /// Names of the roles' joints, as the project file knows them, while the recording is missing.
    std::map<Role, std::string> roleNames;
    std::vector<Correction> corrections;
    std::vector<ActionNote> notes;  ///< in order of frames
    SharedValue<LabelTrack> labels;

    /// The recording's motion, or null where it is missing. Not part of the file.
    std::shared_ptr<const Motion> motion;

    bool operator==(const Fighter&) const = default;
};

/// A bout, or the part of one that was recorded in one go: one or two fighters on one clock.
struct Take {
    std::string name;
    std::vector<Fighter> fighters;

    bool operator==(const Take&) const = default;
};

/// How streams are cut (method A2).
struct SegmentationSettings {
    double cutoff = 6.0;       ///< Hz
    double prominence = 0.05;  ///< body weights
    ForceCurve curve = ForceCurve::Norm;

    bool operator==(const SegmentationSettings&) const = default;
};

/// What people decided. Everything else is a pure function of it and of the recordings. Copying
/// is cheap: motions are shared.
struct Project {
    std::vector<Take> takes;
    SegmentationSettings segmentation;
    BodyModel bodyModel = deLevaMale();
    LabelSettings labelling;
    /// Motion files, folders of them and projects beside the takes that motions are made from;
    /// absolute while in memory.
    std::vector<std::filesystem::path> clips;
    /// What is being authored, by its kind ("sequence", "keys"), as JSON; whoever authors it reads
    /// it. A kind that this version does not know stays as it is.
    std::map<std::string, std::string> drafts;

    bool operator==(const Project&) const = default;
};

/// A fighter of a project: take index and player index, both from 0.
struct FighterAddress {
    int take = 0;
    int player = 0;

    bool operator==(const FighterAddress&) const = default;
};

/// The fighter's frames that its recording really has; as decided where the recording is missing.
FrameRange framesOf(const Fighter& fighter);

const Fighter& fighterAt(const Project& project, FighterAddress address);
Fighter& fighterAt(Project& project, FighterAddress address);

/// All files that the project's recordings are read from.
std::vector<std::filesystem::path> recordingFiles(const Project& project);

/// Index of the take of that name. Throws Error that lists the takes.
int takeNamed(const Project& project, std::string_view name);

}  // namespace kumite
