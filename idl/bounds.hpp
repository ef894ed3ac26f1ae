#pragma once
// The bounds of the IDL's sequences. Fast DDS 2.9 enforces them neither when it writes nor when it reads: a
// sample of a hundred bytes that claims four thousand million nodes makes it take the memory for them first.

#include "idl/idl_schema.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace windlass::wire {

using Bytes = std::span<const std::uint8_t>;

/// How to get from the beginning of a type's CDR (XCDR1: a number of N bytes stands at a multiple of N) to
/// every length of a sequence in it, those inside other structures and sequences included. Made from the IDL,
/// so that no type is forgotten. Going along it takes no memory, and passes over a run of numbers in one
/// step.
class SequenceClaims {
public:
    /// Throws std::logic_error when a sequence of the type has no bound.
    explicit SequenceClaims(const idl::Type& type);

    /// No sequence in the payload (CDR header first) claims more elements than its type allows.
    bool fit(Bytes payload) const;

    /// Lengths are looked at in payloads of the type.
    bool any() const { return !steps_.empty(); }

private:
    enum class What : std::uint8_t { numbers, text, sequence };
    struct Step {
        What what;
        std::uint8_t bytes =
            0; ///< of each number, or of each in the sequence's elements; 0: of several sizes
        std::uint32_t count = 0; ///< of numbers in a row: here, or in each element of the sequence
        std::uint32_t bound = 0; ///< of the sequence
        std::uint32_t body = 0;  ///< steps behind this one that make one element, where bytes is 0
    };
    class Builder;
    class Walk;

    std::vector<Step> steps_; // as far as the last sequence
};

/// The sample's payload, made or heard, may be sent or opened: no sequence in it claims to be longer than its
/// bound. Strings need no look: they are checked against the payload's end. For every type of
/// topic_types.hpp.
template <class T>
bool claims_within_bounds(Bytes payload);

} // namespace windlass::wire
