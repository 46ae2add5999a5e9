#include "core/synthesis/choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace kumite {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// What a unit of each of the last numbers adds to the turned numbers of a label.
Eigen::MatrixXd axesOf(const GeometryTerm& geometry, int first, int size, int label) {
    Eigen::VectorXd part = Eigen::VectorXd::Zero(size);
    const Eigen::VectorXd origin = geometry.turnedPart(part, first, label);
    Eigen::MatrixXd axes(origin.size(), size);
    for (int i = 0; i < size; ++i) {
        part[i] = 1;
        axes.col(i) = geometry.turnedPart(part, first, label) - origin;
        part[i] = 0;
    }
    return axes;
}

}  // namespace

ChoiceModel::ChoiceModel(LabelTerm labels, GeometryTerm geometry, const Eigen::MatrixXd& rows,
                         const std::vector<LabelTriple>& triples, std::vector<int> transitions,
                         int nextNumbers)
    : labels_(std::move(labels)),
      geometry_(std::move(geometry)),
      known_(static_cast<int>(rows.cols()) - nextNumbers) {
    const std::size_t samples = triples.size();
    assert(transitions.size() == samples && rows.rows() == static_cast<Eigen::Index>(samples));
    const auto nodes = static_cast<std::size_t>(labels_.nodeCount());
    first_.assign(nodes + 1, 0);
    if (samples == 0) return;
    std::vector<std::size_t> order(samples);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return triples[a].next < triples[b].next;
    });
    for (const LabelTriple& triple : triples)
        ++first_[at(triple.next) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());

    centre_ = rows.rightCols(nextNumbers).colwise().mean().transpose();
    next_.resize(nextNumbers, static_cast<Eigen::Index>(samples));
    squares_.resize(static_cast<Eigen::Index>(samples));
    for (std::size_t node = 0; node < nodes; ++node) {
        const int label = static_cast<int>(node);
        learnKnown(label, nextNumbers);
        axes_.push_back(axesOf(geometry_, known_, nextNumbers, label));
        for (int i = first_[node]; i < first_[node + 1]; ++i) {
            const auto row = static_cast<Eigen::Index>(order[at(i)]);
            next_.col(i) = rows.row(row).tail(nextNumbers).transpose() - centre_;
            squares_[i] = ((axes_.back() * next_.col(i)).array().square() /
                           geometry_.variances(label).array())
                              .sum();
        }
    }
    for (const std::size_t i : order)
        transitions_.push_back(transitions[i]);
}

/// The known numbers' part of a label's Gaussian: its inverse covariance is what is left of that of
/// all numbers when the next ones may be anything (Schur complement).
void ChoiceModel::learnKnown(int node, int nextNumbers) {
    const int all = known_ + nextNumbers;
    const Eigen::MatrixXd axes = axesOf(geometry_, 0, all, node);
    const Eigen::VectorXd origin = geometry_.turned(Eigen::VectorXd::Zero(all), node);
    const Eigen::MatrixXd inverse =
        axes.transpose() * geometry_.variances(node).cwiseInverse().asDiagonal() * axes;
    const Eigen::MatrixXd cross = inverse.topRightCorner(known_, nextNumbers);
    const Eigen::LLT<Eigen::MatrixXd> next(inverse.bottomRightCorner(nextNumbers, nextNumbers));
    const Eigen::MatrixXd marginal =
        inverse.topLeftCorner(known_, known_) - cross * next.solve(cross.transpose());
    Known& known = knowns_.emplace_back();
    known.mean = axes.partialPivLu().solve(geometry_.mean(node) - origin).head(known_);
    known.factor = marginal.llt().matrixU();
    known.peak =
        known.factor.diagonal().array().log().sum() - 0.5 * known_ * std::log(2 * std::numbers::pi);
}

