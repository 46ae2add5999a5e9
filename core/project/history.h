#pragma once

#include <string>
#include <vector>

#include "core/project/edits.h"

namespace kumite {

/// Undo by snapshots: every step is a whole project and the name of the edit that made it. Not
/// thread-safe; it belongs to the thread that edits.
class History {
public:
    struct Step {
        Project project;
        std::string name;
    };

    explicit History(Project initial = {}, std::string name = "Open");

    const Project& current() const { return steps_[at_].project; }
    /// Makes the edit the current step; steps that were undone are gone.
    void commit(Edit edit);
    /// Makes the edit the current step instead of the one that is, as while a slider moves: one
    /// undo takes all of it back. Led back to the step before, there is no step. The first step
    /// cannot be amended.
    void amend(Edit edit);

    bool canUndo() const { return at_ > 0; }
    bool canRedo() const { return at_ + 1 < steps_.size(); }
    /// Name of the edit that undo would take back, or redo would bring back; empty if none.
    std::string undoName() const;
    std::string redoName() const;
    void undo();
    void redo();
    /// Goes to any step of `steps()`.
    void goTo(std::size_t step);

    const std::vector<Step>& steps() const { return steps_; }
    std::size_t position() const { return at_; }

    /// Whether the current step is the one last saved.
    bool isSaved() const { return saved_ == at_; }
    void markSaved() { saved_ = at_; }
    /// How many edits lie between what was last saved (or opened) and now.
    std::size_t editsSinceSaved() const;

private:
    static constexpr std::size_t kNever = static_cast<std::size_t>(-1);

    std::vector<Step> steps_;
    std::size_t at_ = 0;
    std::size_t saved_ = 0;
};

}  // namespace kumite
