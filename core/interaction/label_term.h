#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/interaction/coupled_graph.h"

namespace kumite {

/// How P(l' | l1, l2) is estimated (paper A, equations 7 to 11): from the counts of whole triples;
/// as a product over pairs of label elements; as P(l'|l1) · P(l'|l2). Uniform knows nothing.
enum class LabelEstimator { Equ5, Equ6, Equ7, Uniform };
std::string_view estimatorName(LabelEstimator estimator);  ///< "EQU7"

/// Nodes of one transition: all that the label term learns from.
struct LabelTriple {
    int own = 0;
    int opponent = 0;
    int next = 0;
};
std::vector<LabelTriple> labelTriples(const std::vector<Transition>& transitions);

/// The label term of one mover: the probability of each of the mover's nodes as the next one.
/// Every multinomial has the uniform Dirichlet prior (equation 16), so that no probability is ever
/// 0. Values; safe to read from any thread.
class LabelTerm {
public:
    LabelTerm() = default;
    /// `own` and `opponent` are the label sets L1 and L2 (of the whole recording, also where the
    /// triples are a part of it). EQU6 counts its outcomes over the whole vocabulary.
    LabelTerm(LabelEstimator estimator, const Vocabulary& vocabulary, std::vector<Label> own,
              std::vector<Label> opponent, const std::vector<LabelTriple>& triples);

    LabelEstimator estimator() const { return estimator_; }
    int nodeCount() const { return static_cast<int>(own_.size()); }

    /// Natural logarithms, one per own node; they are those of probabilities whose sum is 1.
    /// kAnyNode: the estimate that does not look there. For EQU7 that is equation 10 or 11.
    std::vector<double> logProbabilities(int own, int opponent) const;
    /// The same as probabilities.
    std::vector<double> probabilities(int own, int opponent) const;

    /// log P(next | own, opponent) of a term that had been learnt without this one triple, which
    /// must be one of those it was made from (leave one out).
    double logWithout(const LabelTriple& triple) const;

private:
    std::vector<double> scores(int own, int opponent, const LabelTriple* without) const;
    double elementScore(const Eigen::MatrixXd& counts, const Label& given, const Label& next) const;
    int element(std::size_t aspect, const Label& label) const;

    LabelEstimator estimator_ = LabelEstimator::Uniform;
    std::vector<Label> own_;
    std::vector<Label> opponent_;
    Eigen::MatrixXd ownCounts_;                                     ///< N(l1, l')
    Eigen::MatrixXd opponentCounts_;                                ///< N(l2, l')
    std::map<std::pair<int, int>, std::map<int, double>> triples_;  ///< N(l1, l2, l'), sparse
    // EQU6: element pairs. Elements are numbered through all aspects of the vocabulary.
    std::vector<int> firstElement_;
    Eigen::MatrixXd ownElements_;       ///< N(element of l1, element of l')
    Eigen::MatrixXd opponentElements_;  ///< N(element of l2, element of l')
    Eigen::MatrixXd ownScores_;         ///< Σ log P over the 49 pairs, by l1 and l'
    Eigen::MatrixXd opponentScores_;    ///< the same by l2 and l'
};

/// The label term of a mover from all its transitions.
LabelTerm learnLabelTerm(const CoupledGraph& graph, int mover, LabelEstimator estimator);

/// log Σ exp; subtracted from every entry it makes them logarithms of probabilities.
double logSum(const std::vector<double>& logs);

}  // namespace kumite
