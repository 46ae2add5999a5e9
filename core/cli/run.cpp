#include "core/cli/run.h"

#include <algorithm>

#include "core/cli/command.h"

namespace kumite::cli {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

}  // namespace

int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err,
        bool errIsTerminal) {
    CLI::App app(
        "Annotates two-player martial-arts motion capture: reads recordings, computes the contact\n"
        "force, cuts it into actions, keeps corrections, exports.",
        "kumite");
    app.require_subcommand(1);
    app.set_version_flag("--version", "kumite " KUMITE_VERSION);
    app.footer(
        "Frames count from 0 at the first frame of the take; A:B is half-open.\n"
        "`kumite COMMAND --help` shows each command with an example.");
    app.failure_message(CLI::FailureMessage::simple);
    Action action;
    addInfo(app, action);
    addJoints(app, action);
    addNew(app, action);
    addForce(app, action);
    addSegment(app, action);
    addCorrect(app, action);
    addExport(app, action);

    try {
        // The parser takes its arguments last first.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        return app.exit(error, out, err) == 0 ? 0 : kWrongUsage;
    }
    try {
        action({out, err, errIsTerminal});
        return 0;
    } catch (const UsageError& error) {
        err << "kumite: " << error.what() << "\n";
        return kWrongUsage;
    } catch (const std::exception& error) {
        err << "kumite: " << error.what() << "\n";
        return kFailed;
    }
}

}  // namespace kumite::cli
