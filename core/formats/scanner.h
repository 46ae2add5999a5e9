#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/formats/number.h"

namespace kumite {

inline bool isSpace(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}
inline bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}
inline bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Bytes of the well-formed UTF-8 character at the front of `text`; 0 if there is none.
inline std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.empty()) return 0;
    if (byte(0) < 0x80) return 1;
    const std::size_t length = byte(0) >= 0xF5   ? 0
                               : byte(0) >= 0xF0 ? 4
                               : byte(0) >= 0xE0 ? 3
                               : byte(0) >= 0xC2 ? 2
                                                 : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
    }
    return length;
}

/// `text` for a message: in quotes, shortened to about 30 characters, what cannot be printed as
/// \xNN, so that any bytes at all give readable UTF-8.
inline std::string inQuotes(std::string_view text) {
    constexpr std::size_t kLongest = 30;
    std::string out = "'";
    for (std::size_t shown = 0; !text.empty(); ++shown) {
        if (shown == kLongest) {
            out += "…";
            break;
        }
        const std::size_t length = utf8Length(text);
        const auto byte = static_cast<unsigned char>(text.front());
        if (length == 0 || byte < 0x20 || byte == 0x7F) {
            out += fmt::format("\\x{:02X}", byte);
            text.remove_prefix(1);
        } else {
            out += text.substr(0, length);
            text.remove_prefix(length);
        }
    }
    return out + "'";
}

/// Walks through the text of a line-oriented format: words, names, numbers and comments, and
/// errors that tell the place. Lines end with \n, \r\n or \r. A `#` or `//` that begins a line or
/// follows white space begins a comment. Lines and columns are counted only when an error asks.
class Scanner {
public:
    /// `text` must outlive the scanner; `name` stands in messages. Skips a UTF-8 byte order mark;
    /// throws InputError for UTF-16 text.
    Scanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
        if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
            throw InputError(name_, 1, 1,
                             "found UTF-16 text, expected plain text (save the file as UTF-8)");
        }
        if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    }

    std::string_view text() const { return text_; }
    std::size_t position() const { return at_; }
    void moveTo(std::size_t position) { at_ = position; }

    /// Moves to the next thing that is neither white space nor comment; false at the end.
    bool skipSpace() {
        for (;;) {
            while (at_ < text_.size() && isSpace(text_[at_]))
                ++at_;
            if (at_ == text_.size()) return false;
            if (!startsComment(at_)) return true;
            skipLine();
        }
    }
    /// Moves to the end of the line, its end sign not included.
    void skipLine() { at_ = lineEnd(); }

    /// The next token without moving behind it (only white space and comments are skipped): a
    /// brace, or all up to white space or a brace. Empty at the end of the text.
    std::string_view peek() {
        if (!skipSpace()) return {};
        if (isBrace(text_[at_])) return text_.substr(at_, 1);
        std::size_t end = at_;
        while (end < text_.size() && !isSpace(text_[end]) && !isBrace(text_[end]))
            ++end;
        return text_.substr(at_, end - at_);
    }
    std::string_view next() {
        const std::string_view token = peek();
        at_ += token.size();
        return token;
    }
    /// Takes the next token if it is `word`, in any case.
    bool accept(std::string_view word) {
        if (!equalsIgnoringCase(peek(), word)) return false;
        at_ += word.size();
        return true;
    }
    void expect(std::string_view word) {
        if (!accept(word)) failHere(std::string(word));
    }

    /// The rest of the line without white space around it and without a comment.
    std::string_view restOfLine() {
        const std::size_t end = lineEnd();
        std::size_t stop = at_;
        while (stop < end && !startsComment(stop))
            ++stop;
        const std::string_view rest = text_.substr(at_, stop - at_);
        at_ = end;
        return trimmed(rest);
    }

    /// Whether the line has anything but blanks and a comment left; moves in front of it.
    bool moreOnLine() {
        const std::size_t end = lineEnd();
        while (at_ < end && isSpace(text_[at_]))
            ++at_;
        return at_ < end && !startsComment(at_);
    }

    /// The next token as a number; `what` is what the error expects: "a number for the OFFSET".
    double number(std::string_view what) {
        const std::string_view token = peek();
        double value = 0;
        const char* const end = token.data() + token.size();
        if (token.empty() || readNumber(token.data(), end, value) != end) {
            failHere(std::string(what));
        }
        at_ += token.size();
        return value;
    }

    /// `found what stands here, expected …`.
    [[noreturn]] void failHere(const std::string& expected) {
        const std::string_view token = peek();
        fail(at_, fmt::format("found {}, expected {}",
                              token.empty() ? "the end of the file" : inQuotes(token), expected));
    }
    [[noreturn]] void fail(std::size_t position, const std::string& sentence) const {
        int line = 1;
        std::size_t lineBegin = 0;
        for (std::size_t i = 0; i < position; ++i) {
            const bool halfOfPair =
                text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
            if (!isLineEnd(text_[i]) || halfOfPair) continue;
            ++line;
            lineBegin = i + 1;
        }
        int column = 1;
        for (std::size_t i = lineBegin; i < position; ++i) {
            const bool continuesCharacter = (static_cast<unsigned char>(text_[i]) & 0xC0) == 0x80;
            if (!continuesCharacter) ++column;
        }
        throw InputError(name_, line, column, sentence);
    }

private:
    static bool isBrace(char c) { return c == '{' || c == '}'; }
    bool startsComment(std::size_t at) const {
        if (at > 0 && !isSpace(text_[at - 1])) return false;
        return text_[at] == '#' || text_.substr(at, 2) == "//";
    }
    std::size_t lineEnd() const { return std::min(text_.find_first_of("\r\n", at_), text_.size()); }

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
};

}  // namespace kumite
