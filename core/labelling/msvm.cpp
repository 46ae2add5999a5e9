#include "core/labelling/msvm.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>

#include <svm.h>

namespace kumite {

/// LIBSVM's form of a precomputed kernel: each row begins with its own number (from 1), value j of
/// it is the kernel against row j, and an index of −1 ends it.
struct MsvmKernel::Nodes {
    std::size_t size = 0;
    double gamma = 0;
    std::vector<svm_node> nodes;

    svm_node* row(std::size_t index) { return nodes.data() + index * (size + 2); }
    const svm_node* row(std::size_t index) const { return nodes.data() + index * (size + 2); }
};

namespace {

void fillRow(std::span<const float> squaredDistances, double gamma, svm_node* nodes) {
    const auto scale = static_cast<float>(-gamma);
    for (std::size_t j = 0; j < squaredDistances.size(); ++j) {
        nodes[j + 1] = {static_cast<int>(j + 1),
                        static_cast<double>(std::exp(scale * squaredDistances[j]))};
    }
    nodes[squaredDistances.size() + 1] = {-1, 0};
}

/// Probabilities and votes come from different fits and may disagree about a close call; what is
/// chosen is what the votes say. This makes the probabilities the nearest ones (least squares) of
/// which none is above the chosen class's: it and all that are likelier share alike. Gives the
/// likeliest of the others.
std::size_t agreeWithVotes(std::vector<double>& probabilities, std::size_t chosen) {
    std::vector<std::size_t> others(probabilities.size());
    std::iota(others.begin(), others.end(), std::size_t{0});
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(chosen));
    std::stable_sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
        return probabilities[a] > probabilities[b];
    });
    double share = probabilities[chosen];
    std::size_t sharing = 0;
    while (sharing < others.size() && probabilities[others[sharing]] > share) {
        const auto before = static_cast<double>(sharing + 1);
        share = (share * before + probabilities[others[sharing]]) / (before + 1);
        ++sharing;
    }
    probabilities[chosen] = share;
    for (std::size_t i = 0; i < sharing; ++i)
        probabilities[others[i]] = share;
    return others.front();
}

std::mutex& randomGenerator() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

MsvmKernel::MsvmKernel(const FeatureMatrix& squaredDistances, double gamma)
    : nodes_(std::make_unique<Nodes>()) {
    assert(squaredDistances.rows() == squaredDistances.cols());
    nodes_->size = static_cast<std::size_t>(squaredDistances.rows());
    nodes_->gamma = gamma;
    nodes_->nodes.resize(nodes_->size * (nodes_->size + 2));
    for (std::size_t i = 0; i < nodes_->size; ++i) {
        svm_node* row = nodes_->row(i);
        row[0] = {0, static_cast<double>(i + 1)};
        fillRow({squaredDistances.row(static_cast<Eigen::Index>(i)).data(), nodes_->size}, gamma,
                row);
    }
}

MsvmKernel::~MsvmKernel() = default;

int MsvmKernel::size() const {
    return static_cast<int>(nodes_->size);
}

double MsvmKernel::gamma() const {
    return nodes_->gamma;
}

struct Msvm::Model {
    svm_model* svm = nullptr;
    double gamma = 0;
    std::size_t kernelSize = 0;
    /// What prediction needs of a support vector: its number. So the kernel need not be kept.
    std::vector<svm_node> numbers;

    ~Model() {
        if (svm) svm_free_and_destroy_model(&svm);
    }

