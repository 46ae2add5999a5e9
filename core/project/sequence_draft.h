#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/project/edits.h"
#include "core/transition/sequence.h"

namespace kumite {

/// A block as an author plans it.
struct DraftBlock {
    std::string clip;   ///< as `blockNamed` reads it
    std::string title;  ///< as people read it; empty: the clip
    /// Frames of what the clip names, at the library's rate; nothing: all.
    std::optional<FrameRange> trim;
    int repeats = 1;
    TransitionRequest transition;  ///< how it is reached
    bool locked = false;           ///< drawing anew leaves its transition alone

    bool operator==(const DraftBlock&) const = default;
};

/// A sequence as it stands in a project: Project::drafts["sequence"].
struct SequenceDraft {
    std::vector<DraftBlock> blocks;
    bool cleanFeet = true;

    bool operator==(const SequenceDraft&) const = default;
};

std::string sequenceDraftText(const SequenceDraft& draft);
/// Throws InputError that names the place in the JSON.
SequenceDraft parseSequenceDraft(std::string_view text, const std::string& file);

/// The project's draft; an empty one where there is none. Throws InputError.
SequenceDraft sequenceDraftOf(const Project& project);
MaybeEdit setSequenceDraft(const Project& project, const SequenceDraft& draft, std::string edit);

/// The block that a name means: a clip as `actionNamed` knows it, or a strike made to hit a target,
/// "NAME@x,y,z" in metres in the striker's frame (library_strikes.h). Throws Error.
SequenceBlock blockNamed(const MotionLibrary& library, const std::string& name);

/// Throws Error that names the block.
Sequence sequenceOf(const MotionLibrary& library, const SequenceDraft& draft,
                    const TransitionSettings& settings = {});

/// A name of an action that outlives edits of boundaries: the stretch of its take,
/// "round1:1@40:92". Of a whole file the file's name.
std::string lastingName(const MotionLibrary& library, const LibraryAction& action);

}  // namespace kumite
