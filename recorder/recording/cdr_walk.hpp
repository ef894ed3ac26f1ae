#pragma once
// Goes through a CDR payload along its IDL type, telling what it meets.

#include "idl/idl_schema.hpp"
#include "recorder/mcap/bytes.hpp"

namespace windlass::recording {

/// What is met, in the order of the type. All views are good during the call only.
class CdrVisitor {
public:
    virtual ~CdrVisitor() = default;
    virtual void begin_structure(const idl::Type&) {}
    virtual void member(const idl::Member&) {} ///< its value follows
    virtual void end_structure() {}
    virtual void begin_sequence(std::size_t size) = 0;
    virtual void end_sequence() = 0;
    virtual void boolean(bool value) = 0;
    virtual void integer(std::int64_t value) = 0;
    virtual void natural(std::uint64_t value) = 0;
    virtual void real(float value) = 0;
    virtual void real(double value) = 0;
    virtual void text(std::string_view value) = 0;
    virtual void enumerator(std::uint32_t value, const idl::Type& type) = 0; ///< may be beyond the type's
    virtual void octets(mcap::Bytes value) = 0;                              ///< a sequence of octets, as one
};

/// Throws mcap::Damage when the payload is not of that type (plain CDR of either byte order).
void walk(const idl::Type& type, mcap::Bytes payload, CdrVisitor& visitor);

} // namespace windlass::recording
