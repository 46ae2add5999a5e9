#pragma once

#include <span>
#include <string>

#include "core/project/project.h"
#include "core/segmentation/segmentation.h"

namespace kumite {

/// What is noted about an action: the notes whose frames it holds, joined by "; ". Empty: nothing.
std::string noteOf(std::span<const ActionNote> notes, const Segmentation& segmentation,
                   const Action& action);

}  // namespace kumite
