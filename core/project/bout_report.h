#pragma once

#include <filesystem>
#include <string>

#include "core/synthesis/bout_quality.h"

namespace kumite {

/// All that a report on a bout says.
struct BoutReport {
    std::string name;  ///< of the project
    Quality quality;
    Quality recording;
};

/// A measure by name, of the bout and of the recording, as text; "-" where not known.
struct QualityRow {
    std::string name, bout, recording;
};
std::vector<QualityRow> qualityRows(const Quality& bout, const Quality& recording);

/// One JSON object: `project`, `mode`, `seed`, `seconds`, `choices`, and `quality` and
/// `recording_quality` as `qualityJson` has them.
std::string boutReportJson(const BoutReport& report, const BoutTape& tape);
/// For people, as Markdown; names the strips that writeBoutReport puts beside it.
std::string boutReportMarkdown(const BoutReport& report, const BoutTape& tape);
/// Writes report.md, quality.json and strips.svg (bout_strips.h). Makes the folder. Throws Error.
/// Cancellable.
void writeBoutReport(const BoutReport& report, const BoutTape& tape,
                     const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace kumite
