#include <fmt/format.h>

#include "core/base/files.h"
#include "core/cli/library_options.h"
#include "core/project/rating_page.h"

namespace kumite::cli {
namespace {

struct Options {
    LibraryOptions library{{}, 60};
    StrikeRequest request;
    RatingSettings settings;
    std::string out;
};

void runRate(const Options& o, const Streams& streams) {
    const auto library = openLibrary(o.library, o.out, streams);
    const RatedClips made =
        clipsToRate(*library, o.request, o.settings, streams.progress("making the clips"));
    printFindings(made.findings, streams);
    writeFileAtomically(
        o.out, ratingPage(made.clips, "Natural or not: " + o.request.strike, o.settings.seed));
    streams.out << fmt::format("{}: {} clips to rate\n", o.out, made.clips.size());
}

}  // namespace

void addRate(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("rate", "Writes a page on which people rate motions as natural or not.");
    addLibraryOptions(*command, o->library);
    command
        ->add_option("--strike", o->request.strike,
                     "the examples: an aspect (right_kick, right_kick:up) or clips, a,b,…")
        ->required();
    command->add_option("--player", o->request.player, "only fighter 1 or 2 of the projects' takes")
        ->check(CLI::Range(1, 2));
    command->add_option("--clips", o->settings.clipsPerKind, "of each kind")
        ->check(CLI::Range(1, 200))
        ->capture_default_str();
    command->add_option("--seed", o->settings.seed, "of targets, examples and order")
        ->capture_default_str();
    command->add_option("--out", o->out, "the .html to write")->required();
    command->footer(
        "The page shows clips in a drawn order: captured strikes, blends of whole bodies and by\n"
        "body parts at drawn targets, and motions made of five key poses of an example that is no\n"
        "source itself. Which is which is told at the end, with the share found natural of each\n"
        "kind and its 95 % interval; the answers can be saved as a table.\n"
        "Example: kumite rate bout.kumite --strike right_punch --out punches.html");
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runRate(*o, streams); }; });
}

}  // namespace kumite::cli
