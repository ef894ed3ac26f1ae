#pragma once
// The one walk through a payload along its type in the IDL: for the bounds of its sequences, JSON, CSV, and
// recordings whose types this program does not know.

#include "idl/cdr.hpp"

namespace windlass::idl {

/// What is met, in the order of the type. All views are good during the call only.
class CdrVisitor {
public:
    virtual ~CdrVisitor() = default;
    virtual void begin_structure(const Type&) {}
    virtual void member(const Member&) {} ///< its value follows
    virtual void end_structure() {}
    virtual void begin_sequence(std::size_t size) = 0;
    virtual void end_sequence() = 0;
    virtual void boolean(bool value) = 0;
    virtual void integer(std::int64_t value) = 0;
    virtual void natural(std::uint64_t value) = 0;
    virtual void real(float value) = 0;
    virtual void real(double value) = 0;
    virtual void text(std::string_view value) = 0;
    virtual void enumerator(std::uint32_t value, const Type& type) = 0; ///< may be beyond the type's
    virtual void octets(Bytes value) = 0;                               ///< a sequence of octets, as one
};

/// Throws PayloadError when the payload is not of that type (plain CDR of either byte order), or a sequence
/// is longer than its bound.
void walk(const Type& type, Bytes payload, CdrVisitor& visitor);

/// The same walk, which looks at nothing but lengths and passes over a run of numbers in one step. It takes
/// no memory where all is in order.
void walk_lengths(const Type& type, Bytes payload);

} // namespace windlass::idl
