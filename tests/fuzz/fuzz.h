#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"

namespace kumite::fuzz {

/// Gives the bytes to a reader. Whatever they are, it may refuse them in a sentence, and nothing
/// else: any other exception, a crash and what a sanitizer sees are faults.
template <typename Read>
int feed(const std::uint8_t* data, std::size_t size, const Read& read) {
    try {
        read(std::string_view(reinterpret_cast<const char*>(data), size));
    } catch (const Error& refused) {
        if (std::string_view(refused.what()).empty()) std::abort();
    }
    return 0;
}

/// What was read must come back from what is written of it.
inline void mustHold(bool truth, const char* what) {
    if (truth) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

}  // namespace kumite::fuzz
