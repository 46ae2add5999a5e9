#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "core/motion/roles.h"
#include "core/project/edits.h"

namespace kumite {

/// A strike that is brought to a target, as it stands in a project: Project::drafts["hit"].
struct HitDraft {
    std::string strike;                     ///< as StrikeRequest has it; empty: the first there is
    std::optional<Eigen::Vector3d> target;  ///< striker's frame, metres; nothing: where it hits
    std::optional<Role> aim;                ///< the opponent's joint that `target` is
    double distance = 1.0;                  ///< of the opponent ahead of the striker, metres

    bool isEmpty() const { return strike.empty() && !target && !aim; }
    bool operator==(const HitDraft&) const = default;
};

std::string hitDraftText(const HitDraft& draft);
/// Throws InputError.
HitDraft parseHitDraft(std::string_view text, const std::string& file);

/// The project's draft; an empty one where there is none. Throws InputError.
HitDraft hitDraftOf(const Project& project);
/// An empty draft is none.
MaybeEdit setHitDraft(const Project& project, const HitDraft& draft, std::string edit);

}  // namespace kumite
