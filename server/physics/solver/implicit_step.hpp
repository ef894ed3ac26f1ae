#pragma once
// The step that cannot fail: implicit Euler, for the steps that the direct solver leaves to it.
//
// Where each link pulls along its direction at the end of the step, the nodes go to the lowest point of
//   sum (p - p*) M (p - p*) / (2 dt kick) + sum phi(|p_(i+1) - p_i|),
// phi the energy of a link that pulls when longer than its length and never pushes. Each term is convex, so
// there is one lowest point, whatever the step, the masses and the folds of the chain, and Newton's method
// with a line search finds it; its matrix has a 3 x 3 block for each node and its neighbours. First order in
// time and damped: good for a step in which all that matters is to survive. Source of the energy form:
// Martin, Thomaszewski, Grinspun, Gross (2011), "Example-based elastic materials", section 4; Nocedal, Wright
// (2006), chapter 3.

#include "server/physics/chain/upper_end.hpp"
#include "server/physics/solver/free_motion.hpp"

#include <Eigen/Core>

#include <vector>

namespace windlass::physics {

/// What the links were at the start of the step, and how they are damped.
struct LinksBefore {
    const std::vector<double>& length; ///< m
    double damping = 0;                ///< structural damping time over dt
    const std::vector<double>& round;  ///< m, by which their way round an edge was longer than straight
};

/// Solves one such step at a time. Holds only memory to work in.
class ImplicitStep {
public:
    ImplicitStep(const ChainDef& def, int capacity);

    struct Iterations {
        int count = 0;
        bool still = false; ///< the last one hardly moved any node
    };
    /// placed: in, a first guess of where the nodes end; out, where they do, m. direction, pull (N): of each
    /// link at the end of the step. travel, m, and top: as UpperEnd has them.
    Iterations solve(const ChainState& state, const FreeMotion& motion, const StepTime& time,
                     const LinksBefore& before, UpperEnd& drive, double& travel, TopLink& top, Field& placed,
                     Field& direction, std::vector<double>& pull);

private:
    using Matrix3 = Eigen::Matrix3d;
    struct Link { // of unstretched length, and what of its damping was there before
        double rest, compliance, damped_before;
    };
    Link link(const ChainState& state, const LinksBefore& before, int i, double travel) const;
    void pull_links(const ChainState& state, const LinksBefore& before, double travel, const Field& placed,
                    Field& direction, std::vector<double>& pull);
    double energy(const ChainState& state, const FreeMotion& motion, const LinksBefore& before, double travel,
                  const Field& placed) const;
    double take_changes(const ChainState& state, Field& placed) const;
    double search(const ChainState& state, const FreeMotion& motion, const LinksBefore& before, double travel,
                  Field& placed);
    void descend(const ChainState& state, const FreeMotion& motion, const StepTime& time, double damping,
                 double doubt, UpperEnd& drive, const Link& at_top, double& travel, TopLink& top,
                 const Field& placed, const Field& direction, const std::vector<double>& pull);

    ChainDef def_;
    double deck_length_ = 0;              ///< m
    double stiffness_ = 0;                ///< N, of the links as they are at present
    std::vector<Matrix3> mass_;           ///< M / (dt kick) of each node, N/m
    std::vector<Matrix3> inverse_;        ///< of the pivots
    std::vector<Matrix3> link_stiffness_; ///< of each link, N/m
    std::vector<Vec3> force_;             ///< on each node, N; after elimination with what is below
    std::vector<Vec3> change_;            ///< m, Newton's
    std::vector<double> excess_; ///< m, of each link over its length, damping included; negative: slack
    std::vector<double> size_;   ///< m, of each link
    Field trial_;
    bool held_foot_ = false;
};

} // namespace windlass::physics
