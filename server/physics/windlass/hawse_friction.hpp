#pragma once
// Friction of the chain in its hawse pipe: it is bent over the deck's edge of the pipe and over its lip, and
// rubs on both as a belt on a drum that stands.

#include <cmath>
#include <numbers>

namespace windlass::physics {

/// rad, by which chain is bent between the deck, where it is level, and plumb under the lip: as the anchor
/// hangs for which UR A3 3.1.2 takes an efficiency of the hawse pipe, and 3.1.4 tests it.
inline constexpr double kBendToPlumb = 0.5 * std::numbers::pi;

/// Pull at the gypsy over pull outboard while paying out, the anchor hanging plumb (UR A3 3.1.2).
inline constexpr double kHawseEfficiency = 0.7;

/// How the cable runs through the hawse pipe.
struct CableInHawse {
    double bend = kBendToPlumb; ///< rad, in all; HawsePipe::bent()
    double twist = 0;           ///< rad, of each link against the next
};

/// Pull at the gypsy over pull outboard while paying out, e^(-mu bend) (capstan equation; its inverse while
/// heaving). mu is that of the efficiency with the anchor hanging: 0.227.
inline double hawse_efficiency(double bend) {
    return std::pow(kHawseEfficiency, bend / kBendToPlumb);
}

} // namespace windlass::physics
