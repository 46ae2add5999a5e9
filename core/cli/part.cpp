#include <fmt/format.h>

#include "core/cli/library_options.h"
#include "core/editing/part_edit.h"
#include "core/project/library.h"

namespace kumite::cli {
namespace {

struct Options {
    LibraryOptions library{{}, 60};
    std::string take, from, part, out;
    double ease = PartEdit{}.ease;
    bool adjusted = false;
};

void runPart(const Options& o, const Streams& streams) {
    const auto part = partFromName(o.part);
    if (!part) {
        throw UsageError("\"" + o.part +
                         "\": expected left_arm, right_arm, left_leg, right_leg or trunk.");
    }
    const auto library = openLibrary(o.library, o.out, streams);
    const LibraryAction take = actionNamed(*library, o.take);
    const LibraryAction from = actionNamed(*library, o.from);
    const auto clipOf = [&](const LibraryAction& action) -> const Clip& {
        return library->motions[static_cast<std::size_t>(action.motion)].clip;
    };
    PartEdit edit;
    edit.frames = take.frames;
    edit.part = *part;
    edit.sourceBegin = from.frames.begin;
    edit.sourceEnd = from.frames.end - 1;
    edit.ease = o.ease;
    edit.adjusted = o.adjusted;
    const Clip result = withPart(clipOf(take), clipOf(from), edit);
    writeClip(*library, result, o.out);
    streams.out << fmt::format("{} of {} frames have another {}, at {:g} Hz.\n", edit.frames.size(),
                               result.frameCount(), o.part, result.rate);
}

}  // namespace

void addPart(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "part", "Replaces one part of the body in a stretch of a take by another clip's.");
    addLibraryOptions(*command, o->library);
    command->add_option("--take", o->take, "what is changed, with its frames: round1:1@120:260")
        ->required();
    command->add_option("--part", o->part, "left_arm, right_arm, left_leg, right_leg or trunk")
        ->required();
    command
        ->add_option("--from", o->from,
                     "clip or action that lends the part; another length is stretched")
        ->required();
    command->add_option("--out", o->out, "the .bvh to write: the whole take")->required();
    command->add_option("--ease", o->ease, "seconds at both ends in which the part changes over")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command->add_flag("--adjusted", o->adjusted,
                      "where the part hangs on the rest the take's mean and deviation stay");
    command->footer(
        "All other joints, and every frame outside of the stretch, stay as they are.\n"
        "Example: kumite part bout.kumite --take round1:1@120:260 --part right_arm --from "
        "round1:2@90:230 --out x.bvh");
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runPart(*o, streams); }; });
}

}  // namespace kumite::cli
