#include "core/project/notes.h"

namespace kumite {

std::string noteOf(std::span<const ActionNote> notes, const Segmentation& segmentation,
                   const Action& action) {
    std::string text;
    for (const ActionNote& note : notes) {
        const Action* owner = actionAt(segmentation, note.frame);
        if (owner == nullptr || !(*owner == action)) continue;
        text += (text.empty() ? "" : "; ") + note.text;
    }
    return text;
}

}  // namespace kumite
