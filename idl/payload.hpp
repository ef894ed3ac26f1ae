#pragma once
// A payload (CDR header and CDR), as it travels and is recorded, and the type that windlass.idl gives it.

#include "idl/bounds.hpp"
#include "idl/types.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace windlass::wire {

/// Opens a payload of a topic's type. Throws std::runtime_error when it is no T; a payload that claims a
/// sequence beyond its bound, as a hostile writer may have sent it, takes no memory.
template <class T>
T decode(Bytes payload) {
    namespace cdr = eprosima::fastcdr;
    if (!claims_within_bounds<T>(payload))
        throw std::runtime_error("a payload is not of its type: it claims a sequence beyond its bound");
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
        throw std::runtime_error(std::string("a payload is not of its type: ") + error.what());
    }
}

/// The payload of a value, as a writer on this host would send it.
template <class T>
std::vector<std::uint8_t> encode(const T& value) {
    namespace cdr = eprosima::fastcdr;
    std::vector<std::uint8_t> payload(4 + T::getCdrSerializedSize(value));
    cdr::FastBuffer buffer(reinterpret_cast<char*>(payload.data()), payload.size());
    cdr::Cdr out(buffer, cdr::Cdr::DEFAULT_ENDIAN, cdr::Cdr::DDS_CDR);
    out.serialize_encapsulation();
    value.serialize(out);
    payload.resize(out.getSerializedDataLength());
    return payload;
}

} // namespace windlass::wire
