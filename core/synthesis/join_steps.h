#pragma once

#include <array>

#include "core/motion/foot_lock.h"
#include "core/motion/two_bone.h"

namespace kumite {

/// A foot at a join, by its foot point (feet.h).
struct FootAtJoin {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< where it is seen, metres
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
    bool stands = false;
    /// Where the motion that follows has it, frame by frame from the join on, as far as planned.
    std::vector<Eigen::Vector3d> next;
    int landing = -1;  ///< frame of `next` in which it stands first; -1: in none
    int lift = 0;      ///< frame of `next` in which it stands no longer
};

/// What the feet do while one action becomes the next. A foot that stands in both is held where it
/// is, unless it would have to be far from where the next action has it. Every other foot that has
/// to go somewhere is guided from where it is seen to where the next action has it by then: one
/// that stands goes up, over and down, one in the air flies on; it arrives when the next action
/// sets it down, or later if the way is too long for that, and is kept off the floor until then. Of
/// two standing feet that both have to step one waits for the other. Without this feet would slide
/// to their places just above the floor. Knees and elbows are kept from folding farther than they
/// can, which what is left of the old pose and a fast new one together would have them do. A value.
class JoinSteps {
public:
    JoinSteps() = default;
    /// At the join the following motion shows `next`. `seconds`: how long the join takes. Frames of
    /// feet are those of `rate`; at least two of each are known.
    JoinSteps(const Rig& rig, const Pose& next, const std::array<FootAtJoin, 2>& feet, double rate,
              double seconds);
    /// Seconds of the following motion that may be of use.
    static double lookAhead();

    /// Whether a foot is guided from where it was seen: nothing else has to correct it.
    bool guides(std::size_t side) const { return steps_[side].leg.has_value(); }

    /// Mends the limbs of a joined pose, `seconds` after the join, and says which feet do not stand
    /// yet. `next` is the following motion by itself at that moment.
    void apply(const Rig& rig, Pose& pose, const Pose& next, Standing& standing,
               double seconds) const;
    bool over(double seconds) const { return seconds >= longest_; }

private:
    struct Step {
        std::optional<Limb> leg;  ///< nothing: the foot is not guided
        int point = -1;
        enum class Way {
            Over,   ///< from where it stands, up, over and down
            Joins,  ///< it flies: what it is beside the next motion goes before that sets it down
            Lands   ///< it flies, and there is no time for that: straight to where it will stand
        };
        Way way = Way::Over;
        Eigen::Vector3d from = Eigen::Vector3d::Zero();      ///< Over
        Eigen::Vector3d offset = Eigen::Vector3d::Zero();    ///< of one that flies, from where it
        Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< goes, and how fast that changes
        bool stops = false;                                  ///< comes to rest when it arrives,
        Eigen::Vector3d to = Eigen::Vector3d::Zero();        ///< there
        double floor = 0;                                    ///< metres, where it stands
        double height = 0;  ///< metres over it in the middle of the step
        double begin = 0;   ///< seconds after the join
        double end = 0;
    };
    void plan(Step& step, const FootAtJoin& foot, double rate) const;
    void aim(Step& step, const FootAtJoin& foot, double rate);

    std::array<Step, 2> steps_;
    struct Hinge {
        int joint = -1;
        double side = 1;  ///< of the quaternions' sphere on which its turns lie
    };
    std::vector<Hinge> hinges_;  ///< knees and elbows
    double seconds_ = 0;
    double longest_ = 0;  ///< seconds, of the join and all steps
};

}  // namespace kumite
