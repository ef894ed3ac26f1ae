#include "server/physics/base/line_matrix.hpp"

#include "server/physics/base/vectorise.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// x(i) += times(i) x(i - Step) for the given number of rows from the first on, in steps of Step. Four rows
/// are first made to hang on the x before them all, so that of four only one has to wait for the one before
/// it.
template <int Step>
void recur(const double* times, double* x, int first, int rows) {
    double before = x[first - Step];
    int i = first;
    for (; rows >= 4; rows -= 4, i += 4 * Step) {
        const double t0 = times[i], t1 = times[i + Step], t2 = times[i + 2 * Step], t3 = times[i + 3 * Step];
        const double x0 = x[i], x1 = std::fma(t1, x0, x[i + Step]), x2 = std::fma(t2, x1, x[i + 2 * Step]),
                     x3 = std::fma(t3, x2, x[i + 3 * Step]);
        const double t01 = t0 * t1, t012 = t01 * t2, t0123 = t01 * (t2 * t3);
        x[i] = std::fma(t0, before, x0);
        x[i + Step] = std::fma(t01, before, x1);
        x[i + 2 * Step] = std::fma(t012, before, x2);
        before = x[i + 3 * Step] = std::fma(t0123, before, x3);
    }
    for (; rows > 0; --rows, i += Step)
        before = x[i] = std::fma(times[i], before, x[i]);
}

} // namespace

void LineMatrix::eliminate(int first, int last) {
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
    recur<-1>(upper.data(), right.data(), last - 1, last - first);
}

void LineMatrix::solve_again(int first, int last, std::vector<double>& x) const {
    recur<1>(lower.data(), x.data(), first + 1, last - first);
    recur<-1>(upper.data(), x.data(), last - 1, last - first);
}

} // namespace windlass::physics
