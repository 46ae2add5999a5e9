#include "core/interaction/geometry_term.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/support/known_answers.h"

namespace kumite {
namespace {

constexpr std::array kKinds = {CovarianceKind::Full, CovarianceKind::FullRaw,
                               CovarianceKind::Diagonal, CovarianceKind::SemiTied};

Eigen::MatrixXd matrixOf(const nlohmann::json& rows) {
    Eigen::MatrixXd matrix(rows.size(), rows[0].size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < rows[i].size(); ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
    }
    return matrix;
}

/// Class numbers from 0 in the order of the file's names.
std::vector<int> classesOf(const nlohmann::json& names) {
    const auto all = names.get<std::vector<int>>();
    const int first = *std::min_element(all.begin(), all.end());
    std::vector<int> classes;
    for (const int each : all)
        classes.push_back(each - first);
    return classes;
}

int countOf(const std::vector<int>& classes) {
    return 1 + *std::max_element(classes.begin(), classes.end());
}

double meanDensity(const GeometryTerm& term, const Eigen::MatrixXd& samples,
                   const std::vector<int>& classes) {
    double sum = 0;
    for (std::size_t i = 0; i < classes.size(); ++i)
        sum += term.logDensity(samples.row(static_cast<Eigen::Index>(i)).transpose(), classes[i]);
    return sum / static_cast<double>(classes.size());
}

GeometrySettings plain(CovarianceKind kind) {
    GeometrySettings settings;
    settings.kind = kind;
    settings.shrinkage = 0;
    settings.eigenvalueFloor = 1e-12;
    settings.semiTied = {200, 1e-14};
    return settings;
}

class KnownSemiTied : public testing::TestWithParam<const char*> {};

TEST_P(KnownSemiTied, SweepsTransformAndDensities) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer(GetParam());
    const auto& input = known["input"];
    const auto& expected = known["expected"];
    const Eigen::MatrixXd samples = matrixOf(input["samples"]);
    const std::vector<int> classes = classesOf(input["classes"]);
    const auto moments = classMoments(samples, classes, countOf(classes));
    const SemiTied tied = trainSemiTied(moments, {200, 1e-14});
    const auto sweeps = expected["loglik_per_sweep"].get<std::vector<double>>();
    for (std::size_t i = 0; i < std::min(sweeps.size(), tied.logLikelihood.size()); ++i)
        EXPECT_NEAR(tied.logLikelihood[i], sweeps[i], 1e-7) << "sweep " << i;
    EXPECT_NEAR(tied.logLikelihood.back(), expected["final_loglik"], 1e-7);
    const Eigen::MatrixXd h = tied.transform.inverse();
    for (std::size_t m = 0; m < moments.size(); ++m) {
        const Eigen::MatrixXd wanted = matrixOf(expected["covariances"][m]);
        const Eigen::MatrixXd got = h * tied.variances[m].asDiagonal() * h.transpose();
        EXPECT_LT((got - wanted).norm(), 2e-3 * wanted.norm());
    }
    const Eigen::MatrixXd heldOut = matrixOf(input["held_out_samples"]);
    const std::vector<int> heldOutClasses = classesOf(input["held_out_classes"]);
    // Whole densities, through standardising and back.
    for (const auto& [kind, name] :
         {std::pair(CovarianceKind::SemiTied, "SEMITIED"), std::pair(CovarianceKind::Full, "FULL"),
          std::pair(CovarianceKind::FullRaw, "FULL"),
          std::pair(CovarianceKind::Diagonal, "DIAGONAL")}) {
        const GeometryTerm term(plain(kind), samples, classes, countOf(classes));
        const auto& densities = expected["average_log_density"][name];
        EXPECT_NEAR(meanDensity(term, samples, classes), densities["train"], 2e-6) << name;
        EXPECT_NEAR(meanDensity(term, heldOut, heldOutClasses), densities["held_out"], 2e-6)
            << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, KnownSemiTied,
                         testing::Values("semitied_one_class", "semitied_two_classes",
                                         "semitied_three_classes"));

TEST(SemiTied, SmallClassesAreDrawnTowardAll) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer("semitied_small_class");
    const auto& expected = known["expected"];
    const Eigen::MatrixXd samples = matrixOf(known["input"]["samples"]);
    const std::vector<int> classes = classesOf(known["input"]["classes"]);
    auto moments = classMoments(samples, classes, countOf(classes));
    shrinkToward(pooledCovariance(moments), known["input"]["tau"], moments);
    // It converges slowly: after 500 sweeps 1e-7 are still to come.
    const SemiTied tied = trainSemiTied(moments, {2000, 1e-13});
    const auto sweeps = expected["loglik_per_sweep"].get<std::vector<double>>();
    for (std::size_t i = 0; i < std::min(sweeps.size(), tied.logLikelihood.size()); ++i)
        EXPECT_NEAR(tied.logLikelihood[i], sweeps[i], 1e-7) << "sweep " << i;
    EXPECT_NEAR(tied.logLikelihood.back(), expected["final_loglik"], 1e-7);
    const Eigen::MatrixXd h = tied.transform.inverse();
    double sum = 0;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const ClassMoments& each = moments[static_cast<std::size_t>(classes[i])];
        const auto& variances = tied.variances[static_cast<std::size_t>(classes[i])];
        const Eigen::MatrixXd covariance = h * variances.asDiagonal() * h.transpose();
        const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
        const Eigen::VectorXd d = samples.row(static_cast<Eigen::Index>(i)).transpose() - each.mean;
        const Eigen::VectorXd u = factor.matrixL().solve(d);
        sum -= 0.5 * (u.squaredNorm() + 2 * factor.matrixLLT().diagonal().array().log().sum() +
                      static_cast<double>(d.size()) * std::log(2 * M_PI));
    }
    EXPECT_NEAR(sum / static_cast<double>(classes.size()), expected["average_log_density_train"],
                1e-6);
}

