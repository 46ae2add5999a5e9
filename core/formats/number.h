#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
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

/// Eight characters as one integer, the first in its lowest byte.
inline std::uint64_t loadEight(const char* at) {
    static_assert(std::endian::native == std::endian::little);
    std::uint64_t eight = 0;
    std::memcpy(&eight, at, sizeof eight);
    return eight;
}

/// How many of eight characters are digits before the first that is none. A byte is a digit if its
/// upper half is 3 and stays 3 when 6 is added.
inline int countDigits(std::uint64_t eight) {
    constexpr std::uint64_t kUpperHalves = 0xF0F0F0F0F0F0F0F0;
    constexpr std::uint64_t kThrees = 0x3030303030303030;
    constexpr std::uint64_t kSixes = 0x0606060606060606;
    const std::uint64_t others =
        ((eight & kUpperHalves) ^ kThrees) | (((eight + kSixes) & kUpperHalves) ^ kThrees);
    return std::countr_zero(others) / 8;
}

/// The number that the first `count` of eight characters spell, all of which are digits. Adds
/// neighbours, then pairs, then fours: three multiplications instead of eight.
inline std::uint64_t valueOfDigits(std::uint64_t eight, int count) {
    constexpr std::uint64_t kLowerHalves = 0x0F0F0F0F0F0F0F0F;
    constexpr std::uint64_t kPairs = 0x000000FF000000FF;
    if (count == 0) return 0;
    std::uint64_t digits = (eight & kLowerHalves) << (64 - 8 * count);  // behind leading zeros
    digits = digits * 10 + (digits >> 8);
    return ((digits & kPairs) * (100 + (std::uint64_t{1'000'000} << 32)) +
            ((digits >> 16) & kPairs) * (1 + (std::uint64_t{10'000} << 32))) >>
           32;
}

/// Appends the digits from `at` on to `number` (which wraps round behind 19 of them) and returns
/// their end. Takes eight at a time, because how many digits a number has cannot be predicted.
inline const char* readDigits(const char* at, const char* end, std::uint64_t& number) {
    static constexpr std::array<std::uint64_t, 9> kPowersOfTen = {
        1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};
    while (end - at >= 8) {
        const std::uint64_t eight = loadEight(at);
        const int count = countDigits(eight);
        number =
            number * kPowersOfTen[static_cast<std::size_t>(count)] + valueOfDigits(eight, count);
        at += count;
        if (count < 8) return at;
    }
    for (; at != end && isDigit(*at); ++at) {
        number = 10 * number + static_cast<std::uint64_t>(*at - '0');
    }
    return at;
}

/// Reads an exponent such as `e-05` at `at`, if there is one, adds it to `exponent` and returns its
/// end; nullptr if it is none or a long one.
inline const char* readExponent(const char* at, const char* end, std::ptrdiff_t& exponent) {
    if (at == end || (*at != 'e' && *at != 'E')) return at;
    ++at;
    const bool negative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    std::uint64_t digits = 0;
    const char* const after = readDigits(at, end, digits);
    if (after == at || after - at > 4) return nullptr;
    exponent +=
        negative ? -static_cast<std::ptrdiff_t>(digits) : static_cast<std::ptrdiff_t>(digits);
    return after;
}

/// The same as readRareNumber, quick for what recordings hold. Digits that make an integer up to
/// 2^53, and a power of ten up to 10^22, are two exact doubles, so that the one product or quotient
/// rounds correctly (Clinger, "How to read floating point numbers accurately", 1990). All else
/// takes the long way.
inline const char* readNumber(const char* begin, const char* end, double& value) {
    static constexpr std::array<double, 23> kPowersOfTen = {
        1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    static constexpr std::array<double, 2> kSigns = {1.0, -1.0};
    constexpr std::ptrdiff_t kLargestPower = 22;
    constexpr std::uint64_t kLargestInteger = std::uint64_t{1} << 53;
    constexpr std::ptrdiff_t kDigitsThatFit = 19;

    const bool negative = begin != end && *begin == '-';
    const char* const whole = begin + (negative ? 1 : 0);
    std::uint64_t digits = 0;
    const char* at = readDigits(whole, end, digits);
    std::ptrdiff_t count = at - whole;
    std::ptrdiff_t exponent = 0;
    if (at != end && *at == '.') {
        const char* const decimals = at + 1;
        at = readDigits(decimals, end, digits);
        exponent = decimals - at;
        count += at - decimals;
    }
    at = readExponent(at, end, exponent);
    if (at == nullptr || count == 0 || count > kDigitsThatFit || digits > kLargestInteger ||
        exponent > kLargestPower || exponent < -kLargestPower) {
        return readRareNumber(begin, end, value);
    }
    // The sign as a factor, not as a branch: signs cannot be predicted.
    const double integer = kSigns[negative] * static_cast<double>(digits);
    value = exponent < 0 ? integer / kPowersOfTen[static_cast<std::size_t>(-exponent)]
                         : integer * kPowersOfTen[static_cast<std::size_t>(exponent)];
    return at;
}

}  // namespace kumite
