#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/interaction/bout_numbers.h"
#include "core/interaction/geometry_term.h"
#include "core/interaction/label_term.h"

namespace kumite {

/// What is kept apart as a whole: neighbouring transitions share actions, so they are never dealt
/// out one by one.
enum class SplitBy { Blocks, Takes };

struct ValidationSettings {
    int seeds = 5;           ///< splits drawn
    std::uint32_t seed = 1;  ///< of the first one; the others count up
    SplitBy split = SplitBy::Blocks;
    double blockSeconds = 10;  ///< at most; shorter where the bout has fewer than nine such
    int components = 3;        ///< k of Tables 2 and 3
    int maxComponents = 12;    ///< of Fig. 11
    /// Of the geometry term. WithTarget: transitions without a target are left out of it.
    TransitionNumbers numbers = TransitionNumbers::Plain;
    GeometrySettings geometry;

    /// Of the Gaussians.
    int dimensions() const {
        return 6 * (3 + components) + (numbers == TransitionNumbers::WithTarget ? 2 : 0);
    }
};

enum class HoldoutSide : std::uint8_t { Training, Validation, LeftOut };

/// Two thirds of the blocks to learn from, one third to judge by. A transition belongs to the block
/// in which it happens; one of a validation block that shares an action with a training transition
/// (of either player) is left out.
struct BoutSplit {
    std::array<std::vector<HoldoutSide>, 2> sides;  ///< by mover and transition
    std::array<std::vector<bool>, 2> learnt;        ///< by player and action of B: part of training
};
/// Throws Error where there are fewer than two blocks or takes to deal out.
BoutSplit splitBout(const CoupledGraph& graph, const ValidationSettings& settings,
                    std::uint32_t seed);

/// Mean log probability or density per transition, over both players and all seeds.
struct Averages {
    double train = 0;
    double validation = 0;
    double deviation = 0;  ///< of validation, over the seeds
};

struct ValidationResult {
    int seeds = 0;
    std::array<double, 2> transitions{};   ///< mean number to learn from and to judge by, a player
    std::array<Averages, 4> labelTerm;     ///< by LabelEstimator (Table 2)
    std::array<Averages, 4> geometryTerm;  ///< by CovarianceKind (Table 3)
    Averages pooled;                       ///< one Gaussian for all labels, beside Table 3
    struct ComponentRow {
        int k = 0;
        double covered = 0;  ///< share of the training poses' variance
        Averages density;    ///< SEMITIED
        Averages gain;       ///< SEMITIED over one Gaussian for all labels of the same k (Fig. 11)
    };
    std::vector<ComponentRow> components;
    struct ShrinkageRow {
        double tau = 0;
        Averages density;  ///< SEMITIED
    };
    std::vector<ShrinkageRow> shrinkage;
};

/// The moments of a range of frames of a fighter: take, player, frames. Called from any thread.
using PoseSource = std::function<PoseMoments(int take, int player, FrameRange frames)>;

/// Tables 2 and 3 and Fig. 11 by repeated hold-out. Principal components, standardisation, counts
/// and Gaussians come from the training part alone; the label sets are those of the whole
/// recording. Deterministic; cancellable. Throws Error as splitBout.
ValidationResult crossValidate(const CoupledGraph& graph, const BoutNumbers& numbers,
                               const PoseSource& poses, const ValidationSettings& settings = {},
                               const Progress& progress = {});

}  // namespace kumite
