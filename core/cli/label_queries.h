#pragma once

#include <string>

#include "core/cli/command.h"

namespace kumite::cli {

/// What `kumite labels` can be asked of the labels of a project.
struct LabelQuery {
    std::string filter, similar;
    int count = 6;
    bool judge = false, curve = false;

    bool isAsked() const { return !filter.empty() || !similar.empty() || judge || curve; }
};

void addLabelQueries(CLI::App& command, LabelQuery& query);
/// `take`: only this one, empty: all. Throws Error, UsageError.
void answerLabelQuery(const OpenProject& open, const LabelQuery& query, const std::string& take,
                      bool json, const Streams& streams);

}  // namespace kumite::cli
