#pragma once

#include <memory>
#include <vector>

#include "core/motion/contacts.h"
#include "core/project/project.h"
#include "core/segmentation/centre_of_mass.h"
#include "core/segmentation/segmentation.h"
#include "core/segmentation/suspicion.h"

namespace kumite {

/// Stage 1: where the joints are. Depends on motion, frames and space.
struct FighterMotion {
    JointPositions positions;  ///< metres, y up, the file's space (not placed)
};

/// Stage 2: what needs roles. Depends on stage 1, roles, body model, rate, floor and contact
/// thresholds.
struct FighterBody {
    CentreOfMass com;
    double floor = 0;              ///< metres, in the file's space
    std::vector<float> footSpeed;  ///< of the faster foot, m/s; empty without feet
    FootContacts contacts;
    std::vector<double> heading;  ///< radians, unwrapped, in the file's space
};

/// Stage 3: force and its minima. Depends on stage 2, rate, cutoff and curve.
struct FighterForce {
    ContactForce force;
    std::vector<ForceMinimum> minima;
};

/// All derived values of one fighter. Null stages: the recording is missing.
/// Stages (but for the suspicion, which is always new) are shared between one analysis and the next
/// as long as their inputs stay equal, so that an unchanged pointer means unchanged values.
struct FighterAnalysis {
    Fighter input;  ///< what the values were made from
    std::shared_ptr<const FighterMotion> motion;
    std::shared_ptr<const FighterBody> body;
    std::shared_ptr<const FighterForce> force;
    std::shared_ptr<const Segmentation> segmentation;
    std::shared_ptr<const Suspicion> suspicion;  ///< one per minimum
    /// Why; one per minimum.
    std::shared_ptr<const std::vector<SuspicionEvidence>> evidence;

    bool available() const { return motion != nullptr; }
    int frameCount() const { return motion ? motion->positions.frameCount : 0; }
};

/// All derived values of a project, take by take, player by player.
struct Analysis {
    SegmentationSettings settings;
    BodyModel bodyModel;
    ContactSettings contacts;
    std::vector<std::vector<FighterAnalysis>> takes;

    const FighterAnalysis& at(FighterAddress address) const;
};

/// Derives everything from the project, taking over from `previous` each stage whose inputs did
/// not change. A pure function: the same project gives the same values, with or without
/// `previous`. Cancellable.
Analysis analyse(const Project& project, const Analysis& previous = {},
                 const Progress& progress = {});

/// A point of a fighter's file space in the bout's space: placed, floor at y = 0. Metres.
Eigen::Vector3d placed(const Fighter& fighter, double floor, const Eigen::Vector3d& point);

/// Seconds on the take's clock at which a fighter's frame is shown, and the frame shown at a time
/// (nearest; clamped to the fighter's frames).
double timeOfFrame(const Fighter& fighter, double frame);
int frameAtTime(const Fighter& fighter, double seconds);
/// First and last moment of a take on its clock, seconds.
struct TimeSpan {
    double begin = 0;
    double end = 0;
};
TimeSpan timeSpan(const Take& take);

}  // namespace kumite
