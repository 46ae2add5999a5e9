#include "tests/benchmarks/bench_table.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "core/base/text.h"

namespace kumite::bench {

namespace {

std::string asCell(const std::string& text) {
    std::string cell;
    for (const char c : text) {
        if (c == '|') cell += '\\';
        cell += c == '\n' ? ' ' : c;
    }
    return cell;
}

/// Two digits, or all before the point.
std::string twoDigits(double value) {
    return fixed(value, value < 0.995 ? 2 : value < 9.95 ? 1 : 0);
}

}  // namespace

void addRow(const BenchRow& row) {
    const char* table = std::getenv("KUMITE_BENCH_TABLE");
    if (table == nullptr || *table == '\0') return;
    std::string line = "|";
    for (const std::string* cell : {&row.what, &row.size, &row.result, &row.peer, &row.ratio})
        line += " " + asCell(*cell) + (cell->empty() ? "|" : " |");
    std::ofstream out(table, std::ios::app);
    out << line << std::endl;
    if (!out) std::cerr << "cannot write to " << table << "\n";
}

std::string timeText(double seconds) {
    if (!std::isfinite(seconds)) return {};
    if (seconds >= 0.0995) return twoDigits(seconds) + " s";
    if (seconds >= 0.0995e-3) return twoDigits(1e3 * seconds) + " ms";
    return twoDigits(1e6 * seconds) + " µs";
}

std::string timesText(double ratio) {
    return std::isfinite(ratio) ? twoDigits(ratio) + "×" : std::string();
}

std::string rangeText(double least, double most, int decimals) {
    const std::string from = fixed(least, decimals), to = fixed(most, decimals);
    return from == to ? to : from + "–" + to;
}

}  // namespace kumite::bench
