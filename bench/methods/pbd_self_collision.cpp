#include "bench/methods/pbd_self_collision.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace windlass::lab {

SelfCollision::SelfCollision(int nodes, double radius, double rest)
    : radius_(radius),
      reach_(3 * radius),
      apart_(static_cast<int>(std::floor(2 * radius / rest * (1 + 1e-9))) + 1),
      cell_(nodes),
      start_(std::bit_ceil(static_cast<std::size_t>(2 * nodes)) + 1),
      members_(nodes) {}

std::size_t SelfCollision::bucket(int x, int y, int z) const {
    const auto mix = [](int v, unsigned prime) { return static_cast<unsigned>(v) * prime; };
    return (mix(x, 73856093U) ^ mix(y, 19349663U) ^ mix(z, 83492791U)) & (start_.size() - 2);
}

void SelfCollision::find(const Field& places) {
    const int n = places.size();
    const auto number = [this](double v) { // a chain that blew up must not end in undefined behaviour
        return static_cast<int>(std::clamp(std::floor(v / reach_), -1e9, 1e9));
    };
    std::ranges::fill(start_, 0);
    for (int i = 0; i < n; ++i) {
        cell_[i] = {number(places.x[i]), number(places.y[i]), number(places.z[i])};
        ++start_[bucket(cell_[i][0], cell_[i][1], cell_[i][2]) + 1];
    }
    for (std::size_t k = 1; k < start_.size(); ++k)
        start_[k] += start_[k - 1];
    std::vector<int>& end = start_; // fills each bucket from its end, so that start_ is right afterwards
    for (int i = n - 1; i >= 0; --i) {
        const std::size_t b = bucket(cell_[i][0], cell_[i][1], cell_[i][2]);
        members_[--end[b + 1]] = i;
    }
    // start_[b + 1] is now where bucket b begins.
    pairs_.clear();
    const auto look = [&](int i, int x, int y, int z) {
        const std::size_t b = bucket(x, y, z);
        const int last = b + 2 < start_.size() ? start_[b + 2] : n;
        for (int k = start_[b + 1]; k < last; ++k) {
            const int j = members_[k];
            if (j - i < apart_ || cell_[j] != std::array{x, y, z}) continue;
            if ((places.at(j) - places.at(i)).squaredNorm() < reach_ * reach_) pairs_.emplace_back(i, j);
        }
    };
    for (int i = 0; i < n; ++i)
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    look(i, cell_[i][0] + x, cell_[i][1] + y, cell_[i][2] + z);
}

void SelfCollision::project(Field& places, const std::vector<double>& inverse_mass) const {
    const double min = 2 * radius_;
    for (const auto& [i, j] : pairs_) {
        const Vec3 span = places.at(j) - places.at(i);
        const double squared = span.squaredNorm();
        const double sum = inverse_mass[i] + inverse_mass[j];
        if (squared >= min * min || sum == 0) continue;
        const double size = std::sqrt(squared);
        // Two in one place part upwards and downwards: any direction will do.
        const Vec3 unit = size > 0 ? Vec3(span / size) : Vec3::UnitZ();
        const Vec3 move = (min - size) / sum * unit;
        places.add(i, -inverse_mass[i] * move);
        places.add(j, inverse_mass[j] * move);
    }
}

} // namespace windlass::lab
