#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/cli/library_options.h"
#include "core/cli/sequence_report.h"

namespace kumite::cli {

void addTransition(CLI::App& app, Action& action) {
    struct Options {
        LibraryOptions library;
        GraphOptions graph;
        TransitionOptions transition;
        std::string from, to, out;
        std::optional<int> path;
        bool json = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "transition", "Leads one action over to another and writes both with what lies between.");
    addLibraryOptions(*command, o->library);
    addGraphOptions(*command, o->graph);
    addTransitionOptions(*command, o->transition);
    command->add_option("--from", o->from, "the clip before")->required();
    command->add_option("--to", o->to, "the clip after")->required();
    command->add_option("--path", o->path, "this one of the candidate paths, counted from 0")
        ->check(CLI::NonNegativeNumber);
    command->add_option("--out", o->out, "the .bvh to write")->required();
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(std::string(kClipNames) +
                    "\nExample: kumite transition karate/ --from martial_04@300:480 --to "
                    "martial_06@90:400 --out x.bvh --json");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            const auto library = openLibrary(o->library, o->out, streams);
            const auto graph = openGraph(library, o->graph, streams);
            Sequence sequence = sequenceOf(*library, {o->from, o->to}, o->transition);
            sequence.blocks.back().transition.path = o->path;
            const SequenceMotion motion =
                makeSequence(graph, sequence, streams.progress("leading over"));
            writeClip(*library, motion.clip, o->out);
            if (o->json) {
                streams.out << transitionJson(motion) << "\n";
            } else {
                printSequence(*library, sequence, motion, streams);
            }
        };
    });
}

}  // namespace kumite::cli
