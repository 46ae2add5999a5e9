#include "core/project/project_file.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        const kumite::Project project = kumite::parseProject(text, "fuzz.kumite", "/somewhere");
        const std::string written = kumite::projectText(project, "/somewhere");
        const kumite::Project again = kumite::parseProject(written, "again.kumite", "/somewhere");
        kumite::fuzz::mustHold(kumite::projectText(again, "/somewhere") == written,
                               "a project is written as it was read");
    });
}
