#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/transition/transition_synthesis.h"

namespace kumite {

/// What an author puts next: an action of the library, or motion that was made for the occasion,
/// such as a strike that hits a given target. Transitions use its first and last pose alike.
struct SequenceBlock {
    std::string name;
    LibraryAction action;
    std::shared_ptr<const LibraryMotion> made;  ///< instead, on the library's rig, at its rate
    std::optional<FrameRange> trim;             ///< of the action's frames; nothing: all
    int repeats = 1;
    TransitionRequest transition;  ///< how it is reached, from the block before or from its own end
};

/// Actions in an order, and how they follow each other.
struct Sequence {
    std::vector<SequenceBlock> blocks;
    TransitionSettings transitions;
    bool cleanFeet = true;  ///< standing feet stay put (foot_lock.h), over the whole motion
};

/// A stretch of a sequence's motion: a block, or the transition that leads to it. Pieces follow
/// each other without a gap.
struct SequencePiece {
    int block = 0;
    int repeat = 0;
    FrameRange frames;  ///< of the whole motion
    /// Of a transition, which may have no frame of its own (the actions meet).
    std::optional<TransitionReport> transition;
    int firstActionFrame = 0;  ///< of a block: the action's frame that is shown first
};

struct SequenceMotion {
    Clip clip;
    std::vector<SequencePiece> pieces;

    std::vector<int> joins() const;  ///< all frames where two motions meet, in order
};

/// The whole as one motion. The same sequence gives the same motion; a transition depends on its
/// own request and the motion before it alone. Throws Error (an empty sequence, a block or a path
/// that is not there), Cancelled.
SequenceMotion makeSequence(std::shared_ptr<const FlexibleGraph> graph, const Sequence& sequence,
                            const Progress& progress = {});

}  // namespace kumite
