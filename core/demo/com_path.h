#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace kumite::demo {

inline constexpr double kGravity = 9.80665;  ///< m/s², as in method A2

/// Where the centre of mass shall be at a boundary between two actions, and the force there.
struct ComKnot {
    double time = 0;                                     ///< seconds
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< metres, y up
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
    double force = 0.8;                                  ///< vertical, body weights: a minimum
    double flight = 0;  ///< seconds without any force about this moment (half before, half after)
};

/// A dip in the force of one action, which cuts it in two where it should not.
struct ForceDip {
    double time = 0;   ///< seconds, where it is deepest
    double width = 0;  ///< seconds
    double depth = 0;  ///< body weights
};

/// A planned path of the centre of mass: between two knots the contact force has one peak (two
/// where a dip was asked for), at the knots its minima; in flight there is none.
///
/// Per action the vertical force is a smooth step from knot to knot plus (α + β u) (1 − u²ⁿ)²,
/// u from 1 to −1, α and β such that velocity and position arrive as wanted; n is 1 for short
/// actions and larger, a flatter top, for long ones, which would make the body bob too far. For
/// |β| < α that has one peak. The same without the step in x and z, n = 1. Where the wish needs
/// more than such a force can give, the knots' forces are lowered and then the positions give way.
class ComPath {
public:
    /// `dips[i]` belongs to the action between knots i and i + 1. Knots are moved to what the path
    /// really does.
    ComPath(std::vector<ComKnot>& knots, const std::vector<std::optional<ForceDip>>& dips);

    Eigen::Vector3d position(double time) const;
    Eigen::Vector3d velocity(double time) const;
    /// c̈ − g in body weights.
    Eigen::Vector3d force(double time) const;

private:
    struct Piece {
        double begin = 0;
        double duration = 0;
        Eigen::Vector3d position;
        Eigen::Vector3d velocity;
        /// Acceleration, m/s², as a polynomial of s = (t − begin)/duration.
        std::array<Eigen::Vector3d, 14> acceleration;
        std::optional<ForceDip> dip;

        Eigen::Vector3d accelerationAt(double time) const;
        Eigen::Vector3d velocityAt(double time) const;
        Eigen::Vector3d positionAt(double time) const;
    };

    const Piece& pieceAt(double time) const;
    void addFlight(double begin, double duration, const Eigen::Vector3d& position,
                   const Eigen::Vector3d& velocity);

    std::vector<Piece> pieces_;
};

}  // namespace kumite::demo
