#include "core/transition/sequence.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace kumite {

namespace {

/// Frames that a block plays.
MotionPart partOf(const MotionLibrary& library, const SequenceBlock& block) {
    if (!block.made && block.action.motion >= static_cast<int>(library.motions.size()))
        throw Error(fmt::format("The block \"{}\" has no motion.", block.name));
    MotionPart part = block.made ? MotionPart{block.made->clip.frames, block.made->standing}
                                 : library.part(block.action);
    if (block.trim) {
        const FrameRange& trim = *block.trim;
        if (trim.begin < 0 || trim.empty() || trim.end > part.size()) {
            throw Error(fmt::format("Frames {}:{} cannot be taken from \"{}\", which has {}.",
                                    trim.begin, trim.end, block.name, part.size()));
        }
        part = part.part(trim);
    }
    if (part.empty()) throw Error(fmt::format("The block \"{}\" has no frame.", block.name));
    return part;
}

}  // namespace

std::vector<int> SequenceMotion::joins() const {
    std::vector<int> frames;
    for (const SequencePiece& piece : pieces) {
        if (!piece.transition) continue;
        for (const int join : piece.transition->joins) {
            while (!frames.empty() && frames.back() >= join)
                frames.pop_back();
            frames.push_back(join);
        }
    }
    return frames;
}

SequenceMotion makeSequence(std::shared_ptr<const FlexibleGraph> graph, const Sequence& sequence,
                            const Progress& progress) {
    if (sequence.blocks.empty()) throw Error("The sequence has no block.");
    const MotionLibrary& library = *graph->library;
    MotionStrip strip(graph, sequence.transitions);
    SequenceMotion motion;
    int whole = 0;
    for (const SequenceBlock& block : sequence.blocks)
        whole += std::max(1, block.repeats);
    int done = 0;
    for (std::size_t b = 0; b < sequence.blocks.size(); ++b) {
        const SequenceBlock& block = sequence.blocks[b];
        const MotionPart part = partOf(library, block);
        for (int repeat = 0; repeat < std::max(1, block.repeats); ++repeat, ++done) {
            progress.update(static_cast<double>(done) / whole);
            SequencePiece piece{static_cast<int>(b), repeat, {}, {}, 0};
            if (motion.pieces.empty()) {
                strip.begin(part);
            } else {
                // A transition leaves at least half of the block before it.
                FrameRange& before = motion.pieces.back().frames;
                MotionStrip::Led led =
                    strip.lead(part, block.transition, before.begin + before.size() / 2 + 1);
                before.end = std::min(led.transitionBegin, led.actionBegin);
                piece.frames = {before.end, led.actionBegin};
                piece.transition = std::move(led.report);
                motion.pieces.push_back(std::move(piece));
                piece = {static_cast<int>(b), repeat, {led.actionBegin, 0}, {}, led.actionEntered};
            }
            piece.frames.end = strip.frameCount();
            motion.pieces.push_back(std::move(piece));
        }
    }
    motion.clip = {library.rig, library.rate, strip.frames()};
    if (sequence.cleanFeet)
        motion.clip = withLockedFeet(motion.clip, strip.standing(), library.feet);
    return motion;
}

}  // namespace kumite
