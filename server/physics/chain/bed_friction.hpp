#pragma once
// Friction of the seabed on a node of the chain: Coulomb's law as a step sees it, linear in the speed after
// it.

#include "server/physics/base/symmetric_matrix.hpp"
#include "server/physics/chain/chain.hpp"

#include <vector>

namespace windlass::physics {

/// Speed below which seabed friction is viscous, m/s: chain held by half its friction creeps 0.2 m an hour.
inline constexpr double kFrictionCreep = 1e-4;

/// The whole of Coulomb's friction along the direction that the node slides, and in proportion to its speed
/// in every other direction along the bed.
struct BedFriction {
    Vec3 direction = Vec3::Zero(); ///< unit vector; zero: none, in proportion in every direction
    double max = 0;                ///< N, Coulomb's; 0: the seabed does not bear the node
    double damping = 0;            ///< N s/m

    /// N, against a node of that speed along the bed, m/s.
    Vec3 force(const Vec3& slide) const {
        return max * direction + damping * (slide - direction.dot(slide) * direction);
    }
};

/// In proportion to the speed in every direction; such that it is Coulomb's (most, N) at that speed along the
/// bed, m/s. Never pushes a node on, however wrong the speed.
inline BedFriction friction_in_proportion(double max, const Vec3& slide) {
    const double speed = slide.norm();
    return {.max = max, .damping = max / (speed > kFrictionCreep ? speed : kFrictionCreep)};
}

/// Coulomb's law and its slope at that speed along the bed, m/s: what Newton's method asks for.
inline BedFriction friction_about(double max, const Vec3& slide) {
    const double speed = slide.norm();
    const bool slides = speed > kFrictionCreep;
    return {.direction = (slides ? 1 / speed : 0) * slide,
            .max = max,
            .damping = max / (slides ? speed : kFrictionCreep)};
}

/// One of them at every node, an array for each figure.
struct FrictionField {
    Field direction;
    std::vector<double> max, damping;

    explicit FrictionField(int nodes) : direction(nodes), max(nodes), damping(nodes) {}
    BedFriction at(int i) const { return {direction.at(i), max[i], damping[i]}; }
    void set(int i, const BedFriction& friction) {
        direction.set(i, friction.direction);
        max[i] = friction.max, damping[i] = friction.damping;
    }
};

} // namespace windlass::physics
