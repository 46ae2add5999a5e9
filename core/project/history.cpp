#include "core/project/history.h"

#include <cassert>

namespace kumite {

History::History(Project initial, std::string name) {
    steps_.push_back({std::move(initial), std::move(name)});
}

void History::commit(Edit edit) {
    if (saved_ != kNever && saved_ > at_) saved_ = kNever;
    steps_.resize(at_ + 1);
    steps_.push_back({std::move(edit.project), std::move(edit.name)});
    ++at_;
}

void History::amend(Edit edit) {
    assert(at_ > 0);
    if (saved_ != kNever && saved_ >= at_) saved_ = kNever;
    steps_.resize(at_ + 1);
    if (edit.project == steps_[at_ - 1].project) {
        steps_.pop_back();
        --at_;
    } else {
        steps_[at_] = {std::move(edit.project), std::move(edit.name)};
    }
}

std::string History::undoName() const {
    return canUndo() ? steps_[at_].name : std::string();
}

std::string History::redoName() const {
    return canRedo() ? steps_[at_ + 1].name : std::string();
}

void History::undo() {
    if (canUndo()) --at_;
}

void History::redo() {
    if (canRedo()) ++at_;
}

std::size_t History::editsSinceSaved() const {
    if (saved_ == kNever) return at_;
    return saved_ > at_ ? saved_ - at_ : at_ - saved_;
}

void History::goTo(std::size_t step) {
    assert(step < steps_.size());
    at_ = step;
}

}  // namespace kumite
