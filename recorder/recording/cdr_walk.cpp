#include "recorder/recording/cdr_walk.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace windlass::recording {

namespace {

using idl::Kind;
using idl::Member;
using idl::Type;
using mcap::Bytes;
using mcap::Damage;

class Walk {
public:
    Walk(Bytes payload, CdrVisitor& visitor) : visitor_(visitor) {
        if (payload.size() < 4 || payload[0] != 0 || payload[1] > 1)
            throw Damage("a payload is not plain CDR");
        swapped_ = payload[1] == 0; // big-endian
        cdr_ = payload.subspan(4);
    }

    void structure(const Type& type) {
        visitor_.begin_structure(type);
        for (const auto& member : type.members) {
            visitor_.member(member);
            if (member.sequence)
                sequence(member);
            else
                value(*member.type);
        }
        visitor_.end_structure();
    }

private:
    Bytes take(std::size_t size) {
        if (size > cdr_.size() - at_) throw Damage("a payload ends too early");
        const Bytes taken = cdr_.subspan(at_, size);
        at_ += size;
        return taken;
    }

    template <class Number>
    Number number() {
        // Numbers lie at multiples of their size, counted from behind the header.
        at_ = std::min((at_ + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number), cdr_.size());
        std::array<std::uint8_t, sizeof(Number)> bytes;
        std::ranges::copy(take(sizeof(Number)), bytes.begin());
        if (swapped_) std::ranges::reverse(bytes);
        return std::bit_cast<Number>(bytes);
    }

    void sequence(const Member& member) {
        const auto size = number<std::uint32_t>();
        // Each element has a byte at least: a length beyond that is damage, whatever the bound.
        if ((member.bound != 0 && size > member.bound) || size > cdr_.size() - at_)
            throw Damage(member.name + " has " + std::to_string(size) + " elements, which cannot be");
        if (member.type->kind == Kind::octet) {
            visitor_.octets(take(size));
            return;
        }
        visitor_.begin_sequence(size);
        for (std::uint32_t i = 0; i < size; ++i)
            value(*member.type);
        visitor_.end_sequence();
    }

    void text() {
        const auto size = number<std::uint32_t>(); // with the zero at its end
        const auto bytes = mcap::as_text(take(size));
        visitor_.text(bytes.substr(0, bytes.find('\0')));
    }

    void value(const Type& type) {
        switch (type.kind) {
        case Kind::boolean:
            return visitor_.boolean(number<std::uint8_t>() != 0);
        case Kind::octet:
            return visitor_.natural(number<std::uint8_t>());
        case Kind::int8:
            return visitor_.integer(number<std::int8_t>());
        case Kind::int16:
            return visitor_.integer(number<std::int16_t>());
        case Kind::int32:
            return visitor_.integer(number<std::int32_t>());
        case Kind::int64:
            return visitor_.integer(number<std::int64_t>());
        case Kind::uint16:
            return visitor_.natural(number<std::uint16_t>());
        case Kind::uint32:
            return visitor_.natural(number<std::uint32_t>());
        case Kind::uint64:
            return visitor_.natural(number<std::uint64_t>());
        case Kind::float32:
            return visitor_.real(number<float>());
        case Kind::float64:
            return visitor_.real(number<double>());
        case Kind::text:
            return text();
        case Kind::enumeration:
            return visitor_.enumerator(number<std::uint32_t>(), type);
        case Kind::structure:
            return structure(type);
        }
    }

    CdrVisitor& visitor_;
    Bytes cdr_;
    std::size_t at_ = 0;
    bool swapped_ = false;
};

} // namespace

void walk(const Type& type, Bytes payload, CdrVisitor& visitor) {
    Walk(payload, visitor).structure(type);
}

} // namespace windlass::recording
