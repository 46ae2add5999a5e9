#include "core/interaction/label_term.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kumite {
namespace {

/// log(N + 1) of a row of counts, one of them taken away.
std::vector<double> logRow(const Eigen::MatrixXd& counts, int row, int without) {
    std::vector<double> logs(static_cast<std::size_t>(counts.cols()));
    for (Eigen::Index i = 0; i < counts.cols(); ++i)
        logs[static_cast<std::size_t>(i)] = std::log(counts(row, i) - (i == without) + 1);
    return logs;
}

void add(std::vector<double>& sum, const std::vector<double>& terms) {
    std::transform(sum.begin(), sum.end(), terms.begin(), sum.begin(), std::plus<>());
}

}  // namespace

std::string_view estimatorName(LabelEstimator estimator) {
    switch (estimator) {
        case LabelEstimator::Equ5:
            return "EQU5";
        case LabelEstimator::Equ6:
            return "EQU6";
        case LabelEstimator::Equ7:
            return "EQU7";
        case LabelEstimator::Uniform:
            break;
    }
    return "UNIFORM";
}

std::vector<LabelTriple> labelTriples(const std::vector<Transition>& transitions) {
    std::vector<LabelTriple> triples;
    triples.reserve(transitions.size());
    for (const Transition& t : transitions)
        triples.push_back({t.ownNode, t.opponentNode, t.nextNode});
    return triples;
}

LabelTerm::LabelTerm(LabelEstimator estimator, const Vocabulary& vocabulary, std::vector<Label> own,
                     std::vector<Label> opponent, const std::vector<LabelTriple>& triples)
    : estimator_(estimator), own_(std::move(own)), opponent_(std::move(opponent)) {
    const auto n1 = static_cast<Eigen::Index>(own_.size());
    const auto n2 = static_cast<Eigen::Index>(opponent_.size());
    ownCounts_ = Eigen::MatrixXd::Zero(n1, n1);
    opponentCounts_ = Eigen::MatrixXd::Zero(n2, n1);
    for (const LabelTriple& t : triples) {
        ++ownCounts_(t.own, t.next);
        ++opponentCounts_(t.opponent, t.next);
        if (estimator_ == LabelEstimator::Equ5) ++triples_[{t.own, t.opponent}][t.next];
    }
    if (estimator_ != LabelEstimator::Equ6) return;
    firstElement_.push_back(0);
    for (const Aspect& aspect : vocabulary.aspects)
        firstElement_.push_back(firstElement_.back() + static_cast<int>(aspect.qualifiers.size()));
    ownElements_ = Eigen::MatrixXd::Zero(firstElement_.back(), firstElement_.back());
    opponentElements_ = ownElements_;
    const auto count = [&](Eigen::MatrixXd& counts, const Label& given, const Label& next,
                           double times) {
        for (std::size_t m = 0; m < given.size(); ++m) {
            for (std::size_t k = 0; k < next.size(); ++k) {
                const int x = element(m, given);
                const int y = element(k, next);
                if (x >= 0 && y >= 0) counts(x, y) += times;
            }
        }
    };
    const auto score = [&](const Eigen::MatrixXd& counts, const std::vector<Label>& given) {
        Eigen::MatrixXd scores(static_cast<Eigen::Index>(given.size()), n1);
        for (Eigen::Index i = 0; i < scores.rows(); ++i) {
            for (Eigen::Index j = 0; j < n1; ++j)
                scores(i, j) = elementScore(counts, given[static_cast<std::size_t>(i)],
                                            own_[static_cast<std::size_t>(j)]);
        }
        return scores;
    };
    for (const LabelTriple& t : triples) {
        const Label& next = own_[static_cast<std::size_t>(t.next)];
        count(ownElements_, own_[static_cast<std::size_t>(t.own)], next, 1);
        count(opponentElements_, opponent_[static_cast<std::size_t>(t.opponent)], next, 1);
    }
    ownScores_ = score(ownElements_, own_);
    opponentScores_ = score(opponentElements_, opponent_);
}

/// Number of a label's element among all qualifiers of the vocabulary; -1: unknown.
int LabelTerm::element(std::size_t aspect, const Label& label) const {
    return label[aspect] == kUnknown ? -1 : firstElement_[aspect] + label[aspect];
}

