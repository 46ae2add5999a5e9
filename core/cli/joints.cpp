#include <fmt/format.h>

#include "core/base/files.h"
#include "core/cli/command.h"
#include "core/cli/conventions.h"
#include "core/formats/recording.h"
#include "core/formats/tables.h"
#include "core/motion/survey.h"

namespace kumite::cli {

void addJoints(CLI::App& app, Action& action) {
    struct Options {
        std::string file, asf, root, out, frames, units, up;
        bool endSites = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "joints", "World positions of all joints, metres, y up, of the untrimmed file.");
    command->add_option("FILE", o->file, "a .bvh or .amc file")->required();
    command->add_option("--out", o->out, "table to write: frame,joint,x,y,z")->required();
    command->add_option("--frames", o->frames, "frames A:B of the file; default: all");
    command->add_option("--asf", o->asf, "skeleton of an .amc; default: the only one beside it");
    command->add_option("--root", o->root, "which skeleton, where a file holds several");
    command->add_option("--units", o->units, kUnitsHelp);
    command->add_option("--up", o->up, "axis that points up: y or z; default: found");
    command->add_flag("--end-sites", o->endSites, "write the End Sites, too");
    command->footer("Example: kumite joints kick.bvh --out kick.csv --frames 100:200");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            SurveyOverrides overrides;
            if (!o->units.empty()) overrides.metresPerUnit = parseUnits(o->units);
            if (!o->up.empty()) overrides.up = parseUp(o->up);
            FrameRange frames = o->frames.empty() ? FrameRange{0, -1} : parseRange(o->frames);
            ReadOptions read;
            if (!o->asf.empty()) read.asf = o->asf;
            const Recording recording = readRecording(o->file, read, streams.progress("reading"));
            refuseToOverwrite(o->out, {o->file, recording.asf});
            const auto motion = motionOfRoot(recording, o->root);
            if (frames.end < 0) frames.end = motion->frameCount;
            if (frames.end > motion->frameCount || frames.empty()) {
                throw Error(fmt::format("{}: holds frames 0:{}; frames {} are not there.", o->file,
                                        motion->frameCount, o->frames));
            }
            const Survey survey = surveyMotion(*motion, overrides);
            printFindings(recording.findings, streams);
            const JointPositions positions =
                forwardKinematics(*motion, frames, survey.space, streams.progress("computing"));
            writeFileAtomically(
                o->out, jointPositionsCsv(*motion->skeleton, positions, frames.begin, o->endSites));
        };
    });
}

}  // namespace kumite::cli
