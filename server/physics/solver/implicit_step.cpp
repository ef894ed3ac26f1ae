#include "server/physics/solver/implicit_step.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kMaxIterations = 40;
/// Shortfall of a link's length, as a fraction, within which it is first taken to be taut.
constexpr double kNearlyTaut = 1e-3;
constexpr int kSoftIterations = 3;
constexpr double kSoft = 10;    ///< links so stiff to begin with, against their inertia in the step
constexpr double kStiffer = 10; ///< from one stiffness to the next
constexpr int kMaxHalvings = 12;
constexpr double kStill = 1e-8; ///< of the spacing: a change of the nodes that ends the search
constexpr double kGone = -1e9;  ///< m, how far a parted link is from being taut
constexpr double kPoint = 1e-9; ///< of the spacing: a link shorter than that has no direction

Eigen::Matrix3d dense(const SymmetricMatrix& m) {
    Eigen::Matrix3d d;
    d << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
    return d;
}

} // namespace

ImplicitStep::ImplicitStep(const ChainDef& def, int capacity)
    : def_(def),
      mass_(capacity + 1),
      inverse_(capacity + 1),
      link_stiffness_(capacity),
      force_(capacity + 1),
      change_(capacity + 1),
      excess_(capacity),
      size_(capacity),
      trial_(capacity + 1) {}

ImplicitStep::Link ImplicitStep::link(const ChainState& state, const LinksBefore& before, int i,
                                      double travel) const {
    const bool top = i == state.links - 1;
    const double was = link_length(def_, state, i), rest = was + (top ? travel : 0);
    return {rest - before.round[i], (rest + (top ? deck_length_ : 0)) / stiffness_,
            before.damping * positive_part(before.length[i] - was)};
}

/// How each link pulls at the given places.
void ImplicitStep::pull_links(const ChainState& state, const LinksBefore& before, double travel,
                              const Field& placed, Field& direction, std::vector<double>& pull) {
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 d = placed.at(i + 1) - placed.at(i);
        size_[i] = d.norm();
        const bool point = size_[i] < kPoint * def_.node_spacing;
        direction.set(i, point ? Vec3(Vec3::UnitZ()) : Vec3(d / size_[i]));
        const Link l = link(state, before, i, travel);
        excess_[i] = i == state.parted ? kGone : (1 + before.damping) * (size_[i] - l.rest) - l.damped_before;
        pull[i] = positive_part(excess_[i]) / l.compliance;
    }
}

double ImplicitStep::energy(const ChainState& state, const FreeMotion& motion, const LinksBefore& before,
                            double travel, const Field& placed) const {
    double sum = 0;
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 off = placed.at(i) - motion.place.at(i);
        sum += 0.5 * off.dot(mass_[i] * off);
        const Link l = link(state, before, i, travel);
        const double size = (placed.at(i + 1) - placed.at(i)).norm();
        if (i == state.parted) continue;
        const double excess = positive_part((1 + before.damping) * (size - l.rest) - l.damped_before);
        sum += 0.5 * excess * excess / (l.compliance * (1 + before.damping));
    }
    return sum;
}

/// Newton's change of every node, with the drive line's answer to it.
void ImplicitStep::descend(const ChainState& state, const FreeMotion& motion, const StepTime& time,
                           double damping, double doubt, UpperEnd& drive, const Link& at_top, double& travel,
                           TopLink& top, const Field& placed, const Field& direction,
                           const std::vector<double>& pull) {
    const int foot = state.asleep, last = state.links - 1;
    // A link in doubt is taken to be taut, and pushes where it is too short, for this once.
    const auto lengthwise = [&](int i) {
        return pull[i] > 0 || excess_[i] <= -doubt ? pull[i]
                                                   : excess_[i] * stiffness_ / link_length(def_, state, i);
    };
    for (int i = foot; i <= last; ++i) {
        const Vec3 n = direction.at(i);
        const Matrix3 along = n * n.transpose();
        const bool taut = excess_[i] > -doubt;
        const double stiffness = taut ? (1 + damping) * stiffness_ / link_length(def_, state, i) : 0;
        // Turning against its pull; the top link's stiffness lengthwise enters with the drive line.
        link_stiffness_[i] =
            pull[i] / std::max(size_[i], kPoint * def_.node_spacing) * (Matrix3::Identity() - along);
        if (i < last) link_stiffness_[i] += stiffness * along;
        force_[i] = -(mass_[i] * (placed.at(i) - motion.place.at(i)));
        if (i < last) force_[i] += lengthwise(i) * n;
        if (i > foot) force_[i] -= lengthwise(i - 1) * direction.at(i - 1);
    }
    for (int i = foot; i <= last; ++i) {
        if (i == foot && held_foot_) {
            inverse_[i].setZero();
            force_[i].setZero();
            continue;
        }
        Matrix3 pivot = mass_[i] + link_stiffness_[i];
        if (i > foot) {
            pivot +=
                link_stiffness_[i - 1] - link_stiffness_[i - 1] * inverse_[i - 1] * link_stiffness_[i - 1];
            force_[i] += link_stiffness_[i - 1] * (inverse_[i - 1] * force_[i - 1]);
        }
        inverse_[i] = pivot.inverse();
    }
    // The top link between the node below it and the drive line, as in the direct solver.
    const Vec3 n = direction.at(last), free = inverse_[last] * force_[last], yields = inverse_[last] * n;
    const double give = at_top.compliance + (1 + damping) * n.dot(yields);
    const double excess = excess_[last] - (1 + damping) * n.dot(free);
    top.dt = time.dt;
    top.yielding = (1 + damping + pull[last] / stiffness_) / give;
    top.pull = excess / give + top.yielding * travel;
    top.outboard_mass = 0.5 * def_.mass_per_metre * state.top_length;
    top.outboard_pull = top.outboard_mass * kGravity * n.z();
    travel = drive.speed(top) * time.dt;
    change_[last] = free + positive_part(top.pull - top.yielding * travel) * yields;
    for (int i = last - 1; i >= foot; --i)
        change_[i] = inverse_[i] * (force_[i] + link_stiffness_[i] * change_[i + 1]);
}

