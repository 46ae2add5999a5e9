#pragma once

#include <array>
#include <vector>

#include "core/motion/overlap.h"
#include "core/motion/pose.h"
#include "core/motion/two_bone.h"

namespace kumite {

/// How bodies are kept out of each other.
struct SeparationSettings {
    /// Heights below which no foot point is moved, left and right, of both bodies; metres.
    std::array<std::array<double, 2>, 2> floor{};
    double allowed = 0.01;       ///< metres that solids may overlap: touching is no collision
    double farthestPush = 0.25;  ///< metres a body is pushed aside at most
    double farthestLimb = 0.25;  ///< metres a hand or foot is moved at most
    double limbSeconds = 0.07;   ///< in which a hand or foot goes where it is foreseen to have to
    double leftOver = 0.015;     ///< metres of overlap that may be left to that
    double fastestLimb = 4;      ///< m/s at which a hand or foot is moved at most beside that
    double pushSeconds = 0.06;   ///< in which a push is followed, and
    double calmSeconds = 0.25;   ///< in which it goes again
};

/// Keeps two bodies out of each other as it goes, as little as needed (method A9): trunks, heads
/// and thighs push the whole bodies apart, slowly and ahead of time; hands, forearms, shanks and
/// free feet stop at what they hit, by bending their limb (two_bone.h), as far as it is foreseen
/// without a jump, the rest at once. A standing leg is not moved. Limits: solids are those of
/// overlap.h; what is deeper than the settings allow stays so; nothing is known of momentum: a hit
/// moves nobody (the seam for physics is here).
class Separation {
public:
    Separation() = default;
    explicit Separation(const std::array<std::shared_ptr<const Rig>, 2>& rigs, double rate,
                        const SeparationSettings& settings = {});

    /// Which feet stand, left and right, of both bodies.
    using Stands = std::array<std::array<bool, 2>, 2>;
    /// Where the bodies are going: poses that will be shown later, not pushed: `ahead` for pushes,
    /// `soon` for hands and feet, which are moved faster.
    void foresee(const std::array<const Pose*, 2>& ahead, const std::array<const Pose*, 2>& soon,
                 const Stands& standing);
    /// By how much a body is shifted in the frame that follows, metres, level.
    const Eigen::Vector3d& push(int player) const {
        return pushes_[static_cast<std::size_t>(player)].at;
    }
    /// Takes hands and feet out of the other body. `joints` are those of the poses, before and
    /// after. `standing`: feet that stay where they are, left and right.
    void part(std::array<Pose*, 2> poses, std::array<JointFrames*, 2> joints,
              const Stands& standing);

private:
    static constexpr std::size_t kLimbs = 4;  ///< left and right arm, left and right leg
    /// Something that follows a target as a critically damped spring: no jump in place or speed.
    struct Spring {
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        Eigen::Vector3d speed = Eigen::Vector3d::Zero();

        void follow(const Eigen::Vector3d& target, double seconds, double dt);
    };
    using Ways = std::array<std::array<Eigen::Vector3d, kLimbs>, 2>;
    struct Body {
        std::shared_ptr<const Rig> rig;
        std::array<std::optional<Limb>, kLimbs> limbs;
        std::array<Spring, kLimbs> moved;             ///< of the limbs' ends, as foreseen
        std::array<Eigen::Vector3d, kLimbs> extra{};  ///< what had to be added in the last frame
    };

    Ways waysOut(double allowed, const Stands& standing) const;
    void move(std::size_t body, Pose& pose, JointFrames& joints,
              const std::array<Eigen::Vector3d, kLimbs>& ways) const;

    SeparationSettings settings_;
    double rate_ = 60;
    std::array<Body, 2> bodies_;
    std::array<Spring, 2> pushes_;
    // Kept for their memory.
    std::array<JointFrames, 2> frames_;
    std::array<std::vector<BodyCapsule>, 2> solids_;
};

}  // namespace kumite
