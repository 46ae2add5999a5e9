#include "core/formats/json_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLength = 96;

void write(const Json& json, std::size_t indent, std::string& out) {
    const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (!json.is_structured() || json.empty() || indent + line.size() <= kLineLength) {
        // The one-line form with a space after commas and colons outside of strings.
        bool inString = false;
        bool escaped = false;
        for (const char c : line) {
            out += c;
            if (c == '"' && !escaped) inString = !inString;
            escaped = inString && c == '\\' && !escaped;
            if (!inString && (c == ',' || c == ':')) out += ' ';
        }
        return;
    }
    const std::string margin(indent + 2, ' ');
    out += json.is_array() ? "[\n" : "{\n";
    bool first = true;
    for (const auto& item : json.items()) {
        if (!first) out += ",\n";
        first = false;
        out += margin;
        if (json.is_object()) out += Json(item.key()).dump() + ": ";
        write(item.value(), indent + 2, out);
    }
    out += "\n" + std::string(indent, ' ') + (json.is_array() ? "]" : "}");
}

}  // namespace

std::string prettyJson(const Json& json) {
    std::string text;
    write(json, 0, text);
    return text + "\n";
}

double rounded(double value) {
    return std::round(value * 1e6) / 1e6;
}

std::string asStored(const std::string& text) {
    return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

Json parseJson(std::string_view text, const std::string& name) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const std::string_view before = text.substr(0, error.byte > 0 ? error.byte - 1 : 0);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const auto newline = before.rfind('\n');
        const std::size_t column =
            newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
        throw InputError(name, static_cast<int>(line), static_cast<int>(column),
                         "is not valid JSON here.");
    } catch (const Json::exception&) {
        throw InputError(name, 0, 0, "holds a number that is too large.");
    }
}

JsonReader JsonReader::operator[](const std::string& key) const {
    if (!has(key)) throw error("\"" + key + "\" is missing");
    return {json_.at(key), file_, place_.empty() ? key : place_ + "." + key};
}

JsonReader JsonReader::at(std::size_t index) const {
    if (index >= size()) throw error("expected at least " + std::to_string(index + 1) + " entries");
    return {json_.at(index), file_, place_ + "[" + std::to_string(index) + "]"};
}

std::size_t JsonReader::size() const {
    if (!json_.is_array()) throw error("expected a list");
    return json_.size();
}

std::vector<std::string> JsonReader::keys() const {
    if (!json_.is_object()) throw error("expected an object");
    std::vector<std::string> keys;
    for (const auto& item : json_.items())
        keys.push_back(item.key());
    return keys;
}

int JsonReader::integer() const {
    const double value = number();
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
        throw error("expected a whole number");
    }
    return static_cast<int>(value);
}

double JsonReader::number() const {
    if (!json_.is_number()) throw error("expected a number");
    const double value = json_.get<double>();
    if (!std::isfinite(value)) throw error("expected a finite number");
    return value;
}

double JsonReader::positive() const {
    const double value = number();
    if (value <= 0) throw error("expected a number above 0");
    return value;
}

bool JsonReader::boolean() const {
    if (!json_.is_boolean()) throw error("expected true or false");
    return json_.get<bool>();
}

std::string JsonReader::text() const {
    if (!json_.is_string()) throw error("expected text");
    return json_.get<std::string>();
}

}  // namespace kumite
