#pragma once
// The ship's track over the ground, with anchors, swinging circle and anchor watch, as inline SVG.

#include "recorder/debrief/attempt.hpp"
#include "recorder/debrief/moments.hpp"

namespace windlass::debrief {

/// The track of another attempt; whose as in PlotLine.
struct OtherTrack {
    std::string name;
    const Attempt* attempt = nullptr;
    int whose = 0;
};

/// Where a ship at anchor can come to.
struct SwingingCircle {
    int side = 0;
    double x = 0, y = 0; ///< m, world, of the anchor
    double radius = 0;   ///< m, to the stern: the cable straight from anchor to bow, and the ship's length
};

/// Of each side whose anchor lies on the ground at the end.
std::vector<SwingingCircle> swinging_circles(const Attempt& attempt);

/// The <figure> with its sentence and its table; empty where no place of the ship was recorded. moments: the
/// page's, whose numbers are written at the places where they came. others: tracks laid over it.
std::string track_figure(const Attempt& attempt, const std::vector<Moment>& moments,
                         const std::vector<OtherTrack>& others);

} // namespace windlass::debrief
