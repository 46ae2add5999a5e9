#include "tests/benchmarks/run_keeper.h"

#include <algorithm>
#include <cmath>

namespace kumite::bench {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void RunKeeper::ReportRuns(const std::vector<Run>& runs) {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
        const auto& name = run.run_name;
        Kept& kept =
            kept_[name.args.empty() ? name.function_name : name.function_name + "/" + name.args];
        const bool real = name.time_type.find("real_time") != std::string::npos;
        const double all = real ? run.real_accumulated_time : run.cpu_accumulated_time;
        kept.seconds = std::min(kept.seconds, all / static_cast<double>(run.iterations));
        for (const auto& [counter, value] : run.counters) {
            double& most = kept.counters.try_emplace(counter, value.value).first->second;
            most = std::max(most, value.value);
        }
    }
}

double RunKeeper::seconds(const std::string& name) const {
    const auto found = kept_.find(name);
    return found == kept_.end() ? kNone : found->second.seconds;
}

double RunKeeper::counter(const std::string& name, const std::string& counter) const {
    const auto found = kept_.find(name);
    if (found == kept_.end()) return kNone;
    const auto value = found->second.counters.find(counter);
    return value == found->second.counters.end() ? kNone : value->second;
}

void RunKeeper::addTime(const std::string& name, BenchRow row, int pieces) const {
    const double time = seconds(name) / pieces;
    if (std::isnan(time)) return;
    row.result = timeText(time) + row.result;
    addRow(row);
}

}  // namespace kumite::bench
