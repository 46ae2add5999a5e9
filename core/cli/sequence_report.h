#pragma once

#include <string>
#include <vector>

#include "core/cli/command.h"
#include "core/transition/sequence.h"

namespace kumite::cli {

inline constexpr const char* kClipNames =
    "A clip is a file's stem or take:player:action of a project; NAME@A:B plays the frames A to B\n"
    "(half-open, of the file or take).";

/// How transitions are made.
struct TransitionOptions {
    std::string method;
    std::uint64_t seed = 1;
    bool rawFeet = false;
};
void addTransitionOptions(CLI::App& command, TransitionOptions& options);

/// The clips of these names as a sequence; each transition draws from a seed of its own. Throws
/// Error for a name that means nothing, or that asks for a target (`C@x,y,z`, see
/// library_strikes.h) that cannot be reached.
Sequence sequenceOf(const MotionLibrary& library, const std::vector<std::string>& names,
                    const TransitionOptions& options);

/// The one transition between two blocks.
std::string transitionJson(const SequenceMotion& motion);
std::string sequenceJson(const Sequence& sequence, const SequenceMotion& motion);
void printSequence(const MotionLibrary& library, const Sequence& sequence,
                   const SequenceMotion& motion, const Streams& streams);

}  // namespace kumite::cli
