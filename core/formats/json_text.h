#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace kumite {

/// JSON as people like to read it: short arrays and objects on one line, two spaces a level.
std::string prettyJson(const nlohmann::ordered_json& json);

/// Six decimals: more than a recording is good for, and short to read.
double rounded(double value);

/// The text as a file would give it back: bytes that are no UTF-8 become U+FFFD.
std::string asStored(const std::string& text);

/// Parses JSON; throws InputError with line and column. `name` is used in messages.
nlohmann::ordered_json parseJson(std::string_view text, const std::string& name);

/// A value inside a JSON document that knows where it stands, so that what is missing or of the
/// wrong kind is named in one sentence: `bout.kumite: takes[0].name: expected text`.
/// Refers to the document; must not outlive it.
class JsonReader {
public:
    JsonReader(const nlohmann::ordered_json& json, std::string file, std::string place)
        : json_(json), file_(std::move(file)), place_(std::move(place)) {}

    bool isObject() const { return json_.is_object(); }
    bool has(const std::string& key) const { return json_.is_object() && json_.contains(key); }
    JsonReader operator[](const std::string& key) const;
    JsonReader at(std::size_t index) const;
    std::size_t size() const;  ///< of an array
    std::vector<std::string> keys() const;

    int integer() const;
    double number() const;    ///< finite
    double positive() const;  ///< finite and above 0
    bool boolean() const;
    std::string text() const;

    InputError error(const std::string& what) const {
        return InputError(file_, 0, 0, (place_.empty() ? "" : place_ + ": ") + what + ".");
    }

private:
    const nlohmann::ordered_json& json_;
    std::string file_;
    std::string place_;
};

}  // namespace kumite
