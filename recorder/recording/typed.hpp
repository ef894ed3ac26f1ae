#pragma once
// A recorded payload as the type that windlass.idl gives it today.

#include "recorder/mcap/bytes.hpp"

#include <windlass.h>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

namespace windlass::recording {

/// Opens a payload (CDR header and CDR). Throws mcap::Damage when it is no T.
template <class T>
T decode(mcap::Bytes payload) {
    namespace cdr = eprosima::fastcdr;
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
