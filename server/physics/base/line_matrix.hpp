#pragma once
// Newton's matrix of a line of links: tridiagonal, eliminated from the anchor up.

#include <vector>

namespace windlass::physics {

/// Rows  x(i) - lower(i) x(i - 1) - upper(i) x(i + 1) = right(i), each divided by its diagonal.
///
/// Elimination by the ratios of leading minors, p(i) = p(i-1) - lower(i) upper(i-1) p(i-2), instead of by
/// pivots p(i) / p(i-1): the same numbers, but no division stands in the way of the next row, and the
/// divisions are left to a loop that the compiler vectorises. Ratios of minors of a diagonally dominant
/// matrix lie between 1/2 and 1, so the minors are taken anew every kBlock rows before they could leave the
/// range of a double.
class LineMatrix {
public:
    std::vector<double> lower, upper, right;
    /// What each row was divided by, inverted; after eliminate(), of the rows as they then are.
    std::vector<double> diagonal_inverse;

    explicit LineMatrix(int rows)
        : lower(rows), upper(rows), right(rows), diagonal_inverse(rows), minor_(rows), sum_(rows) {}

    /// Leaves x(i) = right(i) + upper(i) x(i + 1) for the rows from first to last.
    void eliminate(int first, int last);

    /// x(i) of rows first..last - 1 into right, given x(last) there.
    void substitute(int first, int last);

private:
    static constexpr int kBlock = 128;
    std::vector<double> minor_, sum_;
};

} // namespace windlass::physics
