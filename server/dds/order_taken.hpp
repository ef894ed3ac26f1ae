#pragma once
// Orders that went into the exercise, to the wire and back: what is read again is the same order, bit for
// bit.

#include "server/run/status.hpp"

#include "idl/types.hpp"

namespace windlass::dds {

/// Copies the order. Texts came by the wire and are within their bounds.
void convert(const run::OrderView& from, OrderTaken& to);

/// The order in the sample, which may be of a damaged recording: throws std::runtime_error when it is of a
/// kind, side or code that this program does not know.
run::OrderView order_view(const OrderTaken& sample);

} // namespace windlass::dds
