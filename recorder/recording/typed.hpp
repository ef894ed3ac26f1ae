#pragma once
// A recorded payload, as the type that windlass.idl gives it today or along the IDL that it was recorded
// with.

#include "recorder/mcap/bytes.hpp"

#include "idl/cdr_walk.hpp"
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

/// idl::walk of what a file holds: throws mcap::Damage when it is not of that type.
inline void walk(const idl::Type& type, mcap::Bytes payload, idl::CdrVisitor& visitor) {
    try {
        idl::walk(type, payload, visitor);
    } catch (const idl::PayloadError& error) {
        throw mcap::Damage(error.what());
    }
}

} // namespace windlass::recording
