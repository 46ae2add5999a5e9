#pragma once

#include <functional>
#include <ostream>

#include <CLI/CLI.hpp>

#include "core/base/error.h"
#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/project/analysis.h"

namespace kumite::cli {

/// Where a command writes: results to `out`, findings, progress and errors to `err`.
struct Streams {
    std::ostream& out;
    std::ostream& err;
    bool errIsTerminal = false;

    /// Progress that shows on a terminal only: "reading 42 %", overwritten in place.
    Progress progress(const std::string& what) const;
};

/// Findings as lines "note: …" and "warning: …" on `err`.
void printFindings(const Findings& findings, const Streams& streams);

/// Wrong use of a command that the option parser cannot see (exit code 2).
class UsageError : public Error {
public:
    using Error::Error;
};

/// What a parsed command does; it throws to fail.
using Action = std::function<void(const Streams&)>;

// One per subcommand: adds it to the parser; `action` is set when it was chosen.
void addClusters(CLI::App& app, Action& action);
void addBout(CLI::App& app, Action& action);
void addDemo(CLI::App& app, Action& action);
void addInfo(CLI::App& app, Action& action);
void addJoints(CLI::App& app, Action& action);
void addModel(CLI::App& app, Action& action);
void addNew(CLI::App& app, Action& action);
void addForce(CLI::App& app, Action& action);
void addHit(CLI::App& app, Action& action);
void addRate(CLI::App& app, Action& action);
void addKeyframes(CLI::App& app, Action& action);
void addSegment(CLI::App& app, Action& action);
void addCorrect(CLI::App& app, Action& action);
void addExport(CLI::App& app, Action& action);
void addLabel(CLI::App& app, Action& action);
void addLabels(CLI::App& app, Action& action);
void addRelink(CLI::App& app, Action& action);
void addSequence(CLI::App& app, Action& action);
void addTransition(CLI::App& app, Action& action);
void addVersions(CLI::App& app, Action& action);
void addWhy(CLI::App& app, Action& action);

/// A project with all that follows from it; findings are printed.
struct OpenProject {
    Project project;
    Analysis analysis;
    std::string path;     ///< of the project file
    bool isDemo = false;  ///< none was named
};
/// Opens a project; an empty path means the demo bout, which is made for it.
OpenProject openProject(const std::string& path, const Streams& streams);

/// Take name and player (1 or 2) as an address. Throws Error that says what there is. An empty
/// take name means the only take.
FighterAddress fighterNamed(const Project& project, const std::string& take, int player);

/// `A:B`, either end may be left out; -1 stands for an end that was. Throws UsageError.
FrameRange parseRange(const std::string& text);

}  // namespace kumite::cli
