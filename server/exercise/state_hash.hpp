#pragma once
// A number that differs when any bit of the state differs.

#include "server/physics/base/state_visitor.hpp"

#include <cstdint>
#include <cstring>

namespace windlass::exercise {

/// Fowler, Noll and Vo's FNV-1a on whole doubles instead of bytes: what is asked of it is that it differs, in
/// a microsecond, since a tick's picture carries it. Three lanes, so that the processor need not wait for one
/// multiplication before the next; value() is made of all three.
class StateHash final : public physics::ConstStateVisitor {
public:
    void number(const physics::FieldName&, double value) override { mix(0, value); }
    void integer(const physics::FieldName&, std::int64_t value) override {
        lane_[0] = stirred(lane_[0], static_cast<std::uint64_t>(value));
    }
    void numbers(const physics::FieldName&, const double* first, std::size_t count) override;
    void text(const physics::FieldName&, const std::string& value) override;

    std::uint64_t value() const {
        std::uint64_t hash = lane_[0];
        for (const std::uint64_t lane : {lane_[1], lane_[2]})
            hash = stirred(hash, lane);
        return hash;
    }

private:
    static std::uint64_t stirred(std::uint64_t hash, std::uint64_t bits) {
        hash = (hash ^ bits) * 1099511628211ULL;
        return hash ^ hash >> 32; // a product's low half knows nothing of the high bits
    }
    void mix(std::size_t lane, double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        lane_[lane] = stirred(lane_[lane], bits);
    }
    static constexpr std::uint64_t kOffset = 14695981039346656037ULL;
    std::uint64_t lane_[3] = {kOffset, kOffset + 1, kOffset + 2};
};

} // namespace windlass::exercise
