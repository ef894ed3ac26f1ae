#pragma once
// The bits of numbers, for runs that must agree to the last one.

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace windlass::physics {

inline std::vector<std::uint64_t> bits(std::span<const double> numbers) {
    std::vector<std::uint64_t> all;
    all.reserve(numbers.size());
    for (const double number : numbers)
        all.push_back(std::bit_cast<std::uint64_t>(number));
    return all;
}

} // namespace windlass::physics
