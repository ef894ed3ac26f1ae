#pragma once
// The bounds of the IDL's sequences. Fast DDS 2.9 enforces them neither when it writes nor when it reads: a
// sample of a hundred bytes that claims four thousand million nodes makes it take the memory for them first.

#include "idl/cdr.hpp"

namespace windlass::wire {

using idl::Bytes;

/// The payload of the type, made or heard, may be sent or opened: no sequence in it, those inside others
/// included, claims to be longer than its bound. Strings need no look: they are checked against the payload's
/// end.
bool claims_within_bounds(const idl::Type& type, Bytes payload);

/// The same for every type of topic_types.hpp.
template <class T>
bool claims_within_bounds(Bytes payload);

} // namespace windlass::wire
