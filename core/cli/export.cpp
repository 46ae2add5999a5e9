#include "core/project/export.h"
#include "core/base/files.h"
#include "core/cli/command.h"

namespace kumite::cli {

void addExport(CLI::App& app, Action& action) {
    struct Options {
        std::string project, take, out;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "export",
        "Writes a take: its motion (.bvh, one file per player; .glb or .npz, both in one), actions "
        "(.csv, .json) or labels (.eaf).");
    command->add_option("PROJECT", o->project, "a .kumite file; none: the demo bout");
    command->add_option("--take", o->take, "name of the take; may be left out if there is one");
    command->add_option("--out", o->out, "file to write; its suffix says what")->required();
    command->footer(
        "A .bvh keeps the joints and channels of the recording; -1 and -2 are put before the "
        "suffix.\nA .glb (glTF 2.0, for Blender and others) and a .npz (numpy: positions, "
        "rotations, "
        "names, parents, rate, start;\nplayer 2 with _2 behind each name) show the fighters as "
        "placed, in metres, y up.\nExample: kumite export bout.kumite --take round1 --out "
        "actions.csv");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            const OpenProject open = openProject(o->project, streams);
            refuseToOverwrite(o->out, {open.path});
            const int take = fighterNamed(open.project, o->take, 1).take;
            for (const auto& file : exportTake(open.project, open.analysis, take, o->out)) {
                streams.out << file.string() << "\n";
            }
        };
    });
}

}  // namespace kumite::cli
