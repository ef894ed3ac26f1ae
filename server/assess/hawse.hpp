#pragma once
// How the two cables of a moored ship lie about each other: open hawse, cross, elbow, round turn.

#include <Eigen/Core>

#include <span>

namespace windlass::assess {

using CableNodes =
    std::span<const Eigen::Vector3f>; ///< m, world, z up, from the hawse pipe's lip to the anchor

/// By how many half turns the line between the two lips has been turned against that between the two anchors,
/// port to starboard both times, as the cables remember it: they wind about each other by as much. Positive
/// where the ship has turned to starboard. Between -0.5 and 0.5 for anchors in line with the stream and an
/// open hawse, 0 for anchors on either bow.
///
/// It follows from the cables as they lie and needs no history. Cables that bend, slacken, slide along each
/// other or lie on the bottom do not change it; only ship and anchors do, as they move.
double half_turns_between(CableNodes port, CableNodes starboard);

/// Half turns in the hawse, as seamen count them: 0 open, 1 a cross, 2 an elbow, 3 a round turn, and one more
/// for each; each from an eighth of a turn before it is whole, so that a ship that sheers at the end of a
/// swing has neither more nor less. Positive: made by turning to starboard, and cleared to port. Negative:
/// the other way about.
int turns_in_hawse(CableNodes port, CableNodes starboard);

} // namespace windlass::assess
