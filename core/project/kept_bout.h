#pragma once

#include <filesystem>

#include "core/project/edits.h"
#include "core/synthesis/bout_tape.h"

namespace kumite {

/// Both fighters of a bout as channels of the skeletons that they were recorded on. Their order is
/// that of the players; units and axes are those of `fighterLike`.
std::array<Motion, 2> boutMotions(const Project& project, const BoutTape& tape,
                                  const Progress& progress = {});
/// The fighter whose recording lends a player of bouts its skeleton: of the first take of two whose
/// recording is there and has the rig's joints. Throws Error where there is none.
const Fighter& fighterLike(const Project& project, const Rig& rig, int player);

/// A bout that became a take.
struct KeptBout {
    Edit edit;
    std::vector<std::filesystem::path> files;
    /// Of each player, how detection alone finds the bout's boundaries in the written motion, ±66
    /// ms, before any correction: twice the pairs over all boundaries of both.
    std::array<double, 2> foundAgain{};
};
/// Writes both motions as NAME-1.bvh and NAME-2.bvh and the log as NAME.json into `folder`, and
/// adds them as a take: where actions begin and end and what they are was decided, so boundaries
/// stand as corrections and labels as said by a hand. A label needs at least half of its action
/// shown: the first and the last may stay open. Files of those names must not be there yet. Throws
/// Error. Cancellable.
KeptBout keepBout(const Project& project, const Analysis& analysis, const BoutTape& tape,
                  const std::string& name, const std::filesystem::path& folder,
                  const Progress& progress = {});

}  // namespace kumite
