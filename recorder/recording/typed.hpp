#pragma once
// A recorded payload as the type that windlass.idl gives it today.

#include "recorder/mcap/bytes.hpp"

#include "idl/bounds.hpp"
#include "idl/types.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

namespace windlass::recording {

/// Opens a payload (CDR header and CDR) of a topic's type. Throws mcap::Damage when it is no T; a payload
/// that claims a sequence beyond its bound, as a hostile writer may have sent it, takes no memory.
template <class T>
T decode(mcap::Bytes payload) {
    namespace cdr = eprosima::fastcdr;
    if (!wire::claims_within_bounds<T>(payload))
        throw mcap::Damage("a payload is not of its type: it claims a sequence beyond its bound");
    try {
        // The buffer is only read from; its interface does not say so.
        cdr::FastBuffer buffer(reinterpret_cast<char*>(const_cast<std::uint8_t*>(payload.data())),
                               payload.size());
        cdr::Cdr in(buffer, cdr::Cdr::DEFAULT_ENDIAN, cdr::Cdr::DDS_CDR);
        in.read_encapsulation();
        T value;
        value.deserialize(in);
        return value;
    } catch (const std::exception& error) {
        throw mcap::Damage(std::string("a payload is not of its type: ") + error.what());
    }
}

/// The payload of a value, as a writer on this host would send it.
template <class T>
mcap::Buffer encode(const T& value) {
    namespace cdr = eprosima::fastcdr;
    mcap::Buffer payload(4 + T::getCdrSerializedSize(value));
    cdr::FastBuffer buffer(reinterpret_cast<char*>(payload.data()), payload.size());
    cdr::Cdr out(buffer, cdr::Cdr::DEFAULT_ENDIAN, cdr::Cdr::DDS_CDR);
    out.serialize_encapsulation();
    value.serialize(out);
    payload.resize(out.getSerializedDataLength());
    return payload;
}

} // namespace windlass::recording
