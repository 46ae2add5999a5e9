#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/fixtures.h"

namespace kumite::test {

/// A case of known_answers/, made by an independent program.
inline nlohmann::json knownAnswer(const std::string& name) {
    return nlohmann::json::parse(readText(*dataFolder() / "known_answers" / (name + ".json")));
}

}  // namespace kumite::test
