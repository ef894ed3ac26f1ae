#pragma once
// What a hand did with one lever, as the orders tell it: the places at which it stood, and the moves between
// them.

#include "server/assess/lever.hpp"
#include "server/run/status.hpp"

#include <span>
#include <vector>

namespace windlass::whatif {

using assess::Lever;
using assess::LeverKind;

/// From a tick on a lever stood at a place.
struct Place {
    std::uint64_t tick = 0;
    double value = 0;
};

/// Where a lever stood, from the beginning on; places differ from those before them.
using Track = std::vector<Place>;

double value_at(const Track& track, std::uint64_t tick);

/// Levers as they stood before any order.
struct LeversAtFirst {
    std::array<exercise::WindlassOrder, 2> windlass{}; ///< by side
    exercise::HelmOrder helm{};
};

Track track_of(const Lever& lever, const std::vector<run::OrderView>& orders, const LeversAtFirst& first,
               std::uint64_t first_tick);

/// Places first..last of a track that were one movement of the hand: the one way, without a pause of half a
/// second.
struct Move {
    std::size_t first = 1, last = 1;
};
std::vector<Move> moves_of(const Track& track, int tick_rate);

/// The orders with that lever as the track has it, and all else as it was. Where the track has a place and
/// no order was given, one is put in.
std::vector<run::OrderView> with_track(const std::vector<run::OrderView>& orders, const Lever& lever,
                                       const Track& track, const LeversAtFirst& first);

} // namespace windlass::whatif
