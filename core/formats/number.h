#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>

namespace kumite {

inline bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Reads the decimal number at `begin`, correctly rounded and without the locale: an optional
/// sign, digits with an optional point, an optional exponent. Returns the end of the number, or
/// nullptr if there is none, or none that a double can hold. Too small a number becomes zero.
inline const char* readRareNumber(const char* begin, const char* end, double& value) {
    const char* at = begin;
    if (at != end && *at == '+') ++at;
    const bool signTwice = at != begin && at != end && *at == '-';
    const auto [after, error] = std::from_chars(at, end, value);
    if (signTwice || error == std::errc::invalid_argument) return nullptr;
    if (error == std::errc::result_out_of_range) {
        // std::from_chars does not tell too large from too small.
        const std::string_view text(at, static_cast<std::size_t>(after - at));
        const auto exponent = text.find_first_of("eE");
        const bool tooSmall = exponent != std::string_view::npos
                                  ? text.substr(exponent + 1).starts_with('-')
                                  : text.substr(0, text.find('.')).find_first_of("123456789") ==
                                        std::string_view::npos;
        if (!tooSmall) return nullptr;
        value = *at == '-' ? -0.0 : 0.0;
    }
    return std::isfinite(value) ? after : nullptr;
}

/// The same, quick for what recordings hold. Digits that make an integer up to 2^53, divided by a
/// power of ten up to 10^22, are two exact doubles, so that the one division rounds correctly
/// (Clinger, "How to read floating point numbers accurately", 1990). All else takes the long way.
inline const char* readNumber(const char* begin, const char* end, double& value) {
    constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    constexpr std::uint64_t kLargestExactInteger = std::uint64_t{1} << 53;
    constexpr std::ptrdiff_t kDigitsThatFit = 19;

    const char* at = begin;
    const bool negative = at != end && *at == '-';
    if (negative) ++at;
    std::uint64_t digits = 0;
    const auto readDigits = [&] {
        const char* const first = at;
        for (; at != end && isDigit(*at); ++at) {
            digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
        }
        return at - first;
    };
    const std::ptrdiff_t whole = readDigits();
    std::ptrdiff_t decimals = 0;
    if (at != end && *at == '.') {
        ++at;
        decimals = readDigits();
    }
    const std::ptrdiff_t count = whole + decimals;
    const bool hasExponent = at != end && (*at == 'e' || *at == 'E');
    if (count == 0 || count > kDigitsThatFit || digits > kLargestExactInteger || hasExponent) {
        return readRareNumber(begin, end, value);
    }
    const double magnitude =
        static_cast<double>(digits) / kPowersOfTen[static_cast<std::size_t>(decimals)];
    value = negative ? -magnitude : magnitude;
    return at;
}

}  // namespace kumite
