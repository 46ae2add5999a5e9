#include "core/project/bout_report.h"

#include <numbers>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/project/bout_strips.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const std::optional<double>& value, double factor, int decimals) {
    return value ? fixed(factor * *value, decimals) : "-";
}

std::string shareOf(const std::optional<Penetration>& penetration) {
    return penetration ? fixed(100 * penetration->share, 2) : "-";
}

std::string worstOf(const std::optional<Penetration>& penetration) {
    return penetration ? fixed(100 * penetration->worst, 1) : "-";
}

std::string distanceOf(const std::optional<FighterDistance>& distance) {
    if (!distance) return "-";
    return fmt::format("{} ({} to {})", fixed(distance->mean, 2), fixed(distance->nearest, 2),
                       fixed(distance->farthest, 2));
}

double secondsOf(const BoutTape& tape) {
    return tape.end() / tape.first().library().rate;
}

}  // namespace

std::vector<QualityRow> qualityRows(const Quality& bout, const Quality& recording) {
    std::vector<QualityRow> rows;
    const auto add = [&](const char* name, const auto& say) {
        rows.push_back({name, say(bout), say(recording)});
    };
    add("feet skate, % of frames", [](const Quality& q) { return text(q.footSkate, 100, 2); });
    add("feet in the floor, % of frames", [](const Quality& q) { return shareOf(q.floor); });
    add("… at worst, cm", [](const Quality& q) { return worstOf(q.floor); });
    add("bodies over 3 cm in each other, % of frames",
        [](const Quality& q) { return shareOf(q.interpenetration); });
    add("… at worst, cm", [](const Quality& q) { return worstOf(q.interpenetration); });
    add("joint accelerations at joins, 99th percentile over that inside recorded actions",
        [](const Quality& q) { return text(q.joinAccelerationRatio, 1, 2); });
    add("… of the same actions' beginnings as recorded",
        [](const Quality& q) { return text(q.recordedAccelerationRatio, 1, 2); });
    add("joint velocities at joins, the same way",
        [](const Quality& q) { return text(q.joinVelocityRatio, 1, 2); });
    add("facing error, degrees",
        [](const Quality& q) { return text(q.facingError, 180 / std::numbers::pi, 1); });
    add("distance, m, mean (nearest to farthest)",
        [](const Quality& q) { return distanceOf(q.distance); });
    add("hits beside the wanted lag, ms",
        [](const Quality& q) { return text(q.hitTiming, 1000, 0); });
    add("distinct runs of three labels, share", [](const Quality& q) {
        return text(q.variety ? std::optional(q.variety->share()) : std::nullopt, 1, 2);
    });
    return rows;
}

std::string boutReportJson(const BoutReport& report, const BoutTape& tape) {
    const BoutSettings& settings = tape.first().settings();
    const Json json = {{"project", report.name},
                       {"mode", modeName(settings.mode)},
                       {"seed", settings.seed},
                       {"seconds", secondsOf(tape)},
                       {"choices", tape.choices().size()},
                       {"quality", qualityJson(report.quality)},
                       {"recording_quality", qualityJson(report.recording)}};
    return json.dump(1) + "\n";
}

std::string boutReportMarkdown(const BoutReport& report, const BoutTape& tape) {
    const BoutSettings& settings = tape.first().settings();
    std::string page = fmt::format(
        "# A bout made from {}\n\nMode {}, seed {}, {} s, {} choices.\n\n## How good it is\n\n"
        "| | bout | recording |\n| --- | ---: | ---: |\n",
        report.name, modeName(settings.mode), settings.seed, fixed(secondsOf(tape), 1),
        tape.choices().size());
    for (const QualityRow& row : qualityRows(report.quality, report.recording))
        page += fmt::format("| {} | {} | {} |\n", row.name, row.bout, row.recording);
    return page +
           "\nThe recording is its longest take of two, measured the same way; its joins are the "
           "boundaries of its actions, its hits are held against their median lag.\n\n"
           "## Synthesised actions and the recorded ones they were made from\n\n"
           "![Film strips](strips.svg)\n";
}

void writeBoutReport(const BoutReport& report, const BoutTape& tape,
                     const std::filesystem::path& folder, const Progress& progress) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw Error(folder.string() + ": " + failed.message() + ".");
    const std::string strips = boutStripsSvg(tape, {}, progress);
    writeFileAtomically(folder / "report.md", boutReportMarkdown(report, tape));
    writeFileAtomically(folder / "quality.json", boutReportJson(report, tape));
    writeFileAtomically(folder / "strips.svg", strips);
}

}  // namespace kumite
