#pragma once

#include <array>
#include <span>

#include "core/motion/contacts.h"
#include "core/motion/pose.h"
#include "core/motion/two_bone.h"

namespace kumite {

/// How planted feet are kept where they are.
struct FootLockSettings {
    /// Heights of the left and right foot point (see `footPoint`) when that foot stands flat: no
    /// foot point is shown lower. Metres.
    std::array<double, 2> floor = {0.0, 0.0};
    double ease = 0.12;         ///< seconds in which a foot comes to rest and is let go again
    double lookAhead = 0.15;    ///< seconds of the future that may be used
    double farthest = 0.25;     ///< metres: a motion that leaves its foot farther behind drags it
    double onToes = 0.03;       ///< metres over the floor on which a foot may stand, on its toes
    double highestSink = 0.06;  ///< metres by which one that floats higher is brought down at most
    double hipsDrop = 0.06;     ///< metres by which the hips may lower so that legs reach
    Stretch stretch;            ///< of the legs; a motion's own stretch is never forbidden

    bool operator==(const FootLockSettings&) const = default;
};

/// Which feet stand: left, right.
using Standing = std::array<bool, 2>;

/// Feet that stay put, frame by frame: where a foot begins to stand its foot point is held at the
/// place where it is shown then (it comes to rest within `ease`, as its speed has it), the ankle
/// follows with the foot's own turn, the leg bends (two_bone.h), and where legs do not reach the
/// hips lower a little. When the foot no longer stands, what was corrected is let go within `ease`.
/// How far a floating foot has to come down is seen ahead, and the hips begin to lower before they
/// have to, as far as the future is known. A foot's height is its own (it may stand on its toes)
/// but for that and the floor. Every frame has the same cost; a value, so that a stream can go back
/// to it.
class FootLock {
public:
    FootLock(std::shared_ptr<const Rig> rig, double rate, const FootLockSettings& settings = {});

    /// The pose to show for `ahead[0]`. `ahead` are the frame to show and those planned after it,
    /// as far as they are known and useful (`useful()`); `standing` goes with them.
    Pose show(std::span<const Pose> ahead, std::span<const Standing> standing);
    /// Frames, the one to show with them, beyond which knowing the future changes nothing.
    int useful() const { return useful_; }
    /// By how much the foot point was moved in the frame shown last, metres.
    Eigen::Vector3d correction(bool left) const { return feet_[left ? 0 : 1].shown; }
    /// The motion itself goes on from where that foot was shown last: nothing is left to correct.
    void settle(bool left);
    /// By how much the hips were lowered in the frame shown last, metres.
    double drop() const { return drop_; }

private:
    struct Foot {
        std::optional<Limb> leg;
        int point = -1;
        std::vector<int> chain;  ///< from joint 0 down to the point
        bool locked = false;
        Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< over which place it is held
        double sink = 0;  ///< by how much it is brought down while it is held, metres
        /// What is left of the correction at the last change between locked and free.
        Eigen::Vector3d offset = Eigen::Vector3d::Zero();
        Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
        double since = 0;  ///< seconds since that change
        Eigen::Vector3d shown = Eigen::Vector3d::Zero();
        Eigen::Vector3d shownBefore = Eigen::Vector3d::Zero();
        Eigen::Vector3d rawBefore = Eigen::Vector3d::Zero();
    };

    /// Places of a leg's joints and of its foot point.
    struct Leg {
        Eigen::Vector3d hip, knee, ankle, point;
    };

    Leg legOf(const Foot& foot, const Pose& pose) const;
    Eigen::Vector3d heldCorrection(const Foot& foot, std::size_t side,
                                   const Eigen::Vector3d& raw) const;
    void change(Foot& foot, std::size_t side, const Eigen::Vector3d& raw,
                std::span<const Pose> ahead, std::span<const Standing> standing);
    Eigen::Vector3d correctionOf(Foot& foot, std::size_t side, std::span<const Pose> ahead,
                                 std::span<const Standing> standing);
    double dropFor(std::span<const Pose> ahead, std::span<const Standing> standing);

    std::shared_ptr<const Rig> rig_;
    double rate_;
    FootLockSettings settings_;
    int useful_ = 1;
    std::array<Foot, 2> feet_;
    double drop_ = 0;
    bool started_ = false;
    JointFrames frames_;  ///< kept for its memory
};

/// When the feet of a clip stand (contacts.h), frame by frame.
std::vector<Standing> standingOf(const Clip& clip, const ContactSettings& settings = {});

/// The whole clip through `FootLock`.
Clip withLockedFeet(const Clip& clip, std::span<const Standing> standing,
                    const FootLockSettings& settings);
/// With the contacts and the rest heights (feet.h) that the clip itself shows.
Clip withLockedFeet(const Clip& clip);

}  // namespace kumite
