// Waves of taut, undamped chain in air against the frequencies of its links and nodes.

#include "bench/methods/in_phase.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace windlass::lab {
namespace {

using namespace physics;

ChainDef undamped_chain(double spacing) {
    ChainDef def = stud_link_chain(0.076, Grade::k3, 330);
    def.damping_time = 0;
    def.node_spacing = spacing;
    return def;
}

/// rad that a mode goes on in a step, from its places: q(n+1) + q(n-1) = 2 cos(phase) q(n).
double phase_of_a_step(const std::vector<double>& q) {
    double both = 0, square = 0;
    for (std::size_t k = 1; k + 1 < q.size(); ++k)
        both += q[k] * (q[k + 1] + q[k - 1]), square += q[k] * q[k];
    return std::acos(0.5 * both / square);
}

enum class Wave { lengthwise, crosswise };

/// 200 m of chain, 20 links, and 10 t hanging from it in air, in one of its modes (from 1).
struct Ringing {
    static constexpr int kLinks = 20;
    ChainRig rig{undamped_chain(10), in_air(), {0, 0, -200}, {0, 0, 0}, 200, Foot::hanging, 1e4};
    InPhaseStep in_phase{rig.def, rig.environment.depth, kLinks};
    int corrected = 0; ///< steps that were taken in phase
    Vec3 way;
    Eigen::VectorXd mass{kLinks}, shape{kLinks}, rest{kLinks}; ///< of nodes 0 .. 19
    double frequency = 0;                                      ///< rad/s

    Ringing(Wave along, int mode) : way(along == Wave::lengthwise ? Vec3::UnitZ() : Vec3::UnitX()) {
        mass.setConstant(10 * rig.def.mass_per_metre);
        mass[0] = rig.tail_mass;
        const double spring = rig.def.stiffness / 10;
        Eigen::MatrixXd stiff = Eigen::MatrixXd::Zero(kLinks, kLinks);
        double z = 0, weight = mass.sum() * kGravity;
        for (int i = kLinks - 1; i >= 0; --i) {
            const double length = 10 + weight / spring;
            rest[i] = z -= length;
            const double k = along == Wave::lengthwise ? spring : weight / length;
            stiff(i, i) += k;
            if (i + 1 < kLinks) stiff(i + 1, i + 1) += k, stiff(i, i + 1) = stiff(i + 1, i) = -k;
            weight -= mass[i] * kGravity;
        }
        const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(root.asDiagonal() * stiff *
                                                                   root.asDiagonal());
        frequency = std::sqrt(modes.eigenvalues()[mode - 1]);
        shape = root.cwiseProduct(modes.eigenvectors().col(mode - 1));
        shape /= shape.cwiseAbs().maxCoeff();
    }

    /// Places of the mode in so many steps, after it was let go; amplitude in m.
    std::vector<double> places(double dt, int steps, double amplitude) {
        for (int i = 0; i < kLinks; ++i) {
            rig.state.position.set(i, Vec3(0, 0, rest[i]) + amplitude * shape[i] * way);
            rig.state.velocity.set(i, Vec3::Zero());
        }
        rig.state.last_step = 0;
        for (int i = 0; i < kLinks; ++i) {
            const Vec3 span = rig.state.position.at(i + 1) - rig.state.position.at(i);
            rig.state.set_tension(i, rig.def.stiffness / 10 * (span.norm() - 10));
        }
        std::vector<double> q;
        for (int k = 0; k < steps; ++k) {
            const bool taken = in_phase.step(rig.state, dt, rig.tail(dt), rig.hawse);
            if (taken)
                ++corrected;
            else
                rig.step(dt); // the first is half of one
            double sum = 0;
            for (int i = 0; i < kLinks; ++i)
                sum += mass[i] * shape[i] * (rig.state.position.at(i) - Vec3(0, 0, rest[i])).dot(way);
            q.push_back(sum / (shape.cwiseAbs2().dot(mass)));
        }
        return q;
    }

    /// By how much a step of so many radians of the mode is wrong, of itself.
    double phase_error(double radians, double amplitude) {
        return phase_of_a_step(places(radians / frequency, 400, amplitude)) / radians - 1;
    }
};

TEST(Phase, LengthwiseModeErrsWithTheFourthPowerOfTheStep) {
    for (const int mode : {1, 3}) {
        Ringing ringing(Wave::lengthwise, mode);
        for (const double radians : {0.5, 0.25}) {
            const double x = radians * radians, u = 1 / (1 + x / 4);
            const double scheme =
                2 * std::asin(std::sqrt((1 - u) * (1 + 2.0 / 3 * u * (1 - u)))) / radians - 1;
            // Chain is not quite linear over 2 mm, and Newton leaves 1 % of a link's weight.
            EXPECT_NEAR(ringing.phase_error(radians, 2e-3), scheme, 1e-5) << mode;
            EXPECT_LT(std::abs(scheme), x * x / 30); // x / 12 of Newmark's rule
        }
    }
}

TEST(Phase, CrosswiseModeErrsWithTheFourthPowerOfTheStep) {
    for (const int mode : {6, 8}) { // of longer ones the step is not stable: waves overrun a link in it
        Ringing swaying(Wave::crosswise, mode);
        const double half = swaying.phase_error(0.5, 1e-3), quarter = swaying.phase_error(0.25, 1e-3);
        EXPECT_LT(std::abs(half), 0.25 / 24 / 100) << mode; // x / 24 of the leapfrog
        EXPECT_GT(half / quarter, 12) << mode; // 16 less what the sixth order has; 4 at second order
    }
}

TEST(Phase, StiffModesStayBounded) {
    // A step spans 25 radians of the stiffest mode; 40 minutes of it. Small enough that no link's tension
    // changes by a tenth, so that the phase is kept all the while; 1.1: Newton leaves 1 % of a link's weight,
    // 5 % of the ringing.
    Ringing ringing(Wave::lengthwise, Ringing::kLinks);
    const double dt = 25 / ringing.frequency;
    const std::vector<double> q = ringing.places(dt, static_cast<int>(40 * 60 / dt), 2e-5);
    const auto largest = [](auto from, auto to) {
        double max = 0;
        for (auto place = from; place != to; ++place)
            max = std::max(max, std::abs(*place));
        return max;
    };
    EXPECT_EQ(ringing.corrected, static_cast<int>(q.size()) - 1);
    EXPECT_LT(largest(q.end() - 1000, q.end()), 1.1 * largest(q.begin(), q.begin() + 1000));
}

} // namespace
} // namespace windlass::lab
