#pragma once
// Particles of one chain that keep two radii apart, found by a spatial hash. Source: Mueller and others
// (2007), section 3.5 (distance constraint of one sign); Teschner, Heidelberger, Mueller, Pomeranets, Gross
// (2003), "Optimized spatial hashing for collision detection of deformable objects", VMV, for the hash.

#include "bench/methods/lumped_line.hpp"

#include <utility>

namespace windlass::lab {

class SelfCollision {
public:
    /// radius: m, of each particle. Neighbours within 2 radii along the chain (links of rest m) do not
    /// collide.
    SelfCollision(int nodes, double radius, double rest);

    /// Finds the pairs that may meet in this step: within three radii of each other.
    void find(const Field& places);

    /// Pushes those apart that are nearer than two radii, by their inverse masses (1/kg).
    void project(Field& places, const std::vector<double>& inverse_mass) const;

    /// Pairs that the last find() found.
    std::size_t pairs() const { return pairs_.size(); }

private:
    std::size_t bucket(int x, int y, int z) const;

    double radius_, reach_;
    int apart_; ///< least difference of numbers that may collide
    std::vector<std::array<int, 3>> cell_;
    std::vector<int> start_, members_; ///< where each bucket's particles begin in members_
    std::vector<std::pair<int, int>> pairs_;
};

} // namespace windlass::lab