    Answer answer(const svm_node* row) const {
        const auto classes = static_cast<std::size_t>(svm->nr_class);
        std::vector<double> decisions(classes * (classes - 1) / 2);
        Answer answer;
        answer.choice = static_cast<int>(svm_predict_values(svm, row, decisions.data()));
        answer.margin = std::numeric_limits<double>::infinity();
        std::size_t chosen = 0;
        while (svm->label[chosen] != answer.choice)
            ++chosen;
        std::size_t pair = 0;
        std::size_t second = chosen;
        const auto against = [&](std::size_t other, double margin) {
            if (margin >= answer.margin) return;
            answer.margin = margin;
            second = other;
        };
        for (std::size_t i = 0; i < classes; ++i) {
            for (std::size_t j = i + 1; j < classes; ++j, ++pair) {
                if (i == chosen) against(j, decisions[pair]);
                if (j == chosen) against(i, -decisions[pair]);
            }
        }
        if (svm->probA) {
            std::vector<double> probabilities(classes);
            svm_predict_probability(svm, row, probabilities.data());
            second = agreeWithVotes(probabilities, chosen);
            answer.probability = probabilities[chosen];
            answer.secondProbability = probabilities[second];
        }
        answer.second = svm->label[second];
        return answer;
    }
};

Msvm::Msvm(const MsvmKernel& kernel, std::span<const int> rows, std::span<const int> classes,
           double c, bool probabilities, std::uint32_t seed)
    : model_(std::make_unique<Model>()) {
    assert(rows.size() == classes.size());
    std::map<int, int> counts;
    for (const int each : classes)
        ++counts[each];
    assert(counts.size() > 1);
    std::vector<int> names;
    std::vector<double> weights;
    for (const auto& [name, count] : counts) {
        names.push_back(name);
        weights.push_back(static_cast<double>(rows.size()) /
                          (static_cast<double>(counts.size()) * count));
    }

    svm_parameter parameter{};
    parameter.svm_type = C_SVC;
    parameter.kernel_type = PRECOMPUTED;
    parameter.cache_size = 64;
    parameter.eps = 1e-3;
    parameter.C = c;
    parameter.nr_weight = static_cast<int>(names.size());
    parameter.weight_label = names.data();
    parameter.weight = weights.data();
    parameter.shrinking = 1;
    parameter.probability = probabilities ? 1 : 0;

    std::vector<double> targets(classes.begin(), classes.end());
    std::vector<svm_node*> vectors;
    for (const int row : rows)
        vectors.push_back(kernel.nodes_->row(static_cast<std::size_t>(row)));
    svm_problem problem{static_cast<int>(vectors.size()), targets.data(), vectors.data()};
    svm_set_print_string_function([](const char*) {});
    assert(svm_check_parameter(&problem, &parameter) == nullptr);

    if (probabilities) {
        const std::scoped_lock lock(randomGenerator());
        std::srand(seed);
        model_->svm = svm_train(&problem, &parameter);
    } else {
        model_->svm = svm_train(&problem, &parameter);
    }
    // Weights belong to this function; training is over.
    model_->svm->param.weight_label = nullptr;
    model_->svm->param.weight = nullptr;
    model_->svm->param.nr_weight = 0;
    model_->gamma = kernel.gamma();
    model_->kernelSize = kernel.nodes_->size;
    model_->numbers.resize(static_cast<std::size_t>(model_->svm->l));
    for (std::size_t i = 0; i < model_->numbers.size(); ++i) {
        model_->numbers[i] = model_->svm->SV[i][0];
        model_->svm->SV[i] = &model_->numbers[i];
    }
}

Msvm::~Msvm() = default;
Msvm::Msvm(Msvm&&) noexcept = default;
Msvm& Msvm::operator=(Msvm&&) noexcept = default;

Msvm::Answer Msvm::predict(std::span<const float> squaredDistances) const {
    assert(squaredDistances.size() == model_->kernelSize);
    std::vector<svm_node> row(squaredDistances.size() + 2);
    row[0] = {0, 0};
    fillRow(squaredDistances, model_->gamma, row.data());
    return model_->answer(row.data());
}

Msvm::Answer Msvm::predictRow(const MsvmKernel& kernel, int row) const {
    assert(kernel.nodes_->size == model_->kernelSize);
    return model_->answer(kernel.nodes_->row(static_cast<std::size_t>(row)));
}

}  // namespace kumite