double LabelTerm::elementScore(const Eigen::MatrixXd& counts, const Label& given,
                               const Label& next) const {
    double sum = 0;
    for (std::size_t m = 0; m < given.size(); ++m) {
        const int x = element(m, given);
        if (x < 0) continue;
        for (std::size_t k = 0; k < next.size(); ++k) {
            const int y = element(k, next);
            if (y < 0) continue;
            const int outcomes = firstElement_[k + 1] - firstElement_[k];
            const double all = counts.row(x).segment(firstElement_[k], outcomes).sum() + outcomes;
            sum += std::log((counts(x, y) + 1) / all);
        }
    }
    return sum;
}

std::vector<double> LabelTerm::scores(int own, int opponent, const LabelTriple* without) const {
    assert(own >= kAnyNode && own < nodeCount());
    const int missing = without ? without->next : -1;
    const std::size_t n = own_.size();
    if (estimator_ == LabelEstimator::Uniform) return std::vector<double>(n, 0.0);
    if (own == kAnyNode && opponent == kAnyNode) {
        return logRow(ownCounts_.colwise().sum(), 0, missing);
    }
    if (estimator_ == LabelEstimator::Equ6) {
        std::vector<double> sum(n, 0.0);
        for (std::size_t j = 0; j < n; ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            if (own != kAnyNode) sum[j] += ownScores_(own, column);
            if (opponent != kAnyNode) sum[j] += opponentScores_(opponent, column);
        }
        return sum;
    }
    if (opponent == kAnyNode) return logRow(ownCounts_, own, missing);
    if (own == kAnyNode) return logRow(opponentCounts_, opponent, missing);
    if (estimator_ == LabelEstimator::Equ7) {
        std::vector<double> sum = logRow(ownCounts_, own, missing);
        add(sum, logRow(opponentCounts_, opponent, missing));
        return sum;
    }
    std::vector<double> sum(n, 0.0);
    const auto row = triples_.find({own, opponent});
    if (row == triples_.end()) return sum;
    for (const auto& [next, count] : row->second)
        sum[static_cast<std::size_t>(next)] = std::log(count - (next == missing) + 1);
    return sum;
}

std::vector<double> LabelTerm::logProbabilities(int own, int opponent) const {
    std::vector<double> logs = scores(own, opponent, nullptr);
    const double all = logSum(logs);
    for (double& value : logs)
        value -= all;
    return logs;
}

std::vector<double> LabelTerm::probabilities(int own, int opponent) const {
    std::vector<double> values = logProbabilities(own, opponent);
    for (double& value : values)
        value = std::exp(value);
    return values;
}

double LabelTerm::logWithout(const LabelTriple& triple) const {
    std::vector<double> logs = scores(triple.own, triple.opponent, &triple);
    if (estimator_ == LabelEstimator::Equ6) {
        const Label& own = own_[static_cast<std::size_t>(triple.own)];
        const Label& opponent = opponent_[static_cast<std::size_t>(triple.opponent)];
        Eigen::MatrixXd ownElements = ownElements_;
        Eigen::MatrixXd opponentElements = opponentElements_;
        for (std::size_t k = 0; k < own.size(); ++k) {
            const int y = element(k, own_[static_cast<std::size_t>(triple.next)]);
            for (std::size_t m = 0; m < own.size() && y >= 0; ++m) {
                if (const int x = element(m, own); x >= 0) --ownElements(x, y);
                if (const int x = element(m, opponent); x >= 0) --opponentElements(x, y);
            }
        }
        for (std::size_t j = 0; j < logs.size(); ++j) {
            logs[j] = elementScore(ownElements, own, own_[j]) +
                      elementScore(opponentElements, opponent, own_[j]);
        }
    }
    return logs[static_cast<std::size_t>(triple.next)] - logSum(logs);
}

LabelTerm learnLabelTerm(const CoupledGraph& graph, int mover, LabelEstimator estimator) {
    const auto labelsOf = [&](int player) {
        std::vector<Label> labels;
        for (const GraphNode& node : graph.nodes[static_cast<std::size_t>(player)])
            labels.push_back(node.label);
        return labels;
    };
    return LabelTerm(estimator, *graph.vocabulary, labelsOf(mover), labelsOf(1 - mover),
                     labelTriples(graph.transitionsOf(mover)));
}

double logSum(const std::vector<double>& logs) {
    if (logs.empty()) return 0;
    const double top = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    for (const double value : logs)
        sum += std::exp(value - top);
    return top + std::log(sum);
}

}  // namespace kumite
