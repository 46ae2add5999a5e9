#include "core/formats/bvh.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        for (const auto& motion : kumite::readBvh(text, "fuzz").motions) {
            motion->validate();
            const std::string written =
                kumite::bvhText(*motion, motion->frames(), motion->frameTime);
            const kumite::Recording again = kumite::readBvh(written, "again");
            kumite::fuzz::mustHold(again.motions.front()->channels == motion->channels,
                                   "channels are written as they were read");
        }
    });
}
