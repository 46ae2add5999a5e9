#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kumite {

/// The word that stands for the break between two parts of a filter.
inline constexpr std::string_view kFilterBreak = ",";

/// Whole parts that every filter knows; they are also what is offered while one types.
inline constexpr std::array kFilterParts = {"by hand",
                                            "by machine",
                                            "by rule",
                                            "uncertain",
                                            "sure",
                                            "below 0.6",
                                            "above 0.9",
                                            "unlabelled",
                                            "labelled",
                                            "player 1",
                                            "player 2",
                                            "strike",
                                            "attack",
                                            "others",
                                            "after 0:30",
                                            "before 1:00",
                                            "from 0:30 to 1:00",
                                            "at 0:30",
                                            "longer than 1 s",
                                            "shorter than 0.3 s"};

template <typename List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Words of a filter in small letters; "right_punch:fwd+jump:up" counts as "right punch fwd, jump
/// up"; what stands in quotes is one word.
std::vector<std::string> wordsOf(std::string_view typed);

/// Letters to change, add, leave out or swap to make one word of another.
int editDistance(std::string_view a, std::string_view b);

/// "1:20", "1:02:03.5", "80", "80s" as seconds; nothing where it is no time.
std::optional<double> secondsOf(std::string_view text);
/// 80.5 → "1:20.5"
std::string timeWords(double seconds);

}  // namespace kumite
