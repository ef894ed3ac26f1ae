#pragma once
// A number that differs when any bit of the physics differs.

#include "server/physics/ground_tackle.hpp"
#include "server/physics/ship.hpp"

#include <cstdint>
#include <cstring>

namespace windlass::exercise {

/// Fowler, Noll and Vo's FNV-1a on whole doubles instead of bytes: what is asked of it is that it differs, in
/// a microsecond, since a tick's picture carries it. Three lanes, so that the processor need not wait for one
/// multiplication before the next; value() is made of all three.
class StateHash {
public:
    void add(double value) { mix(lane_[0], value); }
    void add(const physics::Vec3& v) { mix(lane_[0], v.x()), mix(lane_[1], v.y()), mix(lane_[2], v.z()); }
    void add(const physics::ShipState& ship);
    void add(const physics::GroundTackle& tackle);
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
    static void mix(std::uint64_t& lane, double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        lane = stirred(lane, bits);
    }
    static constexpr std::uint64_t kOffset = 14695981039346656037ULL;
    std::uint64_t lane_[3] = {kOffset, kOffset + 1, kOffset + 2};
};

} // namespace windlass::exercise
