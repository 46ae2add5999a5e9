#include "core/base/files.h"
#include "core/cli/command.h"
#include "core/project/report.h"

namespace kumite::cli {

void addForce(CLI::App& app, Action& action) {
    struct Options {
        std::string project, take, out;
        int player = 1;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "force", "Contact force and smoothed centre of mass of one fighter, as a table.");
    command->add_option("PROJECT", o->project, "a .kumite file; none: the demo bout");
    command->add_option("--take", o->take, "name of the take; may be left out if there is one");
    command->add_option("--player", o->player, "1 or 2")->check(CLI::Range(1, 2));
    command->add_option("--out", o->out, "table to write")->required();
    command->footer(
        "Columns: frame,time,com_x,com_y,com_z,fx,fy,fz,norm (metres, y up; body weights).\n"
        "Example: kumite force bout.kumite --take round1 --player 2 --out force.csv");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            const OpenProject open = openProject(o->project, streams);
            const FighterAddress fighter = fighterNamed(open.project, o->take, o->player);
            std::vector<std::filesystem::path> sources = recordingFiles(open.project);
            sources.emplace_back(open.path);
            refuseToOverwrite(o->out, sources);
            writeFileAtomically(o->out, forceCsv(open.analysis.at(fighter)));
        };
    });
}

}  // namespace kumite::cli
