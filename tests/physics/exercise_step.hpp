#pragma once
// The step of an exercise, at which most of the physics is tested.

namespace windlass::physics {

inline constexpr double kStep = 1.0 / 300; ///< s

} // namespace windlass::physics
