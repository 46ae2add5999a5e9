#include "core/cli/run.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "core/cli/command.h"
#include "core/cli/manual.h"

namespace kumite::cli {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

/// Names options that exclude each other by the alphabet: the library keeps them by address, so
/// that no two runs, nor the manual page, would say the same.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text = CLI::Formatter::make_option_opts(option);
        const std::size_t at = text.find(" Excludes:");
        if (at == std::string::npos) return text;
        std::vector<std::string> names;
        for (const CLI::Option* other : option->get_excludes())
            names.push_back(other->get_name());
        std::sort(names.begin(), names.end());
        text.resize(at);
        return text + fmt::format(" Excludes: {}", fmt::join(names, " "));
    }
};

}  // namespace

int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err,
        bool errIsTerminal) {
    CLI::App app(
        "Annotates two-player martial-arts motion capture: reads recordings, computes the contact\n"
        "force, cuts it into actions, keeps corrections, labels the actions, exports.",
        "kumite");
    app.formatter(std::make_shared<HelpFormatter>());
    app.require_subcommand(1);
    app.set_version_flag("--version", "kumite " KUMITE_VERSION);
    app.footer(
        "Frames count from 0 at the first frame of the take; A:B is half-open.\n"
        "`kumite COMMAND --help` shows each command with an example; `kumite --man` writes all of\n"
        "it as a manual page.");
    Action action;
    addDemo(app, action);
    addInfo(app, action);
    addJoints(app, action);
    addNew(app, action);
    addForce(app, action);
    addSegment(app, action);
    addCorrect(app, action);
    addExport(app, action);
    addLabel(app, action);
    addLabels(app, action);
    addModel(app, action);
    addWhy(app, action);
    addClusters(app, action);
    addTransition(app, action);
    addSequence(app, action);
    addHit(app, action);
    addKeyframes(app, action);
    addPart(app, action);
    addRate(app, action);
    addBout(app, action);
    addRelink(app, action);
    addVersions(app, action);

    if (arguments == std::vector<std::string>{"--man"}) {
        const auto helpOf = [](const std::vector<std::string>& words) {
            std::ostringstream text;
            run(words, text, text);
            return text.str();
        };
        std::vector<CommandHelp> commands;
        for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
            commands.push_back({command->get_name(), helpOf({command->get_name(), "--help"})});
        out << manualPage(KUMITE_VERSION, helpOf({"--help"}), commands);
        return 0;
    }
    try {
        const bool isWord = !arguments.empty() && !arguments.front().starts_with("-");
        const auto known = app.get_subcommands([](const CLI::App*) { return true; });
        const bool exists = std::any_of(known.begin(), known.end(), [&](const CLI::App* command) {
            return isWord && command->get_name() == arguments.front();
        });
        if (isWord && !exists) {
            throw UsageError("There is no command \"" + arguments.front() +
                             "\"; see kumite --help.");
        }
        // The parser takes its arguments last first.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
        action({out, err, errIsTerminal});
        out.flush();
        if (!out) throw Error("The result could not be written to standard output.");
        return 0;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error, out, err);  // --help, --version
        err << "kumite: " << error.what() << "; see --help.\n";
        return kWrongUsage;
    } catch (const UsageError& error) {
        err << "kumite: " << error.what() << "\n";
        return kWrongUsage;
    } catch (const std::exception& error) {
        err << "kumite: " << error.what() << "\n";
        return kFailed;
    }
}

}  // namespace kumite::cli
