#include <memory>

#include <fmt/format.h>

#include "core/cli/command.h"
#include "core/project/demo_bout.h"

namespace kumite::cli {

void addDemo(CLI::App& app, Action& action) {
    struct Options {
        std::string out;
        demo::DemoSettings settings;
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "demo",
        "Makes a bout of two fighters with known truth: player1.bvh, player2.bvh, truth.json and\n"
        "demo.kumite. The same seed makes the same files; another rate the same fight.\n"
        "Example: kumite demo --out demo --seconds 300 --seed 4");
    command->add_option("--out", options->out, "folder for the files")->required();
    command->add_option("--seconds", options->settings.seconds, "length")->capture_default_str();
    command->add_option("--fps", options->settings.rate, "frames a second, 24 to 240")
        ->capture_default_str();
    command->add_option("--seed", options->settings.seed, "which bout")->capture_default_str();
    command->callback([options, &action] {
        action = [options](const Streams& streams) {
            const DemoFiles files =
                writeDemoBout(options->settings, options->out, streams.progress("making the bout"));
            streams.out << files.project().string() << "\n";
        };
    });
}

}  // namespace kumite::cli
