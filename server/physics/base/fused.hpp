#pragma once
// Products and sums in one instruction and one rounding, where loops over nodes spend their time. Said
// outright, because the compiler must not decide it: then debug and release would differ
// (cmake/Options.cmake).

#include "server/physics/base/vec3.hpp"

#include <cmath>

namespace windlass::physics {

/// factor x a + b.
inline Vec3 fused(double factor, const Vec3& a, const Vec3& b) {
    return {std::fma(factor, a.x(), b.x()), std::fma(factor, a.y(), b.y()), std::fma(factor, a.z(), b.z())};
}

/// a . b
inline double fused_dot(const Vec3& a, const Vec3& b) {
    return std::fma(a.z(), b.z(), std::fma(a.y(), b.y(), a.x() * b.x()));
}

} // namespace windlass::physics
