#pragma once
// The tide of an exercise: height and stream over time, as a table has them.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/base/vec3.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace windlass::exercise {

inline constexpr std::size_t kMaxTideRows = 64;
/// m, of the water over the chart's datum, in files and orders: the greatest range there is is some 16 m.
inline constexpr double kTideMin = -5, kTideMax = 20;

/// One row, as tables of tides and tidal streams have them, usually by the hour.
struct TideRow {
    double time = 0;            ///< s of the exercise
    double height = 0;          ///< m, of the water over the chart's datum
    double current_speed = 0;   ///< m/s
    double current_towards = 0; ///< rad clockwise from north
    bool operator==(const TideRow&) const = default;
};
template <class Visitor, physics::StateOf<TideRow> State>
void visit_state(Visitor& v, State& row);

/// Height and stream at an instant, or by how much both change.
struct Tide {
    double height = 0;                            ///< m
    physics::Vec3 stream = physics::Vec3::Zero(); ///< m/s, world, level
};

/// Between two rows height and stream (as a vector) go in straight lines; before the first and behind the
/// last they stay. rows: by time, none: no tide. time: s. By the hour a straight line is at most 0.1 m off a
/// semidiurnal tide of 6 m range.
Tide tide_at(std::span<const TideRow> rows, double time);

} // namespace windlass::exercise
