#pragma once

#include <string>
#include <vector>

namespace kumite::cli {

struct CommandHelp {
    std::string name;
    std::string text;  ///< as --help prints it
};

/// What --help says of the command and of all its subcommands as a manual page (roff, UTF-8).
std::string manualPage(const std::string& version, const std::string& general,
                       const std::vector<CommandHelp>& commands);

}  // namespace kumite::cli
