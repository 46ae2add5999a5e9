#pragma once

#include <string>

/// What the benchmarks share: one table of the figures of the project.
namespace kumite::bench {

/// One figure, beside that of another program, of a paper or of another way to do the same.
struct BenchRow {
    std::string what;
    std::string size = {};  ///< of what it was measured on
    std::string result = {};
    std::string peer = {};
    std::string ratio = {};  ///< how many times as good as the peer
};

/// Appends a row of Markdown to the file that KUMITE_BENCH_TABLE names; without it does nothing.
void addRow(const BenchRow& row);

/// "0.20 s", "17 ms", "8.7 µs"; nothing of what was not measured (NaN).
std::string timeText(double seconds);
/// "9.6×"; nothing where one of both was not measured.
std::string timesText(double ratio);
/// "1.1–3.0", "62" where both are written the same.
std::string rangeText(double least, double most, int decimals);

}  // namespace kumite::bench
