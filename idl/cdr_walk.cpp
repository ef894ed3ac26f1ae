#include "idl/cdr_walk.hpp"

namespace windlass::idl {

namespace {

/// Visitor: CdrVisitor, or none at all.
template <class Visitor>
class Walk {
    static constexpr bool kVisits = std::is_same_v<Visitor, CdrVisitor>;

public:
    Walk(Bytes payload, Visitor& visitor) : in_(payload), visitor_(visitor) {}

    void structure(const Type& type) {
        if constexpr (kVisits) visitor_.begin_structure(type);
        for (const Member& member : type.members) {
            if constexpr (kVisits) visitor_.member(member);
            if (member.sequence)
                sequence(member);
            else
                value(*member.type);
        }
        if constexpr (kVisits) visitor_.end_structure();
    }

private:
    void sequence(const Member& member) {
        const auto size = in_.template number<std::uint32_t>();
        // Each element has a byte at least: a length beyond that is damage, whatever the bound.
        if ((member.bound != 0 && size > member.bound) || size > in_.left())
            throw PayloadError(member.name + " has " + std::to_string(size) + " elements, which cannot be");
        const Type& type = *member.type;
        if constexpr (kVisits) {
            if (type.kind == Kind::octet) return visitor_.octets(in_.numbers(size, 1));
            visitor_.begin_sequence(size);
        } else if (type.numbers > 0) {
            in_.numbers(std::uint64_t{size} * type.numbers, type.number_size);
            return;
        }
        for (std::uint32_t k = 0; k < size; ++k)
            value(type);
        if constexpr (kVisits) visitor_.end_sequence();
    }

    void value(const Type& type) {
        if constexpr (!kVisits)
            if (type.numbers > 0) {
                in_.numbers(type.numbers, type.number_size);
                return;
            }
        if (type.kind == Kind::structure) return structure(type);
        if (type.kind == Kind::text) {
            const std::string_view text = in_.text();
            if constexpr (kVisits) visitor_.text(text);
        } else if constexpr (kVisits) {
            number(type);
        }
    }

    void number(const Type& type) {
        if (type.kind == Kind::enumeration)
            return visitor_.enumerator(in_.template number<std::uint32_t>(), type);
        with_number_of(type.kind, [this](auto zero) {
            using Number = decltype(zero);
            if constexpr (std::is_same_v<Number, bool>)
                visitor_.boolean(in_.template number<std::uint8_t>() != 0);
            else if constexpr (std::is_floating_point_v<Number>)
                visitor_.real(in_.template number<Number>());
            else if constexpr (std::is_signed_v<Number>)
                visitor_.integer(in_.template number<Number>());
            else
                visitor_.natural(in_.template number<Number>());
        });
    }

    CdrReader in_;
    Visitor& visitor_;
};

struct Nobody {};

} // namespace

void walk(const Type& type, Bytes payload, CdrVisitor& visitor) {
    Walk(payload, visitor).structure(type);
}

void walk_lengths(const Type& type, Bytes payload) {
    Nobody nobody;
    Walk(payload, nobody).structure(type);
}

} // namespace windlass::idl
