#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/motion/motion.h"
#include "core/project/project.h"

namespace kumite::test {

/// A joint as tests write it: name, parent's index, offset, channels ("XYZxyz": capitals are
/// positions, small letters rotations; empty: an End Site).
struct JointSpec {
    std::string name;
    int parent = -1;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    std::string channels;
};

std::shared_ptr<const Skeleton> makeSkeleton(const std::vector<JointSpec>& joints);

/// A motion whose channel values a function of frame and column gives.
std::shared_ptr<const Motion> makeMotion(std::shared_ptr<const Skeleton> skeleton, int frames,
                                         double rate, const std::function<double(int, int)>& value);

/// A standing human, arms out, in centimetres, y up, facing +z, with Biovision names; hips at the
/// root's origin, which stands at 92 cm when the feet are on the floor. Root channels XYZzxy.
std::shared_ptr<const Skeleton> makeHuman();

/// Height of makeHuman's root over its toes, cm.
inline constexpr double kHumanRootHeight = 92.0;

/// makeHuman moved as a whole along y by `height(seconds)` metres, all rotations zero: its centre
/// of mass moves exactly so.
std::shared_ptr<const Motion> bobbing(int frames, double rate,
                                      const std::function<double(double)>& height);

/// A fighter of such a motion, in memory only.
Fighter makeFighter(std::shared_ptr<const Motion> motion, double rate);

/// A bout of two bobbing fighters with some ten force minima each at 60 Hz, 6 s long.
Project makeBout();

/// The bobbing of fighter `player` (0, 1) of makeBout: metres over seconds.
double boutHeight(int player, double seconds);

}  // namespace kumite::test
