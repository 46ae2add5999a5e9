#include "core/project/sequence_draft.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        const kumite::SequenceDraft draft = kumite::parseSequenceDraft(text, "fuzz.json");
        kumite::fuzz::mustHold(
            kumite::parseSequenceDraft(kumite::sequenceDraftText(draft), "again.json") == draft,
            "a sequence is written as it was read");
    });
}
