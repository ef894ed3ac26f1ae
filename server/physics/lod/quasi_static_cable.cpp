#include "server/physics/lod/quasi_static_cable.hpp"

#include "server/physics/base/state_limits.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kLookTime = 0.25; ///< s between two looks at the dynamic cable
constexpr double kPlaceTime = 0.1; ///< s between two pictures of the nodes
constexpr double kMinAgreed = 2;   ///< s
constexpr double kSmoothing = 0.5; ///< s, of the lip's acceleration
/// Links on the bottom between foot and touchdown, at least; and one more at most. What has come to lie stays
/// there, so the cable leads from where the last link did: the foot is a landed node, no matter how near.
constexpr double kMinLying = 0.25;
constexpr int kCorrections = 3;   ///< of the length, at a look at the dynamic cable
constexpr double kStill = 5e-3;   ///< m/s, chain that can be left lying
constexpr double kAskAgain = 600; ///< s, after which the dynamic cable is held against the catenary anew
constexpr double kEnter = 0.6;    ///< share of the budget with which the catenary begins

Vec3 level(const Vec3& v) {
    return {v.x(), v.y(), 0};
}

/// Unstretched length from a node to the lip, m.
double length_above(const ChainDef& def, const ChainState& chain, int node) {
    return (chain.links - 1 - node) * def.node_spacing + grown(def, chain, node, chain.links - 1) +
           chain.top_length;
}

} // namespace

QuasiStaticCable::QuasiStaticCable(const ChainDef& chain, const EnvironmentDef& environment,
                                   const ModelError& budget, double deck_length, int capacity)
    : chain_(chain),
      budget_(budget),
      deck_length_(deck_length),
      bed_friction_(environment.bed_friction * weight_in_water(chain, environment.water_density)),
      cable_(chain, environment),
      nodes_(capacity + 1) {}

void QuasiStaticCable::track(const Vec3& lip, double dt) {
    const Vec3 velocity = (lip - state_.lip) / dt;
    const double share = std::min(1.0, dt / kSmoothing);
    state_.lip_acceleration += share * ((velocity - state_.lip_velocity) / dt - state_.lip_acceleration);
    state_.lip_velocity = velocity;
    state_.lip = lip;
}

bool QuasiStaticCable::solve(const ChainState& chain, int foot, const Vec3& lip, double water) {
    const Vec3 way = level(lip - chain.position.at(foot));
    const double span = way.norm();
    if (!cable_.solve(length_above(chain_, chain, foot) + state_.correction, span, lip.z() - water, water))
        return false;
    toward_ = way / span;
    return true;
}

/// Puts the nodes on the catenary, each as far from the one above as the link's tension asks for: the chords
/// of the links, not the arc, have the cable's length, and the top link has the deck's stretch, too. By how
/// much the lowest link then misses the foot corrects the length of the next solution.
void QuasiStaticCable::lay_out(const ChainState& chain, int foot) {
    const int n = chain.links;
    const Vec3 at_foot = chain.position.at(foot);
    nodes_.set(n, chain.position.at(n));
    double s = length_above(chain_, chain, foot);
    const double scale = (s + state_.correction) / s; // from the chain's measure to the catenary's
    for (int i = n - 1; i >= foot; --i) {
        const double rest = link_length(chain_, chain, i);
        const double tension = cable_.tension_at(scale * (s - 0.5 * rest));
        s -= rest;
        const auto [x, z] = cable_.place_at(scale * s);
        const Vec3 aim = at_foot + x * toward_ + z * Vec3::UnitZ();
        const Vec3 above = nodes_.at(i + 1);
        const double stretched = rest + (rest + (i == n - 1 ? deck_length_ : 0)) * tension / chain_.stiffness;
        nodes_.set(i, above + (aim - above).normalized() * stretched);
    }
    state_.correction += (at_foot - nodes_.at(foot)).dot(toward_);
}

double QuasiStaticCable::drag(const EnvironmentDef& environment) const {
    const Vec3 current = compass(environment.current_towards) * environment.current_speed;
    return 0.5 * environment.water_density * chain_.drag_normal * chain_.diameter * cable_.hanging() *
           (state_.lip_velocity - current).squaredNorm();
}

/// Error of leaving out what moves the cable: half of it acts at the lip, half at the touchdown.
ModelError QuasiStaticCable::moving(const EnvironmentDef& environment) const {
    const double mass =
        chain_.mass_per_metre + chain_.added_mass_normal * environment.water_density * chain_.displacement;
    const double inertia = mass * cable_.hanging() * state_.lip_acceleration.norm();
    const double load = 0.5 * (inertia + std::abs(drag(environment) - state_.drag)) / cable_.tension();
    const Vec3 aside = state_.toward.cross(toward_);
    return {load, aside.norm() * cable_.lying()};
}

/// Whether the dynamic cable is where the catenary from a foot near the touchdown has it, and pulls alike.
bool QuasiStaticCable::compare(const EnvironmentDef& environment, const ChainState& chain, const Vec3& pull) {
    if (state_.agreed_for == 0) state_.correction = 0;
    if (!solve(chain, chain.asleep, state_.lip, environment.level)) return false;
    // The chain between the sleeping part and the touchdown lies where it was laid, not in a straight line.
    foot_ = chain.asleep + static_cast<int>(cable_.lying() / chain_.node_spacing - kMinLying);
    if (foot_ < chain.asleep || foot_ >= chain.links - 1) return false;
    for (int k = 0; k < kCorrections; ++k) {
        if (!solve(chain, foot_, state_.lip, environment.level)) return false;
        lay_out(chain, foot_);
    }
    double largest = 0;
    for (int i = foot_; i < chain.links; ++i)
        largest = std::max(largest, (nodes_.at(i) - chain.position.at(i)).squaredNorm());
    for (int i = chain.asleep; i <= foot_; ++i)
        if (chain.velocity.at(i).norm() > kStill) return false;
    state_.found = {(this->pull() - pull).norm() / cable_.tension(), std::sqrt(largest)};
    state_.drag = drag(environment);
    state_.toward = toward_;
    state_.error = together(state_.found, moving(environment));
    return state_.error.load < kEnter * budget_.load && state_.error.shape < kEnter * budget_.shape;
}

