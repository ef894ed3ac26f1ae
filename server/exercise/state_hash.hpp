#pragma once
// A number that differs when any bit of the physics differs.

#include "server/physics/ground_tackle.hpp"
#include "server/physics/ship.hpp"

#include <cstdint>
#include <cstring>

namespace windlass::exercise {

/// FNV-1a, 64 bit, over the bit patterns of doubles (Fowler, Noll, Vo).
class StateHash {
public:
    void add(double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        for (int byte = 0; byte < 8; ++byte) {
            hash_ = (hash_ ^ (bits >> (8 * byte) & 0xff)) * 1099511628211ULL;
        }
    }
    void add(const physics::Vec3& v) { add(v.x()), add(v.y()), add(v.z()); }
    void add(const physics::ShipState& ship);
    void add(const physics::GroundTackle& tackle);
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 14695981039346656037ULL;
};

} // namespace windlass::exercise
