#pragma once
// The bounds of the IDL's sequences. Fast DDS 2.9 enforces them neither when it writes nor when it reads: a
// sample of a hundred bytes that claims four thousand million nodes makes it take the memory for them first.

#include <windlass.h>

#include <cstdint>
#include <span>

namespace windlass::wire {

using Bytes = std::span<const std::uint8_t>;

/// Nothing in the sample is longer than its type allows: it may be written.
template <class T>
bool within_bounds(const T&) {
    return true;
}
bool within_bounds(const ExerciseStatus& sample);
bool within_bounds(const ChainState& sample);
bool within_bounds(const Assessment& sample);
bool within_bounds(const Checkpoint& sample);
bool within_bounds(const RestoreCommand& sample);
bool within_bounds(const ClassroomStatus& sample);
bool within_bounds(const ClassroomCommand& sample);

/// No sequence in the payload (CDR header first) claims more elements than its type allows: it may be
/// opened. Takes no memory. Strings need no look: they are checked against the payload's end.
template <class T>
bool claims_within_bounds(Bytes) {
    return true;
}
template <>
bool claims_within_bounds<ExerciseStatus>(Bytes payload);
template <>
bool claims_within_bounds<ChainState>(Bytes payload);
template <>
bool claims_within_bounds<Assessment>(Bytes payload);
template <>
bool claims_within_bounds<Checkpoint>(Bytes payload);
template <>
bool claims_within_bounds<RestoreCommand>(Bytes payload);
template <>
bool claims_within_bounds<ClassroomStatus>(Bytes payload);
template <>
bool claims_within_bounds<ClassroomCommand>(Bytes payload);

} // namespace windlass::wire