/// Correlated samples of classes of very different sizes, the last one without any.
struct Samples {
    Eigen::MatrixXd rows;
    std::vector<int> classes;
    int count = 0;
};
Samples madeSamples(const std::vector<int>& sizes, int dimensions, unsigned seed = 5) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto noise = [&](Eigen::Index rows, Eigen::Index columns) {
        Eigen::MatrixXd m(rows, columns);
        for (double& value : m.reshaped())
            value = normal(random);
        return m;
    };
    Samples made;
    made.count = static_cast<int>(sizes.size());
    for (std::size_t m = 0; m < sizes.size(); ++m)
        made.classes.insert(made.classes.end(), static_cast<std::size_t>(sizes[m]),
                            static_cast<int>(m));
    made.rows = noise(static_cast<Eigen::Index>(made.classes.size()), dimensions) *
                noise(dimensions, dimensions);
    for (std::size_t i = 0; i < made.classes.size(); ++i)
        made.rows.row(static_cast<Eigen::Index>(i)).array() += 0.5 * made.classes[i];
    return made;
}

TEST(SemiTied, TheLikelihoodNeverFalls) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Samples made = madeSamples({90, 40, 7, 2, 1, 0}, 12, seed);
        auto moments = classMoments(made.rows, made.classes, made.count);
        Eigen::MatrixXd pooled = pooledCovariance(moments);
        shrinkToward(pooled, 20, moments);
        const SemiTied tied = trainSemiTied(moments, {40, -1});
        ASSERT_EQ(tied.logLikelihood.size(), 41u);
        for (std::size_t i = 1; i < tied.logLikelihood.size(); ++i)
            EXPECT_GE(tied.logLikelihood[i], tied.logLikelihood[i - 1] - 1e-10);
        EXPECT_GT(tied.logLikelihood.back(), tied.logLikelihood.front() + 0.1);
    }
}

TEST(GeometryTerm, OneClassSemiTiedIsTheFullGaussian) {
    const Samples made = madeSamples({60}, 6);
    GeometrySettings settings;
    settings.semiTied = {300, 1e-13};
    const GeometryTerm tied(settings, made.rows, made.classes, 1);
    settings.kind = CovarianceKind::Full;
    const GeometryTerm full(settings, made.rows, made.classes, 1);
    for (Eigen::Index i = 0; i < 10; ++i) {
        const Eigen::VectorXd x = 1.3 * made.rows.row(i).transpose();
        EXPECT_NEAR(tied.logDensity(x, 0), full.logDensity(x, 0), 1e-6);
    }
}

