#include "core/labelling/vocabulary.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kumite::fuzz::feed(data, size, [](std::string_view text) {
        const kumite::Vocabulary vocabulary = kumite::parseVocabulary(text, "fuzz.json");
        kumite::fuzz::mustHold(
            kumite::parseVocabulary(kumite::vocabularyText(vocabulary), "again.json") == vocabulary,
            "a vocabulary is written as it was read");
    });
}
