#pragma once
// How an anchor moves in a step: as a rigid body, and its flukes on their pin. Seven ways in all.

#include "server/physics/base/vec3.hpp"

#include <Eigen/Geometry>

namespace windlass::physics {

using Vector6 = Eigen::Matrix<double, 6, 1>; ///< speed (m/s), then spin (rad/s); world
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using PointMotion = Eigen::Matrix<double, 3, 6>; ///< what a motion gives a point of the body of speed

/// What a motion of the body gives a point at the given arm (m, world) of speed.
inline PointMotion point_motion(const Vec3& arm) {
    PointMotion motion;
    motion.leftCols<3>().setIdentity();
    // spin x arm
    motion.rightCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    return motion;
}

/// Motion of the anchor: of its body (Vector6), then the rate of its flukes on their pin (rad/s).
using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

/// A point of an anchor, of its body or of its flukes.
struct AnchorPoint {
    Vec3 arm = Vec3::Zero();   ///< m, world, from the centre of mass
    Vec3 lever = Vec3::Zero(); ///< m, what a turn of the flukes gives the point; zero off them
};

/// m/s, of a point.
inline Vec3 point_velocity(const AnchorPoint& point, const Vector7& motion) {
    return point_motion(point.arm) * motion.head<6>() + point.lever * motion[6];
}

/// What an impulse (N s) at a point makes of the motion, by its inverse mass.
inline Vector7 pushed_by(const Vec3& impulse, const AnchorPoint& point, const Matrix7& yielding) {
    const Vector6 on_body = point_motion(point.arm).transpose() * impulse;
    return yielding.leftCols<6>() * on_body + yielding.col(6) * point.lever.dot(impulse);
}

/// The same of an impulse of 1 N s along each of the axes.
using AnchorPush = Eigen::Matrix<double, 7, 3>;
inline AnchorPush pushed_by(const AnchorPoint& point, const Matrix7& yielding) {
    const PointMotion at = point_motion(point.arm);
    return yielding.leftCols<6>() * at.transpose() + yielding.col(6) * point.lever.transpose();
}

/// 1/kg, of a point by itself.
inline Eigen::Matrix3d inverse_mass_at(const AnchorPoint& point, const Matrix7& yielding) {
    const PointMotion at = point_motion(point.arm);
    const Eigen::Matrix3d of_body = at * yielding.topLeftCorner<6, 6>() * at.transpose();
    const Vec3 both = at * yielding.topRightCorner<6, 1>() + 0.5 * yielding(6, 6) * point.lever;
    return of_body + (both * point.lever.transpose() + point.lever * both.transpose());
}

} // namespace windlass::physics
