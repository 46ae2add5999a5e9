#include "core/editing/key_file.h"
#include "tests/fuzz/fuzz.h"

namespace {

/// A body of four joints.
std::shared_ptr<const kumite::Rig> body() {
    auto rig = std::make_shared<kumite::Rig>();
    const char* const names[] = {"Hips", "Chest", "Head", "LeftUpLeg"};
    const int parents[] = {-1, 0, 1, 0};
    for (int joint = 0; joint < 4; ++joint) {
        kumite::Rig::Joint each;
        each.name = names[joint];
        each.parent = parents[joint];
        each.offset = {0, joint == 0 ? 0.0 : 0.3, 0};
        rig->joints.push_back(each);
    }
    return rig;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        static const auto rig = body();
        const auto nothing = [](const std::string& clip, int) -> kumite::Pose {
            throw kumite::Error("There is no clip " + clip + ".");
        };
        const kumite::KeyTrack track = kumite::parseKeys(text, "fuzz.json", rig, nothing);
        const kumite::KeyTrack again =
            kumite::parseKeys(kumite::keysText(track), "again.json", rig, nothing);
        kumite::fuzz::mustHold(again.keys.size() == track.keys.size(), "no key is lost");
        for (std::size_t i = 0; i < track.keys.size(); ++i)
            kumite::fuzz::mustHold(again.keys[i].frame == track.keys[i].frame, "keys stay in time");
    });
}
