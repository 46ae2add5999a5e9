#include "core/interaction/label_term.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/known_answers.h"

namespace kumite {
namespace {

const std::vector<LabelEstimator> kAll = {LabelEstimator::Equ5, LabelEstimator::Equ6,
                                          LabelEstimator::Equ7, LabelEstimator::Uniform};

/// A vocabulary of which only the numbers of qualifiers matter.
Vocabulary vocabularyOf(const std::vector<int>& qualifiers) {
    Vocabulary vocabulary;
    for (const int count : qualifiers) {
        Aspect& aspect = vocabulary.aspects.emplace_back();
        aspect.id = "aspect" + std::to_string(vocabulary.aspects.size());
        for (int i = 0; i < count; ++i)
            aspect.qualifiers.emplace_back().id = std::to_string(i);
    }
    return vocabulary;
}

struct Case {
    Vocabulary vocabulary;
    std::vector<Label> own, opponent;
    std::vector<LabelTriple> triples;

    LabelTerm term(LabelEstimator estimator) const {
        return LabelTerm(estimator, vocabulary, own, opponent, triples);
    }
};

double meanLog(const LabelTerm& term, const std::vector<LabelTriple>& triples) {
    double sum = 0;
    for (const LabelTriple& t : triples)
        sum += term.logProbabilities(t.own, t.opponent)[static_cast<std::size_t>(t.next)];
    return sum / static_cast<double>(triples.size());
}

class KnownLabelTerm : public testing::TestWithParam<const char*> {};

TEST_P(KnownLabelTerm, TablesAndAverages) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer(GetParam());
    const auto& input = known["input"];
    const auto& expected = known["expected"];
    Case c;
    c.vocabulary = vocabularyOf(input["qualifiers_per_aspect"].get<std::vector<int>>());
    std::map<int, int> node1, node2;
    for (const int id : expected["L1"]) {
        node1[id] = static_cast<int>(c.own.size());
        c.own.push_back(input["label_vectors"][std::to_string(id)].get<Label>());
    }
    for (const int id : expected["L2"]) {
        node2[id] = static_cast<int>(c.opponent.size());
        c.opponent.push_back(input["label_vectors"][std::to_string(id)].get<Label>());
    }
    const auto triplesOf = [&](const char* name) {
        std::vector<LabelTriple> triples;
        for (const auto& t : input[name])
            triples.push_back({node1.at(t[0]), node2.at(t[1]), node1.at(t[2])});
        return triples;
    };
    c.triples = triplesOf("transitions");
    const std::vector<LabelTriple> heldOut = triplesOf("held_out");
    for (const auto& [estimator, name] :
         {std::pair(LabelEstimator::Equ5, "equ5"), std::pair(LabelEstimator::Equ6, "equ6"),
          std::pair(LabelEstimator::Equ7, "equ7")}) {
        const LabelTerm term = c.term(estimator);
        for (std::size_t i = 0; i < c.own.size(); ++i) {
            for (std::size_t j = 0; j < c.opponent.size(); ++j) {
                const auto row = term.probabilities(static_cast<int>(i), static_cast<int>(j));
                for (std::size_t k = 0; k < row.size(); ++k) {
                    const double p = expected[name][i][j][k];
                    EXPECT_NEAR(row[k], p, 1e-9 + 1e-9 * p) << name;
                    EXPECT_NEAR(row[k] / p, 1, 1e-9) << name;
                }
            }
        }
        const std::string spelt(estimatorName(estimator));
        EXPECT_NEAR(meanLog(term, c.triples), expected["average_log"]["train"][spelt], 1e-9);
        EXPECT_NEAR(meanLog(term, heldOut), expected["average_log"]["held_out"][spelt], 1e-9);
    }
    const LabelTerm pairs = c.term(LabelEstimator::Equ7);
    for (std::size_t i = 0; i < c.own.size(); ++i) {
        const auto row = pairs.probabilities(static_cast<int>(i), kAnyNode);
        for (std::size_t k = 0; k < row.size(); ++k)
            EXPECT_NEAR(row[k], expected["own"][i][k], 1e-9);
    }
    for (std::size_t j = 0; j < c.opponent.size(); ++j) {
        const auto row = pairs.probabilities(kAnyNode, static_cast<int>(j));
        for (std::size_t k = 0; k < row.size(); ++k)
            EXPECT_NEAR(row[k], expected["opponent"][j][k], 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, KnownLabelTerm,
                         testing::Values("label_transitions_tiny", "label_transitions_six"));

/// Transitions drawn at random; the last label of each player occurs nowhere.
Case randomCase() {
    std::mt19937 random(7);
    Case c;
    c.vocabulary = vocabularyOf({5, 4, 3});
    const auto draw = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int i = 0; i < 6; ++i) {
        c.own.push_back({i % 5, i % 4, i / 2});
        c.opponent.push_back({i % 5, 3 - i % 4, i == 3 ? kUnknown : i % 3});
    }
    for (int i = 0; i < 60; ++i)
        c.triples.push_back({draw(5), draw(5), draw(5)});
    return c;
}

TEST(LabelTerm, RowsSumToOneAlsoForWhatWasNeverSeen) {
    const Case c = randomCase();
    for (const LabelEstimator estimator : kAll) {
        const LabelTerm term = c.term(estimator);
        for (int own = kAnyNode; own < 6; ++own) {
            for (int opponent = kAnyNode; opponent < 6; ++opponent) {
                double sum = 0;
                for (const double p : term.probabilities(own, opponent)) {
                    EXPECT_GT(p, 0);
                    sum += p;
                }
                EXPECT_NEAR(sum, 1, 1e-12) << estimatorName(estimator);
            }
        }
    }
}

TEST(LabelTerm, LeavingOneOutIsLearningWithoutIt) {
    const Case all = randomCase();
    for (const LabelEstimator estimator : kAll) {
        const LabelTerm term = all.term(estimator);
        for (std::size_t i = 0; i < all.triples.size(); i += 7) {
            Case rest = all;
            rest.triples.erase(rest.triples.begin() + static_cast<std::ptrdiff_t>(i));
            const LabelTriple& t = all.triples[i];
            const double expected = rest.term(estimator).logProbabilities(
                t.own, t.opponent)[static_cast<std::size_t>(t.next)];
            EXPECT_NEAR(term.logWithout(t), expected, 1e-9) << estimatorName(estimator);
        }
    }
}

TEST(LabelTerm, NothingToLearnFromIsAnEvenGuess) {
    Case c = randomCase();
    c.triples.clear();
    for (const LabelEstimator estimator : {LabelEstimator::Equ5, LabelEstimator::Equ7}) {
        for (const double p : c.term(estimator).probabilities(0, 0))
            EXPECT_NEAR(p, 1.0 / 6, 1e-12);
    }
    EXPECT_TRUE(LabelTerm().probabilities(kAnyNode, kAnyNode).empty());
}

}  // namespace
}  // namespace kumite
