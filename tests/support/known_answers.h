#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/formats/recording.h"
#include "core/motion/kinematics.h"
#include "core/motion/role_mapping.h"
#include "tests/support/fixtures.h"

namespace kumite::test {

/// A case of known_answers/, made by an independent program.
inline nlohmann::json knownAnswer(const std::string& name) {
    return nlohmann::json::parse(readText(*dataFolder() / "known_answers" / (name + ".json")));
}

/// The recording that such a case was made from, as the case says to read it.
struct KnownRecording {
    std::shared_ptr<const Motion> motion;
    FrameRange frames;
    SpaceConvention space{0.01, UpAxis::Y};
    RoleMap roles;

    explicit KnownRecording(const nlohmann::json& input)
        : motion(readRecording(*dataFolder() / input["file"].get<std::string>()).motions.front()),
          frames{input["trim"].get<int>(), motion->frameCount},
          roles(mapRoles(*motion->skeleton).roles) {}
};

}  // namespace kumite::test
