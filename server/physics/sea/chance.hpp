#pragma once
// What looks like chance and is none: the same numbers from the same seed, on every machine.

#include <cmath>
#include <cstdint>
#include <numbers>

namespace windlass::physics {

/// What a number is drawn for: so that one use more changes nothing of another.
enum class Chance : std::uint64_t { wind_sea, swell, gust, gust_across, fault };

/// Whole numbers stirred into one (splitmix64).
inline std::uint64_t stirred(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

/// 0..1, the number-th of a use.
inline double chance(std::uint32_t seed, Chance use, int number) {
    const auto key = (static_cast<std::uint64_t>(seed) << 16) + (static_cast<std::uint64_t>(use) << 8) +
                     static_cast<std::uint64_t>(number);
    return static_cast<double>(stirred(key) >> 11) * 0x1p-53;
}

/// 0..1, spread as evenly as chance would be on average: the golden ratio's multiples.
inline double golden(int number) {
    const double x = number * (std::numbers::phi - 1);
    return x - std::floor(x);
}

} // namespace windlass::physics
