#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/project/edits.h"

// What the edits of boundaries share; no business of others.
namespace kumite::detail {

/// The fighter that an edit is about, with all that the edit looks at.
struct Subject {
    const Fighter& fighter;
    const FighterAnalysis& values;
    const Segmentation& segmentation;
    double reach;
    int player;

    Subject(const Project& project, const Analysis& analysis, FighterAddress address)
        : fighter(fighterAt(project, address)),
          values(analysis.at(address)),
          segmentation(require(values)),
          reach(kCorrectionReach * fighter.rate),
          player(address.player + 1) {}

    static const Segmentation& require(const FighterAnalysis& values) {
        if (values.segmentation) return *values.segmentation;
        throw Error(values.input.recording.path.string() +
                    ": the recording is missing; its boundaries cannot be edited.");
    }

    const ForceMinimum& minimum(int index) const {
        return values.force->minima[static_cast<std::size_t>(index)];
    }
    /// On the take's clock, as a timeline shows it: "at 1:08.80, fighter 2".
    std::string at(int frame) const {
        const long long hundredths = std::llround(100 * timeOfFrame(fighter, frame));
        const long long whole = std::llabs(hundredths);
        return fmt::format("at {}{}:{:02}.{:02}, fighter {}", hundredths < 0 ? "-" : "",
                           whole / 6000, whole / 100 % 60, whole % 100, player);
    }
};

/// The boundary that a user means by a frame: the nearest within reach.
const Boundary& boundaryNear(const Subject& subject, int frame);

bool standsAt(const Subject& subject, int frame);

/// Whether a boundary other than `own`, not an end, stands within reach of a frame.
bool standsBesideAnother(const Subject& subject, int frame, std::optional<int> own);

/// The correction (its index) of a kind that means a minimum.
std::optional<std::size_t> correctionOf(const Subject& subject, Correction::Kind kind, int minimum);

Edit withCorrections(const Project& project, FighterAddress address,
                     std::vector<Correction> corrections, std::string name);

}  // namespace kumite::detail
