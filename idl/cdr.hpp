#pragma once
// Plain CDR (XCDR1), as payloads have it: four bytes that say the byte order, then one value behind the
// other; a number lies at a multiple of its size, counted from behind these four.

#include "idl/idl_schema.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace windlass::idl {

using Bytes = std::span<const std::uint8_t>;

/// A payload is not what its type says.
struct PayloadError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t kCdrHeader = 4;

/// Reads values of a payload one after the other. Throws PayloadError where it ends too early.
class CdrReader {
public:
    explicit CdrReader(Bytes payload) {
        if (payload.size() < kCdrHeader || payload[0] != 0 || payload[1] > 1)
            throw PayloadError("a payload is not plain CDR");
        swapped_ = (payload[1] == 1) != (std::endian::native == std::endian::little);
        body_ = payload.subspan(kCdrHeader);
    }

    template <class Number>
    Number number() {
        std::array<std::uint8_t, sizeof(Number)> bytes;
        std::ranges::copy(numbers(1, sizeof(Number)), bytes.begin());
        if (swapped_) std::ranges::reverse(bytes);
        return std::bit_cast<Number>(bytes);
    }

    /// Passes so many numbers of that size; their bytes, as they lie in the payload.
    Bytes numbers(std::uint64_t count, std::uint64_t size) {
        const std::uint64_t begin = count == 0 ? at_ : (at_ + size - 1) & ~(size - 1); // 1, 2, 4 or 8
        const std::uint64_t end = begin + count * size; // count is of 32 bits: no overflow
        if (end > body_.size()) throw PayloadError("a payload ends too early");
        at_ = end;
        return body_.subspan(begin, end - begin);
    }

    /// Up to the zero at its end.
    std::string_view text() {
        const Bytes bytes = numbers(number<std::uint32_t>(), 1);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        return text.substr(0, text.find('\0'));
    }

    std::uint64_t left() const { return body_.size() - at_; } ///< bytes

private:
    Bytes body_;
    std::uint64_t at_ = 0;
    bool swapped_ = false;
};

/// Writes a payload in this host's byte order.
class CdrWriter {
public:
    CdrWriter()
        : bytes_{0, std::endian::native == std::endian::little ? std::uint8_t{1} : std::uint8_t{0}, 0, 0} {}

    template <class Number>
    void number(Number value) {
        const auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(value);
        bytes_.resize(kCdrHeader +
                      (bytes_.size() - kCdrHeader + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number));
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    void text(std::string_view value) {
        number(static_cast<std::uint32_t>(value.size() + 1));
        bytes_.insert(bytes_.end(), value.begin(), value.end());
        bytes_.push_back(0);
    }
    void octets(std::string_view value) {
        number(static_cast<std::uint32_t>(value.size()));
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }
    std::vector<std::uint8_t> release() { return std::move(bytes_); }

private:
    std::vector<std::uint8_t> bytes_;
};

/// visit(0) with the C++ type of a kind that is a number or flag.
template <class Visit>
auto with_number_of(Kind kind, Visit&& visit) {
    switch (kind) {
    case Kind::boolean:
        return visit(false);
    case Kind::octet:
        return visit(std::uint8_t{});
    case Kind::int8:
        return visit(std::int8_t{});
    case Kind::int16:
        return visit(std::int16_t{});
    case Kind::uint16:
        return visit(std::uint16_t{});
    case Kind::int32:
        return visit(std::int32_t{});
    case Kind::uint32:
        return visit(std::uint32_t{});
    case Kind::int64:
        return visit(std::int64_t{});
    case Kind::uint64:
        return visit(std::uint64_t{});
    case Kind::float32:
        return visit(float{});
    case Kind::float64:
        return visit(double{});
    case Kind::enumeration:
    case Kind::text:
    case Kind::structure:
        break;
    }
    throw std::logic_error("no number");
}

} // namespace windlass::idl
