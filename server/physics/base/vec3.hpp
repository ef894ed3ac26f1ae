#pragma once
// A vector of the model. World frame everywhere unless said otherwise: x east, y north, z up, metres.

#include <Eigen/Core>

namespace windlass::physics {

using Vec3 = Eigen::Vector3d;

} // namespace windlass::physics