std::vector<ChoiceModel::Candidate> ChoiceModel::candidates(int own, int opponent,
                                                            const Eigen::VectorXd& known,
                                                            ChoiceScore score) const {
    const std::vector<double> logs = labels_.logProbabilities(own, opponent);
    std::vector<Candidate> all(logs.size());
    double topGeometry = kNothing, topProduct = kNothing;
    const auto geometryOf = [score](const Candidate& each) {
        return score == ChoiceScore::Evidence ? each.logEvidence : each.logDensity;
    };
    Eigen::VectorXd scores;
    for (std::size_t n = 0; n < all.size(); ++n) {
        Candidate& each = all[n];
        each.node = static_cast<int>(n);
        each.label = std::exp(logs[n]);
        each.logDensity = each.logEvidence = each.logProduct = kNothing;
        const int count = first_[n + 1] - first_[n];
        if (count == 0) continue;
        // The squared distance of known + next is that of both alone and twice their product.
        const Eigen::VectorXd offset = geometry_.turnedPart(known, 0, each.node) +
                                       geometry_.turnedPart(centre_, known_, each.node) -
                                       geometry_.mean(each.node);
        const Eigen::VectorXd weighted = offset.cwiseQuotient(geometry_.variances(each.node));
        const Eigen::VectorXd slope = 2.0 * (axes_[n].transpose() * weighted);
        scores.noalias() = next_.middleCols(first_[n], count).transpose() * slope;
        scores += squares_.segment(first_[n], count);
        Eigen::Index best = 0;
        const double least = scores.minCoeff(&best);
        const double peak = geometry_.logDensityAt(geometry_.mean(each.node), each.node);
        each.transition = transitions_[at(first_[n] + static_cast<int>(best))];
        each.logDensity = peak - 0.5 * (offset.dot(weighted) + least);
        each.logEvidence =
            knowns_[n].peak -
            0.5 * (knowns_[n].factor.triangularView<Eigen::Upper>() * (known - knowns_[n].mean))
                      .squaredNorm();
        each.logProduct = geometryOf(each) + logs[n];
        topGeometry = std::max(topGeometry, geometryOf(each));
        topProduct = std::max(topProduct, each.logProduct);
    }
    double densities = 0, products = 0;
    for (Candidate& each : all) {
        if (each.transition < 0) continue;
        densities += each.geometry = std::exp(geometryOf(each) - topGeometry);
        products += each.product = std::exp(each.logProduct - topProduct);
    }
    for (Candidate& each : all) {
        if (each.transition < 0) continue;
        each.geometry /= densities;
        each.product /= products;
    }
    return all;
}

const Option& Options::drawn(double number) const {
    assert(possible());
    double sum = 0;
    for (const Option& option : options) {
        sum += option.chance;
        if (number < sum) return option;
    }
    // Rounding may leave the sum a hair below 1.
    return *std::find_if(options.rbegin(), options.rend(),
                         [](const Option& option) { return option.chance > 0; });
}

const Option* Options::find(int node) const {
    const auto found = std::find_if(options.begin(), options.end(), [&](const Option& option) {
        return option.candidate.node == node;
    });
    return found == options.end() ? nullptr : &*found;
}

Options optionsOf(const std::vector<ChoiceModel::Candidate>& candidates, const ChoiceRules& rules) {
    const auto allowed = [](const std::vector<char>& list, int node) {
        return list.empty() || list[static_cast<std::size_t>(node)] != 0;
    };
    const auto weight = [&](int node) {
        return rules.weights.empty() ? 1.0 : rules.weights[static_cast<std::size_t>(node)];
    };
    Options result;
    const auto any = [&](bool command, bool stance, bool ban) {
        return std::any_of(candidates.begin(), candidates.end(), [&](const auto& each) {
            return each.transition >= 0 && allowed(rules.mode, each.node) &&
                   (!command || allowed(rules.command, each.node)) &&
                   (!stance || allowed(rules.stance, each.node)) && (!ban || weight(each.node) > 0);
        });
    };
    // No dead ends: what was asked for last gives way last, the mode never.
    bool stance = true, command = true, ban = true;
    if (!any(command, stance, ban)) stance = false;
    if (!any(command, stance, ban)) command = false;
    if (!any(command, stance, ban)) ban = false;
    result.stanceGaveWay = !stance;
    result.commandGaveWay = !command;
    result.banGaveWay = !ban;

    double top = kNothing;
    for (const ChoiceModel::Candidate& each : candidates) {
        Option option{each, 0, Barred::No};
        if (each.transition < 0) {
            option.barred = Barred::NoSample;
        } else if (!allowed(rules.mode, each.node)) {
            option.barred = Barred::Mode;
        } else if (command && !allowed(rules.command, each.node)) {
            option.barred = Barred::Command;
        } else if (stance && !allowed(rules.stance, each.node)) {
            option.barred = Barred::Stance;
        } else if (ban && weight(each.node) <= 0) {
            option.barred = Barred::Ban;
        } else {
            // For now the logarithm; a ban that gave way counts as no wish at all.
            option.chance = each.logProduct + (ban ? std::log(weight(each.node)) : 0.0);
            top = std::max(top, option.chance);
        }
        result.options.push_back(option);
    }
    double sum = 0;
    for (Option& option : result.options) {
        if (option.barred != Barred::No) continue;
        const double below = option.chance - top;
        option.chance = rules.temperature > 0 ? std::exp(below / rules.temperature) : below == 0;
        sum += option.chance;
    }
    for (Option& option : result.options) {
        if (option.barred == Barred::No) option.chance /= sum;
    }
    std::stable_sort(result.options.begin(), result.options.end(),
                     [](const Option& a, const Option& b) {
                         if (a.chance != b.chance) return a.chance > b.chance;
                         return a.candidate.product > b.candidate.product;
                     });
    return result;
}

}  // namespace kumite
