#include "server/physics/line_matrix.hpp"

#include "server/physics/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

double LineMatrix::eliminate(int first, int last) {
    double pivot_inverse = 1;
    for (int from = first; from <= last; from += kBlock) {
        const int until = std::min(from + kBlock, last + 1);
        // The rows below this block are known by the last of them alone; its minor counts as 1.
        const double upper_below = from == first ? 0 : upper[from - 1];
        double before = 1, minor = 1 - lower[from] * upper_below;
        double sum = right[from] + (from == first ? 0 : lower[from] * right[from - 1]);
        minor_[from] = minor, sum_[from] = sum;
        for (int i = from + 1; i < until; ++i) {
            const double next = std::fma(-(lower[i] * upper[i - 1]), before, minor);
            sum = std::fma(lower[i], sum, right[i] * minor);
            before = minor, minor = next;
            minor_[i] = minor, sum_[i] = sum;
        }
        right[from] = sum_[from] / minor_[from];
        upper[from] = upper[from] / minor_[from];
        WINDLASS_LANES
        for (int i = from + 1; i < until; ++i) {
            const double scale = 1 / minor_[i];
            right[i] = sum_[i] * scale;
            upper[i] = upper[i] * minor_[i - 1] * scale;
        }
        pivot_inverse = before / minor;
        if (until == from + 1) pivot_inverse = 1 / minor;
    }
    return pivot_inverse;
}

double LineMatrix::substitute(int first, int last) {
    double x = right[last], largest = std::abs(x);
    for (int i = last - 1; i >= first; --i) {
        x = std::fma(upper[i], x, right[i]);
        right[i] = x;
        largest = std::max(largest, std::abs(x));
    }
    return largest;
}

} // namespace windlass::physics
