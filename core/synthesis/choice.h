#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/interaction/geometry_term.h"
#include "core/interaction/label_term.h"
#include "core/interaction/pose_space.h"

namespace kumite {

/// What the geometry term of a candidate label is. BestSample, as in the paper: the density of its
/// best sample together with what is known, P(n¹ᵢ, n²ⱼ, n¹ᵢ₊₁ | l'). Labels with many samples have
/// better best ones whatever the moment is like, so that a bout drifts to what is frequent.
/// Evidence: the density of what is known alone, P(n¹ᵢ, n²ⱼ | l'), the integral of the same
/// Gaussian over n¹ᵢ₊₁. The sample of a label is the best one (equation 12) for both.
enum class ChoiceScore { Evidence, BestSample };

/// What a sample must go on from: the best one of a label is then the most probable together
/// with how near its first pose is, as if the distance (metres, over all joints) were normal
/// with deviation `spread`. Nothing: equation 12 alone.
struct Joining {
    const LocalPose* shown = nullptr;
    double spread = 0.14;
};

/// What a mover draws its next action from (paper A, 5.1.1; method A9): both terms of the
/// transition model, and the samples of every label laid out so that the best one (equation 12) of
/// all labels is found in one pass of a dozen multiplications a sample. A value; safe to read from
/// any thread.
class ChoiceModel {
public:
    ChoiceModel() = default;
    /// `rows`, one per transition of the mover: first the numbers that are known when it chooses
    /// (n¹ᵢ, n²ⱼ and, for an avatar, c), then n¹ᵢ₊₁. `transitions` are the transitions' indices in
    /// the graph, `triples` their nodes; both in the order of the rows. `geometry` was trained on
    /// these rows. No rows: a mover that can choose nothing.
    /// `firstPoses`: a column per row, the local pose (pose_space.h) with which the next action
    /// begins; empty: joins are not looked at.
    ChoiceModel(LabelTerm labels, GeometryTerm geometry, const Eigen::MatrixXd& rows,
                const std::vector<LabelTriple>& triples, std::vector<int> transitions,
                int nextNumbers, const Eigen::MatrixXf& firstPoses = {});

    const LabelTerm& labelTerm() const { return labels_; }
    int sampleCount() const { return static_cast<int>(transitions_.size()); }
    int knownNumbers() const { return known_; }
    /// Whether a node has a sample that could be shown.
    bool hasSample(int node) const { return first_[at(node)] < first_[at(node) + 1]; }

    /// A label that could come next.
    struct Candidate {
        int node = 0;
        double label = 0;        ///< label term: a probability
        double geometry = 0;     ///< see ChoiceScore; made to sum to 1 over the nodes
        double product = 0;      ///< both together, a probability
        double logDensity = 0;   ///< of the best sample, of the numbers as given
        double logEvidence = 0;  ///< of the known numbers
        double logProduct = 0;   ///< not normalised
        int transition = -1;     ///< of the graph: the best sample's; -1: the node has none
    };
    /// All nodes, in order. `known`: knownNumbers() numbers. kAnyNode leaves open what somebody
    /// does.
    std::vector<Candidate> candidates(int own, int opponent, const Eigen::VectorXd& known,
                                      ChoiceScore score = ChoiceScore::Evidence,
                                      const Joining& joining = {}) const;

private:
    static std::size_t at(int node) { return static_cast<std::size_t>(node); }
    void learnKnown(int node, int nextNumbers);

    LabelTerm labels_;
    GeometryTerm geometry_;
    int known_ = 0;
    std::vector<int> first_;        ///< by node, into the samples; one more than nodes
    std::vector<int> transitions_;  ///< by sample
    Eigen::VectorXd centre_;        ///< of n¹ᵢ₊₁
    Eigen::MatrixXd next_;          ///< a column per sample: n¹ᵢ₊₁ less the centre
    Eigen::MatrixXf firstPoses_;    ///< a column per sample; may be empty
    Eigen::VectorXd squares_;  ///< by sample: what n¹ᵢ₊₁ alone adds to the squared distance
    /// By node: what a unit of n¹ᵢ₊₁ adds to the turned numbers.
    std::vector<Eigen::MatrixXd> axes_;
    /// By node, the Gaussian of the known numbers alone.
    struct Known {
        Eigen::VectorXd mean;
        Eigen::MatrixXd factor;  ///< Fᵀ F is its inverse covariance; upper triangular
        double peak = 0;         ///< log density at the mean
    };
    std::vector<Known> knowns_;
};

/// Why a candidate may not be drawn.
enum class Barred { No, NoSample, Mode, Command, Stance, Ban };

/// What may be drawn, and how freely.
struct ChoiceRules {
    double temperature = 1;  ///< 0: always the likeliest; above 1: flatter
    /// By node, factors on the probability; 0 is a ban, which gives way where nothing else is left.
    std::vector<double> weights;
    /// By node: not barred by the mode (hard) and asked for by the command; empty: all.
    std::vector<char> mode, command;
    /// By node: begins in the stance that is shown; empty: all. Gives way before anything else.
    std::vector<char> stance;
};

/// A candidate with its chance to be drawn.
struct Option {
    ChoiceModel::Candidate candidate;
    double chance = 0;
    Barred barred = Barred::No;
};

/// Options of a moment: chances sum to 1 unless every node is barred by mode or lack of samples.
struct Options {
    std::vector<Option> options;  ///< by falling chance, then product, then node
    bool stanceGaveWay = false;
    bool commandGaveWay = false;
    bool banGaveWay = false;

    bool possible() const { return !options.empty() && options.front().chance > 0; }
    /// The option on which a number in [0, 1) falls.
    const Option& drawn(double number) const;
    const Option* find(int node) const;
};
Options optionsOf(const std::vector<ChoiceModel::Candidate>& candidates, const ChoiceRules& rules);

}  // namespace kumite
