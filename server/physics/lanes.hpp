#pragma once
// For loops over nodes and links. They are written without branches and with one array for each field, so
// that the compiler vectorises them.

/// Before a loop: the arrays in it do not overlap.
#define WINDLASS_LANES _Pragma("GCC ivdep")

/// Of a lambda called in such a loop: a call would end the vectors.
#define WINDLASS_INLINE __attribute__((always_inline))

namespace windlass::physics {

/// The largest of value(i), none of them negative, for i from first to last; 0 of none. In four lanes,
/// because the compiler must not make lanes of a maximum by itself.
template <class Value>
inline double largest_of(int first, int last, const Value& value) {
    double lane[4] = {};
    int i = first;
    for (; i + 3 <= last; i += 4)
        for (int k = 0; k < 4; ++k) {
            const double v = value(i + k);
            lane[k] = v > lane[k] ? v : lane[k];
        }
    for (; i <= last; ++i) {
        const double v = value(i);
        lane[0] = v > lane[0] ? v : lane[0];
    }
    const double a = lane[0] > lane[1] ? lane[0] : lane[1], b = lane[2] > lane[3] ? lane[2] : lane[3];
    return a > b ? a : b;
}

/// The largest of the given numbers, none of them negative; 0 of none.
inline double largest(const double* values, int count) {
    return largest_of(0, count - 1, [=](int i) WINDLASS_INLINE { return values[i]; });
}

} // namespace windlass::physics
