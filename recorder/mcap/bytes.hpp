#pragma once
// Little-endian bytes of an MCAP file (mcap.dev/spec, "Serialization").

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace windlass::mcap {

static_assert(std::endian::native == std::endian::little, "integers are copied as they lie in memory");

using Buffer = std::vector<std::uint8_t>;
using Bytes = std::span<const std::uint8_t>;

/// What a file holds is not what it should be; what() says where and why.
struct Damage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline Bytes as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Appends to a buffer.
class Encoder {
public:
    explicit Encoder(Buffer& out) : out_(out) {}

    template <class Integer>
    Encoder& put(std::type_identity_t<Integer> value) {
        static_assert(std::is_integral_v<Integer>);
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
        out_.insert(out_.end(), bytes, bytes + sizeof value);
        return *this;
    }
    Encoder& raw(Bytes bytes) {
        out_.insert(out_.end(), bytes.begin(), bytes.end());
        return *this;
    }
    /// Length in a Size, then the bytes.
    template <class Size = std::uint32_t>
    Encoder& bytes(Bytes bytes) {
        return put<Size>(static_cast<Size>(bytes.size())).raw(bytes);
    }
    Encoder& text(std::string_view text) { return bytes(as_bytes(text)); }

    /// A length of 4 bytes to be known later, when what it counts has been appended: end(begin()).
    std::size_t begin() {
        put<std::uint32_t>(0);
        return out_.size();
    }
    void end(std::size_t begin) {
        const auto size = static_cast<std::uint32_t>(out_.size() - begin);
        std::memcpy(out_.data() + begin - sizeof size, &size, sizeof size);
    }

private:
    Buffer& out_;
};

/// Takes from bytes; throws Damage where they end too early.
class Decoder {
public:
    explicit Decoder(Bytes bytes) : rest_(bytes) {}

    template <class Integer>
    Integer get() {
        Integer value;
        std::memcpy(&value, cut(sizeof value).data(), sizeof value);
        return value;
    }
    Bytes cut(std::uint64_t size) {
        if (size > rest_.size()) throw Damage("a record ends too early");
        const Bytes taken = rest_.first(static_cast<std::size_t>(size));
        rest_ = rest_.subspan(taken.size());
        return taken;
    }
    template <class Size = std::uint32_t>
    Bytes bytes() {
        return cut(get<Size>());
    }
    std::string text() { return std::string(as_text(bytes())); }
    Bytes rest() const { return rest_; }
    bool empty() const { return rest_.empty(); }

private:
    Bytes rest_;
};

} // namespace windlass::mcap
