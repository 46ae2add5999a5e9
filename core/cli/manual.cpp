#include "core/cli/manual.h"

#include <sstream>

namespace kumite::cli {
namespace {

/// A line of text that means itself.
std::string plain(const std::string& line) {
    std::string text;
    // A line that begins so would be a request.
    if (line.starts_with('.') || line.starts_with('\'')) text = "\\&";
    for (const char c : line) {
        if (c == '\\') {
            text += "\\e";
        } else if (c == '-') {
            text += "\\-";
        } else {
            text += c;
        }
    }
    return text;
}

/// Text as it is laid out.
std::string asItIs(const std::string& text) {
    std::istringstream in(text);
    std::string result = ".nf\n", line;
    while (std::getline(in, line))
        result += plain(line) + "\n";
    return result + ".fi\n";
}

}  // namespace

std::string manualPage(const std::string& version, const std::string& general,
                       const std::vector<CommandHelp>& commands) {
    std::string page = ".\\\" -*- coding: utf-8 -*-\n.TH KUMITE 1 \"\" \"kumite " + version +
                       "\" \"Kumite\"\n.SH NAME\n"
                       "kumite \\- annotate, learn from and author two\\-player motion capture\n"
                       ".SH SYNOPSIS\n.B kumite\n.I COMMAND\n[options]\n.SH DESCRIPTION\n";
    page += asItIs(general) + ".SH COMMANDS\n";
    for (const CommandHelp& command : commands)
        page += ".SS " + plain(command.name) + "\n" + asItIs(command.text);
    page +=
        ".SH EXIT STATUS\n0: done; 1: the work failed, one sentence says why; 2: wrong usage.\n";
    return page;
}

}  // namespace kumite::cli
