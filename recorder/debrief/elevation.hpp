#pragma once
// A side elevation of the scene at a moment, as inline SVG in true shape: hull, water, bed, cable by its
// recorded nodes with its tension as width and colour, anchor.

#include "recorder/debrief/attempt.hpp"

namespace windlass::debrief {

/// Limits between the four classes of tension, N; the same for all pictures of a page.
using TensionLimits = std::array<double, 3>;

/// Round quarters of the largest tension in the pictures, at least 5, 10 and 15 t.
TensionLimits tension_limits(const std::vector<SceneAt>& scenes);

/// Class, 0 to 3, of a tension, N.
int tension_class(double tension, const TensionLimits& limits);

/// Upright plane that one looks at from abeam: that of lip and anchor, or the ship's own where the anchor
/// hangs under the lip.
struct Elevation {
    double x = 0, y = 0;  ///< m, world, of the lip
    double direction = 0; ///< rad clockwise from north, which lies to the right

    /// m to the right of the lip.
    double along(double at_x, double at_y) const;
};

/// side: whose cable it is seen across, 0 port, 1 starboard. Nothing without the ship, or that side's cable.
std::optional<Elevation> elevation_of(const SceneAt& scene, int side);

/// m, height of the bed over the still water; z = 0 is the still water.
double bed_height(const SeabedDescription& bed, double x, double y);

/// The <svg>. number: of the picture in its page, for its ids. words: what it shows, in a sentence. Empty
/// where nothing can be drawn.
std::string elevation_svg(const Attempt& attempt, const SceneAt& scene, int side, const TensionLimits& limits,
                          std::size_t number, std::string_view title, std::string_view words);

/// The <svg> that says what the classes look like.
std::string tension_key(const TensionLimits& limits);

} // namespace windlass::debrief
