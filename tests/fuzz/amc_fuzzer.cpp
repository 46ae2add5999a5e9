// The skeleton and the motion stand behind each other, parted by a line "----".
#include "core/formats/amc.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        const auto parted = text.find("\n----\n");
        const kumite::AsfSkeleton skeleton = kumite::readAsf(text.substr(0, parted), "fuzz.asf");
        skeleton.skeleton->validate();
        if (parted == std::string_view::npos) return;
        for (const auto& motion :
             kumite::readAmc(text.substr(parted + 6), "fuzz.amc", skeleton).motions)
            motion->validate();
    });
}
