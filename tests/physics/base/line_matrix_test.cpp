// The tridiagonal matrix of the chain's solve against a general solver.

#include "server/physics/base/line_matrix.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace windlass::physics {
namespace {

/// Rows from first to last of a line of n, as heavy and light nodes, stiff and slack links make them: off the
/// diagonal up to all of it in sum, and never more.
struct Line {
    int first, last;
    Eigen::MatrixXd dense;
    LineMatrix matrix;

    Line(int n, int from, int to, std::mt19937& random)
        : first(from), last(to), dense(Eigen::MatrixXd::Identity(to - from + 1, to - from + 1)), matrix(n) {
        std::uniform_real_distribution<double> share(-1, 1), size(-8, 8);
        for (int i = first; i <= last; ++i) {
            const double sum = share(random) * 0.999, split = 0.5 + 0.5 * share(random);
            matrix.lower[i] = i > first ? sum * split : 0;
            matrix.upper[i] = i < last ? sum * (1 - split) : 0;
            matrix.right[i] = std::pow(10, size(random));
            if (i > first) dense(i - first, i - first - 1) = -matrix.lower[i];
            if (i < last) dense(i - first, i - first + 1) = -matrix.upper[i];
        }
    }
};

/// Every number of rows that the loops treat in another way (of two, four, a block of 128), and a line of
/// which the lower end sleeps.
TEST(LineMatrix, SolvesAsAGeneralSolverDoes) {
    std::mt19937 random(1);
    for (const auto& [first, last] : {std::pair{0, 0},
                                      {0, 1},
                                      {0, 2},
                                      {0, 3},
                                      {0, 4},
                                      {0, 5},
                                      {3, 9},
                                      {0, 49},
                                      {0, 127},
                                      {0, 128},
                                      {0, 129},
                                      {7, 140},
                                      {0, 300},
                                      {0, 999}}) {
        Line line(1000, first, last, random);
        const int rows = last - first + 1;
        Eigen::VectorXd right(rows);
        for (int i = 0; i < rows; ++i)
            right[i] = line.matrix.right[first + i];
        const Eigen::VectorXd x = line.dense.partialPivLu().solve(right);

        line.matrix.eliminate(first, last);
        line.matrix.substitute(first, last);
        // A diagonal of 1 and the rest 0.999 of it at most: rounding grows a thousandfold at most.
        for (int i = 0; i < rows; ++i) {
            EXPECT_NEAR(line.matrix.right[first + i], x[i], 1e-12 * x.cwiseAbs().maxCoeff())
                << rows << ' ' << i;
        }
    }
}

} // namespace
} // namespace windlass::physics
