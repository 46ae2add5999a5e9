#include "core/project/report.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/json_text.h"
#include "core/formats/tables.h"
#include "core/project/notes.h"
#include "core/project/review.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> peakForce(const FighterAnalysis& fighter, const Action& action) {
    if (!fighter.force) return std::nullopt;
    return fighter.force->force.curve[static_cast<std::size_t>(action.peak)];
}

Json minimaJson(const FighterAnalysis& fighter, double threshold, bool all) {
    Json list = Json::array();
    if (!fighter.force) return list;
    const Segmentation& segmentation = *fighter.segmentation;
    for (std::size_t i = 0; i < fighter.force->minima.size(); ++i) {
        const ForceMinimum& minimum = fighter.force->minima[i];
        const auto boundary =
            std::find_if(segmentation.boundaries.begin(), segmentation.boundaries.end(),
                         [&](const Boundary& b) { return b.minimum == static_cast<int>(i); });
        const bool cuts = boundary != segmentation.boundaries.end();
        if (!all && !cuts && minimum.prominence < threshold) continue;
        Json entry = {{"frame", minimum.frame},
                      {"force", rounded(minimum.force)},
                      {"prominence", rounded(minimum.prominence)},
                      {"kept", cuts},
                      {"suspicion", rounded((*fighter.suspicion)[i])}};
        if (minimum.prominence >= threshold) {
            entry["reason"] = reasonName(suspectReason(fighter, static_cast<int>(i)).kind);
        }
        if (cuts && boundary->source == BoundarySource::Accepted) entry["accepted"] = true;
        if (cuts && boundary->frame != minimum.frame) entry["moved_to"] = boundary->frame;
        list.push_back(std::move(entry));
    }
    return list;
}

Json playerJson(const FighterAnalysis& fighter, double threshold, const ReportOptions& options) {
    if (!fighter.available()) {
        return {{"missing", fighter.input.recording.path.generic_string()}};
    }
    const Segmentation& segmentation = *fighter.segmentation;
    Json actions = Json::array();
    for (const Action& action : segmentation.actions) {
        Json entry = {{"begin", action.begin},
                      {"end", action.end},
                      {"peak", action.peak},
                      {"begin_s", rounded(action.begin / fighter.input.rate)},
                      {"end_s", rounded(action.end / fighter.input.rate)},
                      {"peak_force", nullptr}};
        if (const auto force = peakForce(fighter, action)) entry["peak_force"] = rounded(*force);
        const std::string note = noteOf(fighter.input.notes, segmentation, action);
        if (!note.empty()) entry["note"] = note;
        actions.push_back(std::move(entry));
    }
    Json added = Json::array();
    for (const Boundary& boundary : segmentation.boundaries) {
        if (boundary.source == BoundarySource::Added) added.push_back(boundary.frame);
    }
    Json unmatched = Json::array();
    for (const Correction& correction : segmentation.unmatched) {
        unmatched.push_back(correctionText(correction));
    }
    Json missing = Json::array();
    for (const std::string& segment : fighter.body->com.missingSegments)
        missing.push_back(segment);
    return {{"frames", fighter.frameCount()},
            {"rate", fighter.input.rate},
            {"offset_s", fighter.input.offset},
            {"mass_coverage", rounded(fighter.body->com.massCoverage)},
            {"missing_segments", std::move(missing)},
            {"smoothed", fighter.force && fighter.force->force.smoothed},
            {"minima", minimaJson(fighter, threshold, options.allMinima)},
            {"added", std::move(added)},
            {"actions", std::move(actions)},
            {"unmatched_corrections", std::move(unmatched)}};
}

/// Calls `use` for every take that `only` lets through.
template <typename Use>
void forTakes(const Project& project, std::optional<int> only, const Use& use) {
    for (std::size_t i = 0; i < project.takes.size(); ++i) {
        if (!only || *only == static_cast<int>(i)) use(i);
    }
}

}  // namespace

std::string segmentationJson(const Project& project, const Analysis& analysis,
                             const ReportOptions& options) {
    const SegmentationSettings& settings = project.segmentation;
    Json takes = Json::array();
    forTakes(project, options.take, [&](std::size_t take) {
        Json players = Json::array();
        for (const FighterAnalysis& fighter : analysis.takes[take]) {
            players.push_back(playerJson(fighter, settings.prominence, options));
        }
        takes.push_back({{"name", project.takes[take].name}, {"players", std::move(players)}});
    });
    const Json report = {{"cutoff_hz", settings.cutoff},
                         {"prominence_bw", settings.prominence},
                         {"curve", settings.curve == ForceCurve::Norm ? "norm" : "vertical"},
                         {"takes", std::move(takes)}};
    // Names may hold bytes that are no text.
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Findings smoothingFindings(const Project& project, const Analysis& analysis) {
    Findings findings;
    forTakes(project, {}, [&](std::size_t take) {
        for (const FighterAnalysis& fighter : analysis.takes[take]) {
            if (!fighter.force || fighter.force->force.smoothed) continue;
            findings.push_back(warning(fmt::format(
                "{}: a cutoff of {:g} Hz smooths nothing at {:g} frames a second; choose one below "
                "{:g} Hz.",
                fighter.input.recording.path.filename().string(), project.segmentation.cutoff,
                fighter.input.rate, fighter.input.rate / 2)));
        }
    });
    return findings;
}

std::string actionsCsv(const Project& project, const Analysis& analysis, std::optional<int> take) {
    std::string text = "take,player,action,begin,end,peak,begin_s,end_s,peak_force,note\n";
    auto out = std::back_inserter(text);
    forTakes(project, take, [&](std::size_t t) {
        for (std::size_t player = 0; player < analysis.takes[t].size(); ++player) {
            const FighterAnalysis& fighter = analysis.takes[t][player];
            if (!fighter.available()) continue;
            for (std::size_t i = 0; i < fighter.segmentation->actions.size(); ++i) {
                const Action& action = fighter.segmentation->actions[i];
                const auto force = peakForce(fighter, action);
                fmt::format_to(
                    out, "{},{},{},{},{},{},{:.6f},{:.6f},{},{}\n", csvField(project.takes[t].name),
                    player + 1, i, action.begin, action.end, action.peak,
                    action.begin / fighter.input.rate, action.end / fighter.input.rate,
                    force ? fmt::format("{:.6f}", *force) : std::string(),
                    csvField(noteOf(fighter.input.notes, *fighter.segmentation, action)));
            }
        }
    });
    return text;
}

std::string forceCsv(const FighterAnalysis& fighter) {
    if (!fighter.force) {
        std::string missing;
        for (const Role role : fighter.input.roles.missing()) {
            missing += (missing.empty() ? "" : ", ") + std::string(roleName(role));
        }
        throw Error(fighter.input.recording.path.filename().string() +
                    ": no contact force without a body; no joint has the role " + missing + ".");
    }
    std::string text = "frame,time,com_x,com_y,com_z,fx,fy,fz,norm\n";
    auto out = std::back_inserter(text);
    const ContactForce& force = fighter.force->force;
    for (std::size_t i = 0; i < force.force.size(); ++i) {
        const Eigen::Vector3d& c = force.smoothedCom[i];
        const Eigen::Vector3d& f = force.force[i];
        fmt::format_to(out, "{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", i,
                       static_cast<double>(i) / fighter.input.rate, c.x(), c.y(), c.z(), f.x(),
                       f.y(), f.z(), f.norm());
    }
    return text;
}

}  // namespace kumite
