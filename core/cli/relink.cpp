#include "core/cli/command.h"
#include "core/formats/recording.h"
#include "core/project/edits.h"
#include "core/project/import.h"
#include "core/project/project_file.h"

namespace kumite::cli {

void addRelink(CLI::App& app, Action& action) {
    struct Options {
        std::string project, take, file, asf;
        int player = 1;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "relink", "Points a fighter to where its recording is now, or accepts a changed one.");
    command->add_option("PROJECT", o->project, "a .kumite file")->required();
    command->add_option("--take", o->take, "name of the take; may be left out if there is one");
    command->add_option("--player", o->player, "1 or 2")->check(CLI::Range(1, 2));
    command->add_option("--file", o->file, "the recording")->required();
    command->add_option("--asf", o->asf, "skeleton of an .amc; default: the only one beside it");
    command->footer(
        "Example: kumite relink bout.kumite --take round1 --player 2 --file moved/blue.bvh");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            LoadedProject loaded = loadProject(o->project, streams.progress("reading"));
            const FighterAddress fighter = fighterNamed(loaded.project, o->take, o->player);
            ReadOptions read;
            if (!o->asf.empty()) read.asf = o->asf;
            const Recording recording = readRecording(o->file, read, streams.progress("reading"));
            const RecordingRef ref =
                referTo(recording, o->file, fighterAt(loaded.project, fighter).recording.root);
            const auto edit =
                relinkRecording(loaded.project, fighter, ref, motionOfRoot(recording, ref.root));
            if (edit) printFindings(saveProject(edit->project, o->project), streams);
            streams.out << (edit ? edit->name : "Nothing to change.") << "\n";
        };
    });
}

}  // namespace kumite::cli
