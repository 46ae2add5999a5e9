#pragma once

#include <optional>

namespace kumite::studio {

/// A joint (or End Site) of a fighter of the shown take.
struct JointRef {
    int player = 0;
    int joint = 0;

    bool operator==(const JointRef&) const = default;
};

/// The measuring tool: the distance between two joints of one or both fighters.
struct Measuring {
    bool isOn = false;
    std::optional<JointRef> from;
    std::optional<JointRef> to;
    std::optional<JointRef> hovered;

    /// First click: from here; second: to here; the next begins anew. A click beside all joints
    /// begins anew without a joint.
    void click(const std::optional<JointRef>& joint) {
        if (!joint) {
            from.reset();
            to.reset();
        } else if (!from || to) {
            from = joint;
            to.reset();
        } else if (*joint != *from) {
            to = joint;
        }
    }
};

}  // namespace kumite::studio
