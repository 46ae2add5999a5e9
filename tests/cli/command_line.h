#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "core/cli/run.h"

namespace kumite::test {

/// What a script sees of a command.
struct Result {
    int code;
    std::string out;
    std::string err;
};

/// Runs the command without a process, as if these words had been typed.
inline Result kumite(const std::vector<std::string>& words) {
    std::ostringstream out, err;
    const int code = cli::run(words, out, err);
    return {code, out.str(), err.str()};
}

}  // namespace kumite::test
