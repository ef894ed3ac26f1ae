#pragma once
// A recorded payload as the type that windlass.idl gives it today.

#include "recorder/mcap/bytes.hpp"

#include "idl/payload.hpp"

namespace windlass::recording {

/// wire::decode of what a file holds: throws mcap::Damage when it is no T.
template <class T>
T decode(mcap::Bytes payload) {
    try {
        return wire::decode<T>(payload);
    } catch (const std::exception& error) {
        throw mcap::Damage(error.what());
    }
}

using wire::encode;

} // namespace windlass::recording
