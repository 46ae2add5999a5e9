#include "core/cli/library_options.h"
#include "core/cli/sequence_report.h"
#include "core/project/sequence_draft.h"

namespace kumite::cli {
namespace {

/// The sequence that one of the sources, a project, holds.
SequenceDraft draftOf(const LibraryOptions& options) {
    if (const auto project = projectWithDraft(options, "sequence"))
        return sequenceDraftOf(*project);
    throw UsageError(
        "Nothing to play: name clips with --play, or a project that holds a sequence.");
}

}  // namespace

void addSequence(CLI::App& app, Action& action) {
    struct Options {
        LibraryOptions library;
        GraphOptions graph;
        TransitionOptions transition;
        std::vector<std::string> play;
        std::string out;
        bool json = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "sequence", "Plays actions one after the other in any order, as one motion.");
    addLibraryOptions(*command, o->library);
    addGraphOptions(*command, o->graph);
    addTransitionOptions(*command, o->transition);
    command->add_option("--play", o->play,
                        "the clips, in order; without it: the sequence that a LIB, then a project, "
                        "holds");
    command->add_option("--out", o->out, "the .bvh to write")->required();
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(std::string(kClipNames) +
                    " NAME@x,y,z is a strike made to hit that\ntarget (see kumite "
                    "hit).\nExample: kumite sequence bout.kumite --play round1:1:3 round1:2:7 "
                    "round1:1:12 --out x.bvh");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            const auto library = openLibrary(o->library, o->out, streams);
            const auto graph = openGraph(library, o->graph, streams);
            const Sequence sequence = o->play.empty()
                                          ? sequenceOf(*library, draftOf(o->library))
                                          : sequenceOf(*library, o->play, o->transition);
            const SequenceMotion motion =
                makeSequence(graph, sequence, streams.progress("playing"));
            writeClip(*library, motion.clip, o->out);
            if (o->json) {
                streams.out << sequenceJson(sequence, motion) << "\n";
            } else {
                printSequence(*library, sequence, motion, streams);
            }
        };
    });
}

}  // namespace kumite::cli
