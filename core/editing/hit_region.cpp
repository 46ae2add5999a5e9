#include "core/editing/hit_region.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace kumite {

using Eigen::Vector3d;

Box extendedBox(const StrikeSpace& space, const HitSettings& settings, double step, double most,
                const Progress& progress) {
    Box box = space.natural;
    std::array<bool, 6> grows;
    grows.fill(true);
    const int rounds = static_cast<int>(std::floor(most / step + 1e-9));
    for (int round = 0; round < rounds; ++round) {
        const Box before = box;
        std::array<bool, 6> hit{};
        forBlocks({0, 6}, 1, [&](FrameRange faces) {
            for (int face = faces.begin; face < faces.end; ++face) {
                if (!grows[static_cast<std::size_t>(face)]) continue;
                const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
                int hits = 0;
                for (int probe = 0; probe < 9; ++probe) {
                    Vector3d target;
                    target[axis] = face % 2 ? before.high[axis] + step : before.low[axis] - step;
                    for (const auto& [along, at] :
                         {std::pair(u, probe % 3), std::pair(v, probe / 3)})
                        target[along] =
                            before.low[along] + 0.5 * at * (before.high[along] - before.low[along]);
                    hits += solveHit(space, target, HitMethod::Best, settings).error <=
                            settings.tolerance;
                }
                hit[static_cast<std::size_t>(face)] = hits > 4;
            }
        });
        progress.update(static_cast<double>(round + 1) / rounds);
        for (int face = 0; face < 6; ++face) {
            const auto f = static_cast<std::size_t>(face);
            grows[f] = hit[f];
            if (!hit[f]) continue;
            face % 2 ? box.high[face / 2] += step : box.low[face / 2] -= step;
        }
        if (std::none_of(grows.begin(), grows.end(), [](bool g) { return g; })) break;
    }
    return box;
}

Coverage coverageOf(const StrikeSpace& space, const Box& box, double size,
                    const HitSettings& settings, const Progress& progress) {
    const Eigen::Vector3i counts =
        ((box.high - box.low) / size).array().round().max(1.0).cast<int>().matrix();
    Coverage coverage;
    coverage.cells = counts.prod();
    coverage.cell = box.volume() / coverage.cells;
    const Vector3d sides = (box.high - box.low).cwiseQuotient(counts.cast<double>());
    std::atomic<int> natural{0}, extended{0}, done{0};
    forBlocks({0, coverage.cells}, 8, [&](FrameRange block) {
        for (int i = block.begin; i < block.end; ++i) {
            const Eigen::Vector3i at(i % counts.x(), i / counts.x() % counts.y(),
                                     i / (counts.x() * counts.y()));
            const Vector3d target =
                box.low + sides.cwiseProduct((at.cast<double>().array() + 0.5).matrix());
            const HitSolution full = solveHit(space, target, HitMethod::Full, settings);
            const bool whole = full.error <= settings.tolerance;
            natural += whole;
            extended += whole || solveHit(space, target, HitMethod::Partial, settings).error <=
                                     settings.tolerance;
        }
        done += block.size();
        progress.update(static_cast<double>(done) / coverage.cells);
    });
    coverage.natural = natural;
    coverage.extended = extended;
    return coverage;
}

}  // namespace kumite
