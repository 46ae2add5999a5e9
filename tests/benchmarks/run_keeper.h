#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/benchmarks/bench_table.h"

namespace kumite::bench {

/// The usual output of Google Benchmark; keeps what was measured, for rows of the table. Benchmarks
/// have the names that are printed, without what follows their arguments.
class RunKeeper : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override;

    /// Seconds of one iteration, of the fastest repetition: real ones where the benchmark uses real
    /// time, else the processor's. NaN if it did not run or failed.
    double seconds(const std::string& name) const;
    /// The largest of all repetitions; NaN if there is none.
    double counter(const std::string& name, const std::string& counter) const;

    /// Adds a row whose result is the time of a benchmark, over `pieces`, before what it says
    /// already; nothing if the benchmark did not run.
    void addTime(const std::string& name, BenchRow row, int pieces = 1) const;

private:
    struct Kept {
        double seconds = std::numeric_limits<double>::infinity();
        std::map<std::string, double> counters;
    };
    std::map<std::string, Kept> kept_;
};

}  // namespace kumite::bench
