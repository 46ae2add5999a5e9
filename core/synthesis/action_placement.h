#pragma once

#include <Eigen/Core>

#include "core/interaction/action_parameters.h"
#include "core/motion/blend.h"

namespace kumite {

/// Where a body stands on the floor of the bout: its pelvis, metres, and its heading, radians.
struct Station {
    Eigen::Vector2d root = Eigen::Vector2d::Zero();  ///< x and z
    double yaw = 0;
};

/// The transform that moves what was recorded in the frame `recorded` into the frame `now`:
/// F · F′⁻¹ (method A9).
GroundTransform between(const GroundFrame& recorded, const GroundFrame& now);
/// A point and a heading under a transform.
Station moved(const Station& station, const GroundTransform& transform);
/// The transform that takes one station to another.
GroundTransform between(const Station& from, const Station& to);

/// How an action that begins stands in the scene (paper A, 5.1.2; method A9): it is recorded
/// relative to F′ and wants to be there relative to F, but has to begin where its fighter stands.
/// The correction that brings its first frame there is released smoothly from 1 to 1/2 over the
/// action: half way back at its last frame.
class ActionPlacement {
public:
    ActionPlacement() = default;
    /// `wanted`: F · F′⁻¹. `first`: the action's first frame as recorded. `shown`: where the
    /// fighter stands. `release`: how much of the correction has gone at the last frame.
    ActionPlacement(const GroundTransform& wanted, const Station& first, const Station& shown,
                    double release = 0.5);

    /// Where the frame recorded at `station` stands when a share `phase` of the action, 0 … 1, has
    /// been shown.
    Station at(const Station& station, double phase) const;
    /// The rigid transform of the recorded pose at that frame.
    GroundTransform transformAt(const Station& station, double phase) const {
        return between(station, at(station, phase));
    }
    /// Shifts the whole rest of the way: `shift` (metres) is reached smoothly between the phases.
    void steer(const Eigen::Vector2d& shift, double fromPhase, double toPhase);

    /// The correction at the first frame: how far and how much turned (metres, radians).
    double distance() const { return distance_; }
    double turn() const { return turn_; }

private:
    GroundTransform wanted_;
    GroundTransform shown_;  ///< of the recording, so that the first frame stands where shown
    double turn_ = 0;        ///< from wanted to shown, wrapped
    double distance_ = 0;
    double release_ = 0.5;
    Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();
    double steerFrom_ = 0;
    double steerTo_ = 1;
};

}  // namespace kumite
