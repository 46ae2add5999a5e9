#include "core/demo/two_bone.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace kumite::demo {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TwoBone bend(const Vector3d& root, const Vector3d& target, const Vector3d& pole, double upper,
             double lower) {
    constexpr double kStraightest = 0.9985;  // a knee or elbow never locks
    constexpr double kFolded = 0.33;         // about 38° at the joint: calf on thigh
    const Vector3d way = target - root;
    const double wanted = std::max(1e-6, way.norm());
    const double reach =
        std::clamp(wanted, kFolded * (upper + lower), kStraightest * (upper + lower));
    const Vector3d along = way / wanted;
    Vector3d side = pole - pole.dot(along) * along;
    if (side.norm() < 1e-6) side = along.unitOrthogonal();
    side.normalize();
    const double a = (upper * upper - lower * lower + reach * reach) / (2 * reach);
    const double height = std::sqrt(std::max(0.0, upper * upper - a * a));
    return {root + a * along + height * side, root + reach * along};
}

Matrix3d turnWithY(const Vector3d& along, const Vector3d& ahead) {
    Matrix3d turn;
    const Vector3d y = along.normalized();
    const Vector3d z = (ahead - ahead.dot(y) * y).normalized();
    turn << y.cross(z), y, z;
    return turn;
}

Matrix3d turnWithX(const Vector3d& along, const Vector3d& above) {
    Matrix3d turn;
    const Vector3d x = along.normalized();
    const Vector3d y = (above - above.dot(x) * x).normalized();
    turn << x, y, x.cross(y);
    return turn;
}

Matrix3d aboutX(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitX()).toRotationMatrix();
}
Matrix3d aboutY(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
}
Matrix3d aboutZ(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace kumite::demo
