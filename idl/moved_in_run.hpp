#pragma once
// In which run a hand took its levers or moved one last, as its station knew it. Levers are states that are
// sent again and again: without this nobody who hears a hand for the first time can tell one that moves its
// levers from one that has lain on them since before.
//
// It is ExerciseStatus.run, as text in the USER_DATA of the writer ("moved_in_run=1795497986285"), which
// discovery tells of: before its first sample, and again when it changes. A writer that does not say so is
// one whose hand moves its levers.

#include "idl/wire.hpp"

#include <cstdint>
#include <vector>

namespace windlass::wire {

/// Says it of a writer of that participant, of a lever topic. Costs a message to every member when the run is
/// another than before, else nothing. Nothing either where there is no such writer.
void tell_moved_in_run(const Participant& participant, const WriterId& writer, std::uint64_t run);

/// What the writer of another member says; 0: nothing.
std::uint64_t told_moved_in_run(const Participant& participant, const WriterId& writer);

/// The run in a writer's USER_DATA; 0: none, or something else.
std::uint64_t moved_in_run_of(const std::vector<std::uint8_t>& user_data);

} // namespace windlass::wire
