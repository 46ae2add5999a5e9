#pragma once

#include <array>

#include "core/motion/foot_lock.h"
#include "core/motion/two_bone.h"

namespace kumite {

/// What the feet do while one action becomes the next: a foot that stands in both is held where it
/// is, unless it would have to be far from where the next action has it; every other foot steps
/// over, lifted by so much as it has to go, and stands only when it has arrived. Without this it
/// would slide there just above the floor. Knees and elbows are kept from folding farther than
/// they can, which what is left of the old pose and a fast new one together would have them do. A
/// value.
class JoinSteps {
public:
    JoinSteps() = default;
    /// At the join the pose is `shown` in the motion that ends and `next` in the one that follows;
    /// feet stand in them as given. `seconds`: how long the join takes.
    JoinSteps(const Rig& rig, const Pose& shown, const Pose& next, Standing standsNow,
              Standing standsNext, double seconds);

    /// Mends the limbs of a joined pose, `seconds` after the join, and says which feet do not stand
    /// yet.
    void apply(const Rig& rig, Pose& pose, Standing& standing, double seconds) const;
    bool over(double seconds) const { return seconds >= seconds_; }

private:
    struct Step {
        std::optional<Limb> leg;  ///< nothing: the foot does not step
        double height = 0;        ///< metres, in the middle of the step
    };
    std::array<Step, 2> steps_;
    struct Hinge {
        int joint = -1;
        double side = 1;  ///< of the quaternions' sphere on which its turns lie
    };
    std::vector<Hinge> hinges_;  ///< knees and elbows
    double seconds_ = 0;
};

}  // namespace kumite
