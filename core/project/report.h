#pragma once

#include <optional>
#include <string>

#include "core/base/finding.h"
#include "core/project/analysis.h"

namespace kumite {

/// What a report on segmentation holds beside the boundaries.
struct ReportOptions {
    std::optional<int> take;  ///< only this take; nothing: all
    bool allMinima = false;   ///< also those below the threshold (with `kept` false)
};

/// The segmentation as JSON, keys as the command line's contract names them: per take and player
/// `frames`, `rate`, `mass_coverage`, `minima`, `actions`, `added`, `unmatched_corrections`.
/// Without a recording a player has `missing` instead.
std::string segmentationJson(const Project& project, const Analysis& analysis,
                             const ReportOptions& options = {});

/// Warnings about fighters whose motion is not smoothed, because the cutoff is not below half of
/// their rate.
Findings smoothingFindings(const Project& project, const Analysis& analysis);

/// The actions as CSV: `take,player,action,begin,end,peak,begin_s,end_s,peak_force,note`. Actions
/// count from 0, as on the timeline; players from 1.
std::string actionsCsv(const Project& project, const Analysis& analysis, std::optional<int> take);

/// `frame,time,com_x,com_y,com_z,fx,fy,fz,norm`: smoothed centre of mass in metres, force in body
/// weights. Throws Error where a fighter has no force, naming the roles that are missing.
std::string forceCsv(const FighterAnalysis& fighter);

}  // namespace kumite
