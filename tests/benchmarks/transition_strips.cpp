// Film strips of transitions between real actions: kumite-transition-strips FOLDER. Writes SVGs:
// six actions in a row, kick to punch straight and on a curve (the paper's Fig. 11), a dodge that
// interrupts a walk (its Fig. 12).

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/project/film_strip.h"
#include "core/transition/playback.h"
#include "core/transition/sequence.h"
#include "tests/benchmarks/transition_corpus.h"

namespace {

using namespace kumite;
using namespace kumite::bench;

const LibraryMotion& motionNamed(const MotionLibrary& library, const std::string& name) {
    for (const LibraryMotion& motion : library.motions) {
        if (motion.name == name) return motion;
    }
    throw Error("There is no recording " + name + ".");
}

/// Height of a joint (or its horizontal distance from the root, whichever is asked for) per frame.
enum class Measure { Height, Reach };

/// The frame at which a joint is highest, or reaches farthest; `lowest` reverses it.
int peakOf(const LibraryMotion& motion, Role role, Measure measure, FrameRange within = {0, -1},
           bool lowest = false) {
    const JointPositions positions = positionsOf(motion.clip);
    const int joint = motion.clip.rig->roles[role].value();
    const int end = within.end < 0 ? positions.frameCount - 20 : within.end;
    int best = -1;
    double most = 0;
    for (int frame = std::max(20, within.begin); frame < end; ++frame) {
        const Eigen::Vector3f at = positions.at(frame, joint);
        const Eigen::Vector3f root = positions.at(frame, 0);
        double value =
            measure == Measure::Height ? at.y() : std::hypot(at.x() - root.x(), at.z() - root.z());
        if (lowest) value = -value;
        if (best >= 0 && value <= most) continue;
        most = value;
        best = frame;
    }
    return best;
}

LibraryAction stretch(const MotionLibrary& library, const LibraryMotion& motion, int begin,
                      int end) {
    const int index = static_cast<int>(&motion - library.motions.data());
    return {motion.name, "", index, {std::max(0, begin), std::min(motion.clip.frameCount(), end)}};
}

FilmRow rowOf(const std::string& title, const Clip& clip, FrameRange frames, int count,
              const std::string& colour) {
    FilmRow row{title, {}};
    for (const int frame : evenFrames(frames, std::min(count, std::max(1, frames.size()))))
        row.pictures.push_back({std::to_string(frame), {{&clip, frame, colour, 1}}, {}});
    return row;
}

constexpr const char* kRecorded = "#4878b0";
constexpr const char* kMade = "#c07020";

void write(const std::filesystem::path& path, const std::string& title,
           const std::vector<FilmRow>& rows) {
    FilmSettings settings;
    settings.view = FilmView::ThreeQuarter;
    writeFileAtomically(path, filmStripSvg(title, rows, settings));
    std::cout << path.string() << "\n";
}

void sixActions(std::shared_ptr<const FlexibleGraph> graph, const std::filesystem::path& folder) {
    const MotionLibrary& library = *graph->library;
    const LibraryMotion& kicks = motionNamed(library, "martial_04");
    const LibraryMotion& hands = motionNamed(library, "martial_06");
    const LibraryMotion& punches = motionNamed(library, "02_05");
    const LibraryMotion& jumps = motionNamed(library, "49_02");
    const LibraryMotion& boxing = motionNamed(library, "Boxing_Toes");
    const auto around = [&](const LibraryMotion& motion, int frame, int before, int after) {
        return stretch(library, motion, frame - before, frame + after);
    };
    const std::vector<std::pair<std::string, LibraryAction>> actions = {
        {"left kick", around(kicks, peakOf(kicks, Role::LeftAnkle, Measure::Height), 18, 18)},
        {"punch", around(punches, peakOf(punches, Role::RightWrist, Measure::Reach), 15, 15)},
        {"jump", around(jumps, peakOf(jumps, Role::Pelvis, Measure::Height), 15, 15)},
        {"boxing",
         around(boxing, peakOf(boxing, Role::LeftWrist, Measure::Reach, {0, 500}), 15, 15)},
        {"karate hand", around(hands, peakOf(hands, Role::RightWrist, Measure::Reach), 15, 15)},
        {"right kick", around(kicks, peakOf(kicks, Role::RightAnkle, Measure::Height), 18, 18)}};
    Sequence sequence;
    for (const auto& [name, action] : actions) {
        SequenceBlock& block = sequence.blocks.emplace_back();
        block.name = name;
        block.action = action;
        block.transition.seed = sequence.blocks.size();
    }
    const SequenceMotion motion = makeSequence(graph, sequence);
    std::vector<FilmRow> rows;
    for (const SequencePiece& piece : motion.pieces) {
        const std::string& name = sequence.blocks[static_cast<std::size_t>(piece.block)].name;
        const FrameRange frames{std::max(0, piece.frames.begin - 1), piece.frames.end};
        if (!piece.transition) {
            rows.push_back(rowOf(name, motion.clip, piece.frames, 9, kRecorded));
        } else {
            rows.push_back(rowOf(fmt::format("to {}: {}, {} frames, clusters {}", name,
                                             methodName(piece.transition->method),
                                             piece.frames.size(), piece.transition->visited.size()),
                                 motion.clip, frames, 9, kMade));
        }
    }
    write(folder / "six-actions.svg", "Six real actions in an order nobody recorded", rows);
}

void kickToPunch(std::shared_ptr<const FlexibleGraph> graph, const std::filesystem::path& folder) {
    const MotionLibrary& library = *graph->library;
    const LibraryMotion& kicks = motionNamed(library, "martial_04");
    const LibraryMotion& punches = motionNamed(library, "02_05");
    const int kick = peakOf(kicks, Role::LeftAnkle, Measure::Height);
    const int punch = peakOf(punches, Role::RightWrist, Measure::Reach);
    std::vector<FilmRow> rows;
    std::vector<SequenceMotion> motions;
    for (const auto method : {TransitionMethod::Linear, TransitionMethod::Bezier}) {
        Sequence sequence;
        sequence.blocks.resize(2);
        sequence.blocks[0].action = stretch(library, kicks, kick - 15, kick + 1);
        sequence.blocks[1].action = stretch(library, punches, punch, punch + 15);
        sequence.blocks[1].transition.method = method;
        motions.push_back(makeSequence(graph, sequence));
    }
    for (const SequenceMotion& motion : motions) {
        const SequencePiece& piece = motion.pieces[1];
        const FrameRange frames{piece.frames.begin - 1, piece.frames.end + 1};
        rows.push_back(rowOf(
            fmt::format("{}, {} frames", methodName(piece.transition->method), piece.frames.size()),
            motion.clip, frames, 10, kMade));
    }
    write(folder / "kick-to-punch.svg", "From a kick to a punch: straight, and on a curve", rows);
}

void dodge(std::shared_ptr<const FlexibleGraph> graph, const std::filesystem::path& folder) {
    const MotionLibrary& library = *graph->library;
    const LibraryMotion& walk = motionNamed(library, "60_01");
    const LibraryMotion& deep = motionNamed(library, "martial_06");
    const int low = peakOf(deep, Role::Pelvis, Measure::Height, {60, -1}, true);
    PlaybackBuffer buffer(graph);
    buffer.play(library.part(stretch(library, walk, 60, 150)));
    Clip shown{library.rig, library.rate, {}};
    for (int i = 0; i < 40; ++i)
        shown.frames.push_back(buffer.next());
    const TransitionReport report =
        buffer.play(library.part(stretch(library, deep, low - 10, low + 20)));
    while (buffer.planned() > 0)
        shown.frames.push_back(buffer.next());
    write(folder / "dodge.svg", "A dodge interrupts a walk",
          {rowOf("walking, told to dodge at frame 39", shown, {0, 40}, 10, kRecorded),
           rowOf(fmt::format("{}", methodName(report.method)), shown, {39, shown.frameCount()}, 12,
                 kMade)});
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: kumite-transition-strips FOLDER\n";
        return 2;
    }
    try {
        auto library = recordings();
        if (!library) throw Error("There are no recordings: set KUMITE_DATA.");
        std::filesystem::create_directories(argv[1]);
        const auto graph =
            buildFlexibleGraph(std::make_shared<const MotionLibrary>(std::move(*library)));
        std::cout << fmt::format("{} clusters, {} edges\n", graph->clusters.count(),
                                 graph->graph.edges.size());
        sixActions(graph, argv[1]);
        kickToPunch(graph, argv[1]);
        dodge(graph, argv[1]);
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
