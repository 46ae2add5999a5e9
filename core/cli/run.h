#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace kumite::cli {

/// Runs `kumite ARGUMENTS`: exit code 0 done, 1 the work failed (one sentence on `err`), 2 wrong
/// usage.
int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err,
        bool errIsTerminal = false);

}  // namespace kumite::cli
