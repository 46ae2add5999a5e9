#include "core/project/label_files.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        kumite::Findings findings;
        for (const auto& label :
             kumite::parseLabelsEaf(text, "fuzz.eaf", kumite::kickboxing(), &findings))
            kumite::fuzz::mustHold(label.aspects.size() == kumite::kickboxing().aspects.size(),
                                   "a label has every aspect");
    });
}