TEST(GeometryTerm, TinyAndEmptyClassesAreNeverNaN) {
    const Samples made = madeSamples({30, 2, 1, 0}, 9);
    for (const CovarianceKind kind : kKinds) {
        for (const double tau : {0.0, 20.0}) {
            GeometrySettings settings;
            settings.kind = kind;
            settings.shrinkage = tau;
            const GeometryTerm term(settings, made.rows, made.classes, made.count);
            for (std::size_t i = 0; i < made.classes.size(); ++i) {
                const Eigen::VectorXd x = made.rows.row(static_cast<Eigen::Index>(i)).transpose();
                for (int label = 0; label < made.count; ++label)
                    EXPECT_TRUE(std::isfinite(term.logDensity(x, label)))
                        << covarianceName(kind) << " " << tau << " " << label;
                EXPECT_TRUE(std::isfinite(term.logDensityWithout(x, made.classes[i])));
            }
        }
    }
    // Fewer samples than dimensions.
    const Samples few = madeSamples({1, 2, 1, 3}, 9);
    for (const CovarianceKind kind : kKinds) {
        GeometrySettings settings;
        settings.kind = kind;
        settings.shrinkage = 0;
        const GeometryTerm term(settings, few.rows, few.classes, few.count);
        for (Eigen::Index i = 0; i < few.rows.rows(); ++i) {
            const Eigen::VectorXd x = few.rows.row(i).transpose();
            for (int label = 0; label < few.count; ++label)
                EXPECT_TRUE(std::isfinite(term.logDensity(x, label))) << covarianceName(kind);
        }
    }
    // One sample of one label; dimensions that never vary.
    for (const CovarianceKind kind : kKinds) {
        GeometrySettings settings;
        settings.kind = kind;
        const GeometryTerm term(settings, Eigen::MatrixXd::Ones(1, 9), std::vector{0}, 1);
        EXPECT_TRUE(std::isfinite(term.logDensity(Eigen::VectorXd::Ones(9), 0)));
        EXPECT_TRUE(std::isfinite(term.logDensityWithout(Eigen::VectorXd::Ones(9), 0)));
    }
}

TEST(GeometryTerm, AllDensitiesAtOnceAreThoseOneByOne) {
    const Samples made = madeSamples({30, 20, 1}, 9);
    for (const CovarianceKind kind : kKinds) {
        GeometrySettings settings;
        settings.kind = kind;
        const GeometryTerm term(settings, made.rows, made.classes, made.count);
        const Eigen::VectorXd x = made.rows.row(7).transpose();
        const std::vector<double> all = term.logDensities(x);
        ASSERT_EQ(all.size(), 3u);
        for (int label = 0; label < 3; ++label)
            EXPECT_EQ(all[static_cast<std::size_t>(label)], term.logDensity(x, label));
    }
}

TEST(GeometryTerm, TurnedPartsAddUp) {
    const Samples made = madeSamples({30, 20}, 9);
    for (const CovarianceKind kind : kKinds) {
        GeometrySettings settings;
        settings.kind = kind;
        const GeometryTerm term(settings, made.rows, made.classes, made.count);
        const Eigen::VectorXd x = made.rows.row(3).transpose();
        const Eigen::VectorXd sum =
            term.turnedPart(x.head(6), 0, 1) + term.turnedPart(x.tail(3), 6, 1);
        EXPECT_NEAR(term.logDensityAt(sum, 1), term.logDensity(x, 1), 1e-9);
    }
}

TEST(GeometryTerm, UnitsOfTheNumbersOnlyShiftTheDensity) {
    // Metres or centimetres: the same model, densities per metre or per centimetre.
    const Samples made = madeSamples({30, 20}, 4);
    for (const CovarianceKind kind : kKinds) {
        GeometrySettings settings;
        settings.kind = kind;
        const GeometryTerm metres(settings, made.rows, made.classes, made.count);
        const GeometryTerm centimetres(settings, 100 * made.rows, made.classes, made.count);
        const Eigen::VectorXd x = made.rows.row(40).transpose();
        EXPECT_NEAR(metres.logDensity(x, 1), centimetres.logDensity(100 * x, 1) + 4 * std::log(100),
                    1e-6);
    }
}

TEST(GeometryTerm, WithoutASampleItsClassIsAsIfLearntWithoutIt) {
    // DIAGONAL has no axes to keep, so that only standardising and W̄ differ: with many samples
    // hardly at all.
    const Samples made = madeSamples({1600, 5, 1}, 3);
    GeometrySettings settings;
    settings.kind = CovarianceKind::Diagonal;
    const GeometryTerm term(settings, made.rows, made.classes, made.count);
    for (const Eigen::Index i : {1602, 1605}) {
        const auto index = static_cast<std::size_t>(i);
        Eigen::MatrixXd rest(made.rows.rows() - 1, 3);
        rest << made.rows.topRows(i), made.rows.bottomRows(made.rows.rows() - i - 1);
        std::vector<int> classes = made.classes;
        classes.erase(classes.begin() + i);
        const GeometryTerm learnt(settings, rest, classes, made.count);
        const Eigen::VectorXd x = made.rows.row(i).transpose();
        const double without = term.logDensityWithout(x, made.classes[index]);
        EXPECT_NEAR(without, learnt.logDensity(x, made.classes[index]), 0.03) << i;
        EXPECT_LT(without, term.logDensity(x, made.classes[index]));
    }
}

}  // namespace
}  // namespace kumite
