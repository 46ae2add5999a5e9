#pragma once

namespace kumite::studio {

/// What the ruler counts.
enum class RulerUnits { Both, Time, Frames };

/// What the timeline shows beside force, boundaries and actions.
struct TimelineOptions {
    bool height = true;     ///< of the centre of mass
    bool rawForce = false;  ///< the force of the motion as recorded, behind the smoothed one
    bool handSpeed = false;
    bool footSpeed = false;
    RulerUnits ruler = RulerUnits::Both;

    bool operator==(const TimelineOptions&) const = default;
};

}  // namespace kumite::studio
