#include "server/physics/base/line_matrix.hpp"

#include "server/physics/base/vectorise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

WINDLASS_WIDE
void LineMatrix::eliminate(int first, int last) {
    assert(0 <= first && first <= last && last < static_cast<int>(minor_.size()) && "rows that there are");
    for (int from = first; from <= last; from += kBlock) {
        const int until = std::min(from + kBlock, last + 1);
        // The rows below this block are known by the last of them alone; its minor counts as 1.
        const double upper_below = from == first ? 0 : upper[from - 1];
        double before = 1, minor = 1 - lower[from] * upper_below;
        double sum = right[from] + (from == first ? 0 : lower[from] * right[from - 1]);
        minor_[from] = minor, sum_[from] = sum;
        int i = from + 1;
        // Two rows at once: the second hangs on the minors before the first, too, and need not wait for it.
        for (; i + 1 < until; i += 2) {
            const double product = lower[i] * upper[i - 1], after = lower[i + 1] * upper[i];
            const double next = std::fma(-product, before, minor);
            const double next_but_one = std::fma(1 - after, minor, -(product * before));
            sum_[i] = std::fma(lower[i], sum, right[i] * minor);
            sum = std::fma(lower[i + 1] * lower[i], sum,
                           std::fma(lower[i + 1] * right[i], minor, right[i + 1] * next));
            sum_[i + 1] = sum;
            minor_[i] = before = next;
            minor_[i + 1] = minor = next_but_one;
        }
        if (i < until) {
            minor_[i] = std::fma(-(lower[i] * upper[i - 1]), before, minor);
            sum_[i] = std::fma(lower[i], sum, right[i] * minor);
        }
        const auto divide = [&](int i, double before) WINDLASS_INLINE {
            const double scale = 1 / minor_[i], pivot_inverse = before * scale;
            right[i] = sum_[i] * scale;
            upper[i] *= pivot_inverse;
            lower[i] *= pivot_inverse;
            diagonal_inverse[i] *= pivot_inverse;
        };
        divide(from, 1);
        WINDLASS_VECTORISE
        for (int i = from + 1; i < until; ++i)
            divide(i, minor_[i - 1]);
    }
}

void LineMatrix::substitute(int first, int last) {
    assert(0 <= first && first <= last && last < static_cast<int>(minor_.size()) && "rows that there are");
    const double* times = upper.data();
    double* x = right.data();
    double after = x[last];
    int i = last - 1;
    // Four rows are first made to hang on the x behind them all, so that of four only one has to wait for the
    // one behind it.
    for (; i - 3 >= first; i -= 4) {
        const double t0 = times[i], t1 = times[i - 1], t2 = times[i - 2], t3 = times[i - 3];
        const double x0 = x[i], x1 = std::fma(t1, x0, x[i - 1]), x2 = std::fma(t2, x1, x[i - 2]),
                     x3 = std::fma(t3, x2, x[i - 3]);
        const double t01 = t0 * t1, t012 = t01 * t2, t0123 = t01 * (t2 * t3);
        x[i] = std::fma(t0, after, x0);
        x[i - 1] = std::fma(t01, after, x1);
        x[i - 2] = std::fma(t012, after, x2);
        after = x[i - 3] = std::fma(t0123, after, x3);
    }
    for (; i >= first; --i)
        after = x[i] = std::fma(times[i], after, x[i]);
}

} // namespace windlass::physics
