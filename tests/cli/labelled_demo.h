#pragma once

#include <string>

#include <gtest/gtest.h>

#include "core/base/files.h"
#include "tests/cli/command_line.h"
#include "tests/support/fixtures.h"

namespace kumite::test {

/// One short demo bout for all tests of a suite, since making it costs most of the time: labelled
/// by its truth (`project`) and without labels (`bare`), in `folder`.
class LabelledDemo : public testing::Test {
protected:
    static inline TemporaryFolder* folder = nullptr;
    static inline std::string project, bare;

    static void SetUpTestSuite() {
        folder = new TemporaryFolder;
        const std::string out = (*folder / "demo").string();
        ASSERT_EQ(kumite({"demo", "--out", out, "--seconds", "30", "--seed", "5"}).code, 0);
        project = out + "/demo.kumite";
        bare = out + "/bare.kumite";
        writeText(bare, readText(project));
        ASSERT_EQ(kumite({"label", project, "--import", out + "/truth.json"}).code, 0);
    }
    static void TearDownTestSuite() {
        delete folder;
        folder = nullptr;
    }
};

}  // namespace kumite::test
