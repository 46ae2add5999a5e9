#pragma once

#include <set>
#include <string>

#include "core/project/edits.h"

namespace kumite {

/// The recordings (SHA-256) of takes that are motions made of others: Project::drafts["made"]. By
/// the recording, so that it holds whatever the take is called later. What is made of recordings
/// must not be looked up in its own results.
std::set<std::string> madeRecordings(const Project& project);
bool isMade(const std::set<std::string>& made, const Take& take);

/// `addTake` of a made motion.
MaybeEdit addMadeTake(const Project& project, const Take& take);

}  // namespace kumite
