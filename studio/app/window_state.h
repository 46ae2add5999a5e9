#pragma once

#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/project/analysis.h"
#include "core/project/history.h"
#include "studio/app/findings_page.h"
#include "studio/app/session.h"

namespace kumite::studio {

class ProjectLock;

/// What a window hands to the one that takes its place.
struct WindowState {
    struct Opened {
        History history;
        Analysis analysis;
        QString path;
        bool unsaved = false;  ///< other than the history tells
        std::string onDisk;
        std::shared_ptr<ProjectLock> lock;
        int take = 0;
        int activePlayer = 0;
        double playhead = 0;
        TimeSpan visible;
        std::optional<BoundaryRef> selection;
        std::optional<ActionRef> selectedAction;
        std::vector<FoundInFiles> findings;
    };
    std::optional<Opened> opened;  ///< nothing: no project is open
};

}  // namespace kumite::studio
