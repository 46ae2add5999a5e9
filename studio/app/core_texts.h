#pragma once

#include <span>

namespace kumite::studio {

/// A text that the core makes, as a pattern: %1, %2 … stand for what is put in. The core itself
/// knows no language; `core_words.h` finds the pattern of a text and says it in the window's.
struct CoreText {
    const char* source;
    /// Whether what is put in are words of the vocabulary or other texts, and no names that a user
    /// gave. Whole sentences are known in any place.
    bool holdsTexts;
};

/// Names of edits, as the history shows them.
std::span<const CoreText> editTexts();
/// Errors, findings, reasons: whole sentences, and what an error expects. The path, line and column
/// that precede many of them are no part of them.
std::span<const CoreText> sentenceTexts();
/// What the built-in vocabulary calls its aspects and their qualifiers.
std::span<const char* const> vocabularyNames();

}  // namespace kumite::studio
