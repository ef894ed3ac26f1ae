#pragma once
// How a hanging cable's pull answers to its ends moving apart.

#include <algorithm>
#include <cmath>

namespace windlass::physics {

/// N/m at the top of inextensible chain of a weight of w (N/m) that hangs over a height (m) and lies beyond,
/// under a pull (N) at its top: 1 / (dx / dH), with dx / dH = (arcosh(1 + a) - 2 a / sqrt(a^2 + 2 a)) / w and
/// a = w height / H, by differentiating the catenary's span at a fixed length. A plumb cable's pull is taken
/// to have a hundredth of its weight across.
inline double catenary_spring(double w, double height, double pull) {
    const double plumb = w * height, a = plumb / std::max(pull - plumb, 0.01 * plumb);
    return w / (std::acosh(1 + a) - 2 * a / std::sqrt(a * a + 2 * a));
}

} // namespace windlass::physics
