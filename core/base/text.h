#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kumite {

/// The shortest text that reads back as exactly this number; no locale. Non-finite numbers give
/// "nan", "inf", "-inf".
std::string shortest(double value);

/// `value` with `decimals` digits after the point; no locale; never "-0.000".
std::string fixed(double value, int decimals);

/// The whole of `text` as a finite number; an optional leading sign, `.5`, `5.` and exponents are
/// accepted; anything else, a NaN or an infinity, gives nothing. No locale.
std::optional<double> parseNumber(std::string_view text);
std::optional<int> parseInteger(std::string_view text);

std::string_view trimmed(std::string_view text);
std::vector<std::string_view> split(std::string_view text, char separator);
std::string lowerCase(std::string_view text);
bool equalsIgnoringCase(std::string_view a, std::string_view b);

}  // namespace kumite
