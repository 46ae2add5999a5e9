#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/synthesis/bout.h"

namespace kumite {

/// A bout that can be rewound: what was shown up to its end, and a head that stands somewhere on
/// it. Kept are commands, choices and a snapshot every few seconds; frames between are shown anew,
/// which gives the same frames.
class BoutTape {
public:
    /// `script`: commands for frames to come, in order of time. Throws Error, also for words of the
    /// script that mean nothing.
    BoutTape(std::shared_ptr<const BoutLibrary> library, const BoutSettings& settings,
             std::vector<BoutCommand> script = {});

    /// What is shown where the head stands.
    const Bout& now() const { return now_; }
    int frame() const { return now_.frame(); }
    /// The last frame that was shown; the head never stands behind it.
    int end() const { return end_; }
    const Bout& first() const { return snapshots_.front(); }

    /// Shows `frames` frames more; what lies behind the head is shown again, then new ones come.
    void advance(int frames);
    /// Puts the head on a frame that was shown (clamped).
    void seek(int frame);
    /// Forgets what was shown behind the head, and the commands given there. What comes then may
    /// be different only if something else is asked for.
    void cut();
    /// Cuts and gives a command at the head. Throws Error and changes nothing where it cannot be
    /// obeyed.
    void command(BoutCommand command);
    /// Cuts at a choice that was made, so that it is made again with this node.
    void chooseInstead(const BoutChoice& choice, int node);

    /// Those of all frames up to the end, in order.
    const std::vector<std::shared_ptr<const BoutChoice>>& choices() const { return choices_; }
    const std::vector<BoutCommand>& commands() const { return commands_; }

    /// Shows frames [0, end()] to somebody, one after the other, from the beginning, the head left
    /// where it is. Cancellable.
    void replay(const std::function<void(const Bout&)>& show, const Progress& progress = {}) const;

private:
    void stepOnce();

    Bout now_;
    int end_ = 0;
    std::vector<Bout> snapshots_;        ///< the first of frame 0; before any command of
                                         ///< their frame
    std::vector<BoutCommand> commands_;  ///< in order of frames
    std::size_t applied_ = 0;            ///< commands that the head has obeyed
    std::vector<std::shared_ptr<const BoutChoice>> choices_;
};

/// An action that a player showed.
struct ShownAction {
    int begin = 0;  ///< frames
    int end = 0;
    int action = -1;
    int node = kAnyNode;
    std::shared_ptr<const BoutChoice> choice;  ///< that began it; null: the start
};
/// Those of a player up to the end of a tape, in order; the last one goes on behind it.
std::vector<ShownAction> actionsShown(const BoutTape& tape, int player);

/// Everything that made the bout what it is, as JSON (schema: core/synthesis/README.md): the same
/// library, settings and commands give the same bout.
std::string boutLog(const BoutTape& tape);

/// Both fighters' motion over frames [0, end()] of a tape.
std::array<Clip, 2> boutClips(const BoutTape& tape, const Progress& progress = {});

}  // namespace kumite
