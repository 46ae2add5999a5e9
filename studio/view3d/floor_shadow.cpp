#include "studio/view3d/floor_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kumite::studio {

namespace {

/// A ball of a limb as the floor sees it: a soft disc.
struct Disc {
    Eigen::Vector2f centre;
    float radius;
    float depth;  ///< optical depth in the middle
};

/// Balls along every bone; a higher one spreads its shadow over more floor.
std::vector<Disc> discsOf(const std::vector<Bone>& bones,
                          const std::vector<Eigen::Vector3f>& joints, float floor) {
    constexpr float kStep = 0.09F;
    constexpr float kSpread = 0.42F;  // metres of blur per metre of height
    std::vector<Disc> discs;
    for (const Bone& bone : bones) {
        // Fingers lie in the shadow of the hand.
        if (bone.fromRadius < 0.012) continue;
        const Eigen::Vector3f& from = joints[static_cast<std::size_t>(bone.from)];
        const Eigen::Vector3f& to = joints[static_cast<std::size_t>(bone.to)];
        const float length = (to - from).norm();
        const int steps = std::clamp(static_cast<int>(std::ceil(length / kStep)), 1, 12);
        for (int i = 0; i < steps; ++i) {
            const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(steps);
            const Eigen::Vector3f at = from + share * (to - from);
            const auto thick = static_cast<float>(
                bone.isHead ? 2 * bone.fromRadius
                            : bone.fromRadius + share * (bone.toRadius - bone.fromRadius));
            const float height = std::max(0.0F, at.y() - floor - thick);
            const float radius = 1.4F * thick + 0.015F + kSpread * height;
            const float area = 2 * thick * std::max(length / static_cast<float>(steps), thick);
            discs.push_back({{at.x(), at.z()}, radius, 0.9F * area / (radius * radius)});
        }
    }
    return discs;
}

std::uint8_t darknessOf(float depth) {
    return static_cast<std::uint8_t>(255.0F * (1 - std::exp(-depth)));
}

}  // namespace

void castShadow(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints,
                float floor, FloorShadow& shadow) {
    constexpr int kCells = FloorShadow::kCells;
    const std::vector<Disc> discs = discsOf(bones, joints, floor);
    Eigen::Vector2f low = Eigen::Vector2f::Constant(1e9F);
    Eigen::Vector2f high = Eigen::Vector2f::Constant(-1e9F);
    for (const Disc& disc : discs) {
        low = low.cwiseMin(disc.centre.array().operator-(disc.radius).matrix());
        high = high.cwiseMax(disc.centre.array().operator+(disc.radius).matrix());
    }
    shadow.darkness.assign(static_cast<std::size_t>(kCells) * kCells, 0);
    if (discs.empty()) return;
    shadow.centre = 0.5F * (low + high);
    shadow.extent = std::max(0.2F, (high - low).maxCoeff()) * kCells / (kCells - 4);
    const float cell = shadow.extent / kCells;
    const Eigen::Vector2f corner = shadow.centre.array() - shadow.extent / 2 + cell / 2;
    static thread_local std::array<float, static_cast<std::size_t>(kCells) * kCells> depth;
    depth.fill(0);
    for (const Disc& disc : discs) {
        const Eigen::Vector2f middle = (disc.centre - corner) / cell;
        const float reach = disc.radius / cell;
        const int top = std::max(0, static_cast<int>(std::ceil(middle.y() - reach)));
        const int bottom = std::min(kCells - 1, static_cast<int>(middle.y() + reach));
        for (int row = top; row <= bottom; ++row) {
            const float dy = (static_cast<float>(row) - middle.y()) / reach;
            const float width = reach * std::sqrt(std::max(0.0F, 1 - dy * dy));
            const int left = std::max(0, static_cast<int>(std::ceil(middle.x() - width)));
            const int right = std::min(kCells - 1, static_cast<int>(middle.x() + width));
            float* cells = depth.data() + static_cast<std::size_t>(row) * kCells;
            const float onRow = 1 - dy * dy;
            const float step = 1 / reach;
            float dx = (static_cast<float>(left) - middle.x()) * step;
            for (int column = left; column <= right; ++column, dx += step) {
                const float rest = onRow - dx * dx;
                cells[column] += disc.depth * rest * rest;
            }
        }
    }
    std::transform(depth.begin(), depth.end(), shadow.darkness.begin(), darknessOf);
}

}  // namespace kumite::studio
