#pragma once
// For loops over nodes and links. They are written without branches and with one array for each field, so
// that the compiler vectorises them.

/// Before a loop: the arrays in it do not overlap.
#define WINDLASS_LANES _Pragma("GCC ivdep")

/// Of a lambda called in such a loop: a call would end the vectors.
#define WINDLASS_INLINE __attribute__((always_inline))

namespace windlass::physics {

/// The largest of the given numbers, none of them negative; 0 of none. In four lanes, because the compiler
/// must not make lanes of a maximum by itself.
inline double largest(const double* values, int count) {
    double lane[4] = {};
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; ++k)
            lane[k] = values[i + k] > lane[k] ? values[i + k] : lane[k];
    for (; i < count; ++i)
        lane[0] = values[i] > lane[0] ? values[i] : lane[0];
    const double a = lane[0] > lane[1] ? lane[0] : lane[1], b = lane[2] > lane[3] ? lane[2] : lane[3];
    return a > b ? a : b;
}

} // namespace windlass::physics
