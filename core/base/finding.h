#pragma once

#include <string>
#include <vector>

namespace kumite {

enum class Severity { Note, Warning };

/// Something that a user should know about data that was accepted all the same: what was found,
/// what was done about it. Errors are exceptions, never findings.
struct Finding {
    Severity severity = Severity::Note;
    std::string text;

    bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

inline Finding note(std::string text) {
    return {Severity::Note, std::move(text)};
}
inline Finding warning(std::string text) {
    return {Severity::Warning, std::move(text)};
}

}  // namespace kumite
