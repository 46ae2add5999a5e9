#pragma once

#include <nlohmann/json.hpp>

#include "core/cli/command.h"
#include "core/project/agreement.h"

namespace kumite::cli {

/// How far two people agree, as tables: counts, κ per aspect and overall.
void printAgreement(const OpenProject& open, const Agreement& agreement, const Streams& streams);

/// The same with every difference.
nlohmann::ordered_json agreementJson(const OpenProject& open, const Agreement& agreement);

}  // namespace kumite::cli
