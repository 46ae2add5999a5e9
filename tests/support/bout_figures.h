#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/project/analysis.h"

namespace kumite::test {

/// How a fighter's segmentation compares with the truth.
struct CutFigures {
    int planned = 0;        ///< boundaries between actions
    int found = 0;          ///< minima that cut
    int matched = 0;        ///< within ±33 ms of a planned one, each used once
    int spurious = 0;       ///< found where the plan has a spurious minimum
    int spuriousInTop = 0;  ///< of these, among the top 5 % of suspects
    double f1() const { return planned + found > 0 ? 2.0 * matched / (planned + found) : 0; }
};

CutFigures compareCut(const FighterAnalysis& fighter, const nlohmann::json& truePlayer,
                      double rate);

/// What it takes to review a made bout as the window leads through it.
struct ReviewFigures {
    int decisions = 0;     ///< keys: one removes or keeps and goes on
    int removed = 0;       ///< spurious ones among them
    int spuriousLeft = 0;  ///< that nobody was led to
};

/// Judges the most suspicious minimum of both fighters by the truth, again and again until no
/// suspect is left; the order learns from every answer.
ReviewFigures reviewByTruth(Project project, const nlohmann::json& truePlayers, double rate);

/// What the motion of a fighter is like, whether made or recorded.
struct MotionFigures {
    double seconds = 0;
    double actionsPerSecond = 0;
    double meanVerticalForce = 0;
    double skate = 0;
    double deepestUnderFloor = 0;  ///< metres
    double sharpestKnee = 0;       ///< radians at the knee: 0 is folded, π straight
    double straightestKnee = 0;
    double sharpestElbow = 0;
    double straightestElbow = 0;
    double fastestHand = 0;  ///< m/s
    double fastestFoot = 0;
    double forceDeviation = 0;  ///< standard deviation of the curve, body weights
};

MotionFigures measureMotion(const FighterAnalysis& fighter);

/// What two fighters are like together.
struct PairFigures {
    double nearest = 0;  ///< between the centres of mass on the floor, metres
    double mean = 0;
    double farthest = 0;
    double overlapShare = 0;    ///< of frames with bodies more than 3 cm in each other
    double deepestOverlap = 0;  ///< metres
};

PairFigures measurePair(const Take& take, const std::vector<FighterAnalysis>& fighters);

/// Figures of the truth alone.
struct LabelFigures {
    int actions = 0;
    double baseline = 0;  ///< accuracy of calling everything others, with the best constant move
    std::map<std::string, int> techniques;
    std::map<std::string, int> moves;
    std::map<std::string, int> reacts;
    /// Mutual information, bits, between a technique and the opponent's that was in progress.
    double information = 0;
    /// The same with the opponent's shuffled: what a sample of this size shows by chance.
    double informationByChance = 0;
    /// Mutual information between the technique and the range.
    double informationOfRange = 0;
};

LabelFigures measureLabels(const nlohmann::json& truth);

}  // namespace kumite::test
