#pragma once
// Thomas' algorithm, for the methods whose links form a line.

#include <vector>

namespace windlass::lab {

/// Solves lower(i) x(i - 1) + diagonal(i) x(i) + upper(i) x(i + 1) = right(i) for all i; x into right, upper
/// is lost. The first lower and the last upper must be 0.
inline void solve_tridiagonal(const std::vector<double>& lower, const std::vector<double>& diagonal,
                              std::vector<double>& upper, std::vector<double>& right) {
    const int n = static_cast<int>(diagonal.size());
    double above = 0, solved = 0; // of the row before: its upper element and right-hand side, eliminated
    for (int i = 0; i < n; ++i) {
        const double over = 1 / (diagonal[i] - lower[i] * above);
        solved = (right[i] - lower[i] * solved) * over;
        above = upper[i] * over;
        right[i] = solved;
        upper[i] = above;
    }
    for (int i = n - 2; i >= 0; --i)
        right[i] -= upper[i] * right[i + 1];
}

} // namespace windlass::lab
