#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/editing/assembly.h"
#include "core/project/edits.h"

namespace kumite {

/// Key poses as they stand in a project, and how they become a motion: Project::drafts["keys"].
struct KeyDraft {
    KeyTrack track;
    std::string body;  ///< where the whole body is looked for, as `actionNamed` has it; empty:
                       ///< everywhere
    /// Automatic, WithBody or Own.
    std::array<PartChoice::Kind, kBodyPartCount> parts{};
    /// Where an own part is looked for, as `body`.
    std::array<std::string, kBodyPartCount> places;
    AssemblySettings assembly;
};

/// A JSON object: "track" as keys.json has it (core/editing/README.md), and these choices.
std::string keyDraftText(const KeyDraft& draft);
/// Throws InputError, as parseKeys does: the rig may have become another one.
KeyDraft parseKeyDraft(std::string_view text, const std::string& file,
                       std::shared_ptr<const Rig> rig);

/// The project's draft; one without keys, of that rate, where there is none. Throws InputError.
KeyDraft keyDraftOf(const Project& project, std::shared_ptr<const Rig> rig, double rate);
/// A draft without keys is none.
MaybeEdit setKeyDraft(const Project& project, const KeyDraft& draft, std::string edit);

/// What the draft says about sources, in a library. Throws Error if the body's place is not there.
AssemblyChoices choicesOf(const MotionLibrary& library, const KeyDraft& draft);

}  // namespace kumite