int QuasiStaticCable::agrees(const EnvironmentDef& environment, const ChainState& chain, double dt,
                             const Vec3& pull, bool at_rest) {
    track(chain.position.at(chain.links), dt);
    if (!at_rest) {
        state_.agreed_for = 0;
        return 0;
    }
    state_.to_look -= dt;
    if (state_.to_look > 0) return 0;
    state_.to_look = kLookTime;
    if (!compare(environment, chain, pull)) {
        state_.agreed_for = 0;
        return 0;
    }
    state_.agreed_for += kLookTime;
    // The hanging part's slowest swing, as a string.
    const double swing = 2 * cable_.hanging() * std::sqrt(chain_.mass_per_metre / cable_.tension());
    return state_.agreed_for > std::max(kMinAgreed, swing) ? foot_ : 0;
}

bool QuasiStaticCable::follow(const EnvironmentDef& environment, ChainState& chain, double dt,
                              const Vec3& lip, double foot_holds) {
    assert(dt > 0 && "a step takes time");
    const QuietState before = state_;
    track(lip, dt);
    state_.agreed_for += dt;
    const auto does = [&] {
        if (state_.agreed_for > kAskAgain) return false;
        if (!solve(chain, chain.asleep, lip, environment.level) || cable_.lying() <= 0) return false;
        if (cable_.foot_tension() > foot_holds) return false;
        state_.error = together(state_.found, moving(environment));
        return state_.error.load < budget_.load && state_.error.shape < budget_.shape;
    };
    if (!does()) {
        state_ = before;
        return false;
    }
    chain.position.set(chain.links, lip);
    chain.velocity.set(chain.links, state_.lip_velocity);
    chain.last_step = dt;
    state_.to_look -= dt;
    if (state_.to_look <= 0) {
        place(chain, kPlaceTime - state_.to_look);
        state_.to_look = kPlaceTime;
        move_foot(chain);
    }
    return true;
}

/// Chain that comes to lie stays as it was laid, and chain that is lifted comes from where it lay: the foot
/// follows the touchdown.
void QuasiStaticCable::move_foot(ChainState& chain) {
    const double links = cable_.lying() / chain_.node_spacing;
    int by = 0;
    if (links > 1 + kMinLying) by = static_cast<int>(links - kMinLying);
    if (links < kMinLying) by = -1;
    if (by == 0) return;
    chain.asleep = std::max(0, chain.asleep + by);
    for (int i = 0; i <= chain.asleep; ++i)
        chain.velocity.set(i, Vec3::Zero());
    if (chain.asleep == 0) return;
    solve(chain, chain.asleep, state_.lip, cable_.level());
    state_.toward = toward_;
}

/// seconds: since they were placed last.
void QuasiStaticCable::place(ChainState& chain, double seconds) {
    const int foot = chain.asleep;
    lay_out(chain, foot);
    double s = 0;
    for (int i = foot; i < chain.links; ++i) {
        const double rest = link_length(chain_, chain, i), middle = s + 0.5 * rest;
        double tension = cable_.tension_at(middle);
        // On the bottom friction keeps the tension that there was, as far as it can.
        if (middle < cable_.lying()) {
            const double held = bed_friction_ * (cable_.lying() - middle), h = cable_.horizontal();
            tension = std::clamp(chain.tension[i], std::max(0.0, h - held), h + held);
        }
        chain.set_tension(i, tension);
        if (i > foot) {
            chain.velocity.set(i, (nodes_.at(i) - chain.position.at(i)) / seconds);
            chain.position.set(i, nodes_.at(i));
        }
        s += rest;
    }
}

/// The dynamic cable has placed the nodes just now. Counted on from the next look they would be given back
/// with speeds of way over a time that is not theirs, and at one instant of no time at all.
void QuasiStaticCable::take_over() {
    state_.active = true;
    state_.agreed_for = 0;
    state_.to_look = kPlaceTime;
}

void QuasiStaticCable::give_back(ChainState& chain) {
    assert(state_.active && "it has been taken over");
    solve(chain, chain.asleep, state_.lip, cable_.level());
    if (const double seconds = kPlaceTime - state_.to_look; seconds > 0) place(chain, seconds);
    chain.last_step = 0; // velocities are of this instant
    state_.active = false;
    state_.agreed_for = 0;
    state_.to_look = 0;
}

Vec3 QuasiStaticCable::pull() const {
    return -cable_.horizontal() * toward_ - cable_.vertical() * Vec3::UnitZ();
}

template <class Visitor, StateOf<QuietState> State>
void visit_state(Visitor& v, State& state) {
    auto& [active, to_look, agreed_for, correction, drag, toward, lip, lip_velocity, lip_acceleration, found,
           error] = state;
    WINDLASS_STATE(v, active, to_look, agreed_for, correction, drag, toward, lip, lip_velocity,
                   lip_acceleration, found, error);
    WINDLASS_WITHIN(v, -kLongest, kLongest, to_look, agreed_for);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, correction, lip);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, drag);
    WINDLASS_WITHIN(v, -1.01, 1.01, toward);
    // A lip that is looked at for the first time comes from nowhere in one step.
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, lip_velocity);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, lip_acceleration);
}
WINDLASS_STATE_LISTED(QuietState);

} // namespace windlass::physics
