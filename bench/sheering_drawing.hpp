#pragma once
// The chart of bench/sheering_chart: every ship's yaw, period and loads beside what is published.

#include "bench/lab/draw/svg.hpp"
#include "rigs/sheering.hpp"

#include <vector>

namespace windlass::bench {

/// One row of the table.
struct SheeringRow {
    rigs::AnchoredShip ship;
    double wind = 0; ///< m/s
    bool underfoot = false;
    rigs::Sheering found;
};

/// Four panels beside one another with a line for every ship; rows of one ship follow one another. A dot for
/// every wind, in its colour, and one more for the second anchor underfoot; what practice has is shaded.
lab::Svg drawing_of(const std::vector<SheeringRow>& rows);

} // namespace windlass::bench
