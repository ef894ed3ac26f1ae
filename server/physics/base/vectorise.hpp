#pragma once
// For loops over nodes and links. They are written without branches and with one array for each field, so
// that the compiler vectorises them.

#include <bit>
#include <cstdint>

/// Before a loop: the arrays in it do not overlap.
#define WINDLASS_VECTORISE _Pragma("GCC ivdep")

/// Of what is called in such a loop: a call would end the vectors, and whether the compiler makes one hangs
/// on what else is in the file (test loops_call_nothing).
#define WINDLASS_INLINE __attribute__((always_inline))

/// Before a function of such loops: GCC compiles it a second time for vectors of 512 bits (AVX-512), and the
/// program takes the one that its processor has when it starts. The same bits: no loop here adds up across
/// lanes. The model without optimisation, which has no such twins, is held to the same hashes (./check
/// --long), as is that under sanitizers, which are not ready yet when the choice is made.
#if defined(__clang__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) ||                   \
    !defined(__OPTIMIZE__)
#define WINDLASS_WIDE
#else
#define WINDLASS_WIDE __attribute__((target_clones("avx512f", "default")))
#endif

namespace windlass::physics {

/// The largest of value(i), none of them negative, for i from first to last; 0 of none. Compared by their
/// bits, which have the order of the numbers they stand for: of floating-point maxima the compiler makes no
/// lanes. What is not a number is larger than all.
template <class Value>
inline double largest_of(int first, int last, const Value& value) {
    std::int64_t largest = 0;
    WINDLASS_VECTORISE
    for (int i = first; i <= last; ++i) {
        const auto bits = std::bit_cast<std::int64_t>(value(i));
        largest = bits > largest ? bits : largest;
    }
    return std::bit_cast<double>(largest);
}

/// The largest of the given numbers, none of them negative; 0 of none.
inline double largest(const double* values, int count) {
    return largest_of(0, count - 1, [=](int i) WINDLASS_INLINE { return values[i]; });
}

} // namespace windlass::physics