/// Takes the whole change. Returns how far the nodes moved at most, m.
double ImplicitStep::take_changes(const ChainState& state, Field& placed) const {
    double largest = 0;
    for (int i = state.asleep; i < state.links; ++i) {
        placed.add(i, change_[i]);
        largest = std::max(largest, change_[i].cwiseAbs().maxCoeff());
    }
    return largest;
}

/// Takes as much of the change as lowers the energy. Returns how far the nodes moved at most, m.
double ImplicitStep::search(const ChainState& state, const FreeMotion& motion, const LinksBefore& before,
                            double travel, Field& placed) {
    const double start = energy(state, motion, before, travel, placed);
    double share = 1, largest = 0;
    for (int i = state.asleep; i < state.links; ++i)
        largest = std::max(largest, change_[i].cwiseAbs().maxCoeff());
    for (int k = 0;; ++k, share *= 0.5) {
        for (int i = state.asleep; i < state.links; ++i)
            trial_.set(i, placed.at(i) + share * change_[i]);
        trial_.set(state.links, placed.at(state.links));
        if (k == kMaxHalvings || energy(state, motion, before, travel, trial_) <= start) break;
    }
    for (int i = state.asleep; i < state.links; ++i)
        placed.set(i, trial_.at(i));
    return share * largest;
}

ImplicitStep::Iterations ImplicitStep::solve(const ChainState& state, const FreeMotion& motion,
                                             const StepTime& time, const LinksBefore& before, UpperEnd& drive,
                                             double& travel, TopLink& top, Field& placed, Field& direction,
                                             std::vector<double>& pull) {
    assert(time.dt > 0 && time.kick > 0 && "a step takes time");
    assert(state.links <= static_cast<int>(size_.size()) &&
           "no more links than the capacity given at the start");
    assert(state.links <= static_cast<int>(std::min(before.length.size(), pull.size())) &&
           "one for every link");
    const int foot = state.asleep, last = state.links - 1;
    deck_length_ = drive.deck_length();
    held_foot_ = motion.inverse_mass.at(foot).xx == 0;
    for (int i = foot; i <= last; ++i) {
        if (i == foot && held_foot_) {
            mass_[i].setZero();
            placed.set(i, motion.place.at(i));
            continue;
        }
        mass_[i] = dense(motion.inverse_mass.at(i).inverse()) / (time.dt * time.kick);
    }
    placed.set(state.links, motion.place.at(state.links));
    for (int i = foot; i <= last; ++i)
        if (i > foot || !held_foot_) placed.set(i, state.position.at(i));
    // Soft links first, then ever stiffer ones, each from where the softer left the nodes: from a chain that
    // is straight and slack, or turns far, stiff links alone would take hundreds of iterations.
    const double inertia =
        def_.mass_per_metre * def_.node_spacing * def_.node_spacing / (time.dt * time.kick); // N
    Iterations iterations;
    for (double share = std::min(1.0, kSoft * inertia / def_.stiffness);;
         share = std::min(1.0, kStiffer * share)) {
        stiffness_ = share * def_.stiffness;
        const int max = share < 1 ? kSoftIterations : kMaxIterations;
        for (int k = 0; k < max; ++k) {
            // Else a chain at rest would be found taut only link by link from its ends.
            const double doubt = k == 0 ? kNearlyTaut * def_.node_spacing : 0;
            pull_links(state, before, travel, placed, direction, pull);
            descend(state, motion, time, before.damping, doubt, drive, link(state, before, last, travel),
                    travel, top, placed, direction, pull);
            ++iterations.count;
            const double moved =
                k == 0 ? take_changes(state, placed) : search(state, motion, before, travel, placed);
            iterations.still = moved <= kStill * def_.node_spacing;
            if (iterations.still) break;
        }
        if (share == 1) break;
    }
    pull_links(state, before, travel, placed, direction, pull);
    return iterations;
}

} // namespace windlass::physics
