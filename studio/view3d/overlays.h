#pragma once

namespace kumite::studio {

/// What the 3D view draws beside the bodies; the user's switches.
struct Overlays {
    bool contacts = true;
    bool trails = false;
    bool centreOfMass = true;
    bool force = true;
    bool ghosts = true;
    int trailBefore = 30;  ///< frames
    int trailAfter = 0;

    /// Limits of the trails' length, frames.
    static constexpr int kLongestTrail = 300;

    bool operator==(const Overlays&) const = default;
};

}  // namespace kumite::studio
