#include "core/motion/body_model.h"

namespace kumite {
namespace {

using enum Role;

BodySegment limb(std::string name, double mass, Role from, Role to, double fraction) {
    return {std::move(name), mass, {from}, to, false, false, fraction};
}

}  // namespace

const BodyModel& deLevaMale() {
    static const BodyModel model{
        "de Leva 1996, male means",
        {
            {"trunk", 0.4346, {LeftHip, RightHip}, Neck, false, false, 0.5514},
            {"head", 0.0694, {Neck}, Head, true, false, 0.5},
            limb("left upper arm", 0.0271, LeftShoulder, LeftElbow, 0.5772),
            limb("right upper arm", 0.0271, RightShoulder, RightElbow, 0.5772),
            limb("left forearm", 0.0162, LeftElbow, LeftWrist, 0.4574),
            limb("right forearm", 0.0162, RightElbow, RightWrist, 0.4574),
            {"left hand", 0.0061, {LeftWrist}, {}, false, false, 0},
            {"right hand", 0.0061, {RightWrist}, {}, false, false, 0},
            limb("left thigh", 0.1416, LeftHip, LeftKnee, 0.4095),
            limb("right thigh", 0.1416, RightHip, RightKnee, 0.4095),
            limb("left shank", 0.0433, LeftKnee, LeftAnkle, 0.4395),
            limb("right shank", 0.0433, RightKnee, RightAnkle, 0.4395),
            {"left foot", 0.0137, {LeftAnkle}, LeftToe, false, true, 0.5},
            {"right foot", 0.0137, {RightAnkle}, RightToe, false, true, 0.5},
        }};
    return model;
}

}  // namespace kumite
