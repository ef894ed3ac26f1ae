// Ground tackle at the start: the cable hanging at rest, the anchor below the lip or up the hawse pipe.

#include "server/physics/tackle/ground_tackle.hpp"
#include "server/physics/tackle/hawse_pipe_fit.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace windlass::physics {

namespace {

CableLimits cable_limits(const TackleSetup& setup) {
    const WindlassDef& w = setup.windlass;
    // From the bitter end some chain stays inboard: up from the locker, through the pipe.
    const double home = home_length(setup.chain);
    return {setup.pipe ? 2 * home - w.hawse_pipe_length : home,
            setup.chain.length - w.locker_lift - w.hawse_pipe_length};
}

/// m, of the cable that is modelled at the start.
double outboard(const TackleSetup& setup) {
    return std::max(setup.cable_out, home_length(setup.chain));
}

int capacity(const TackleSetup& setup) {
    // Should the bitter end part, what hung in the locker runs out, too.
    const double max = cable_limits(setup).bitter_end + setup.windlass.locker_lift;
    return static_cast<int>(std::ceil(max / setup.chain.node_spacing)) + 2;
}

/// Attitude of the anchor hanging, shank up, its flukes' axis fore and aft; without a pipe, and so without a
/// ship, along y.
Eigen::Quaterniond hanging(const TackleSetup& setup) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    double turned = setup.anchor_turned;
    if (setup.pipe) { // by as much as the ship from north
        const Vec3 ahead = setup.ship_attitude * Vec3::UnitX();
        turned += std::atan2(ahead.y(), ahead.x()) - kQuarter;
    }
    return Eigen::Quaterniond(Eigen::AngleAxisd(turned, Vec3::UnitZ())) *
           Eigen::Quaterniond(Eigen::AngleAxisd(-kQuarter, Vec3::UnitY()));
}

/// rad, of the flukes of an anchor that hangs so. They do not stay upright on their pin: they have fallen,
/// away from the ship, as when it came out of its pipe.
double fallen_flukes(const TackleSetup& setup, const Eigen::Quaterniond& attitude) {
    if (setup.flukes_turned) return *setup.flukes_turned;
    if (!setup.pipe) return 0;
    const Vec3 inboard = setup.ship_attitude * setup.pipe->bore,
               towards_positive = -(attitude * Vec3::UnitZ());
    return std::copysign(setup.anchor.fluke_angle, -inboard.dot(towards_positive));
}

/// Hangs the cable below the lip with the tension that its weight and the anchor's give it: no start-up jerk.
void hang_at_rest(const ChainDef& def, const EnvironmentDef& environment, double deck_length, const Vec3& lip,
                  double anchor_weight, ChainState& chain) {
    const int n = chain.links;
    // Weight first, with the nodes where unstretched chain puts them; then the stretch from the top down.
    double below = anchor_weight;
    for (int i = 0; i < n; ++i) {
        if (i > 0) below += node_weight(def, environment, node_medium(def, environment, chain, i));
        chain.set_tension(i, below);
    }
    Vec3 at = lip;
    for (int i = n - 1; i >= 0; --i) {
        const double rest = link_length(def, chain, i);
        const double stretch = (rest + (i == n - 1 ? deck_length : 0)) * chain.tension[i] / def.stiffness;
        at.z() -= rest + stretch;
        chain.position.set(i, at);
    }
}

} // namespace

GroundTackle::GroundTackle(const TackleSetup& setup, const EnvironmentDef& environment, const Vec3& lip)
    : setup_(setup),
      chain_(straight_chain(setup.chain, lip - Vec3(0, 0, outboard(setup)), lip, outboard(setup),
                            capacity(setup))),
      solver_(setup.chain, capacity(setup)),
      contacts_(capacity(setup), setup.self_contact),
      windlass_(setup.windlass, setup.chain, cable_limits(setup), setup.cable_out),
      anchor_(setup.anchor, 0.5 * setup.chain.node_spacing * setup.chain.mass_per_metre, environment, {}),
      condition_(setup.condition),
      spacing_error_(spacing_error(setup.chain.node_spacing, height_over_bed(environment, lip))) {
    condition_.resize(condition_.size() + kWeakened);
    constexpr double kRounding = 1e-6; // m
    const CableLimits& limits = windlass_.limits();
    const double min = setup.pipe ? setup.pipe->cable_at_home() - kRounding : limits.home;
    if (setup.cable_out < std::max(min, limits.home) || setup.cable_out > limits.bitter_end) {
        throw std::invalid_argument("cable out at the start is not between anchor home and bitter end");
    }
    const Eigen::Quaterniond attitude = hanging(setup);
    anchor_.turn_flukes(fallen_flukes(setup, attitude));
    anchor_.hang(chain_.position.at(0), attitude);
    hang_at_rest(setup.chain, environment, setup.windlass.hawse_pipe_length, lip, anchor_.weight(environment),
                 chain_);
    if (setup.pipe) {
        anchor_.hang_at_rest(chain_.position.at(0), attitude, environment);
    } else {
        anchor_.hang(chain_.position.at(0), attitude);
    }
    under_way_.lip = lip;
    under_way_.ship = setup.ship_attitude;
    if (setup.pipe && windlass_.drawn_in() > 0) start_in_pipe(environment);

    if (setup.budget) {
        const ModelError share = saving_share(*setup.budget);
        sleep_.emplace(setup.chain, share);
        quiet_.emplace(setup.chain, environment, share, setup.windlass.hawse_pipe_length, capacity(setup));
    }
    WindlassState& state = windlass_.state();
    state.brake.position = setup.brake;
    state.clutch.position = setup.clutch_in ? Clutch::in : Clutch::out;
    state.stopper.closed = setup.stopper_closed;
}

/// Hove in so far, the anchor lies with its shank along the bore and its flukes turned outboard.
void GroundTackle::start_in_pipe(const EnvironmentDef& environment) {
    const Vec3 bore = under_way_.ship * setup_.pipe->bore, end = upper_end(windlass_.drawn_in());
    const double pull = bore.z() * anchor_.weight(environment);
    chain_.set_tension(0, pull);
    const double stretch =
        (chain_.top_length + setup_.windlass.hawse_pipe_length) * pull / setup_.chain.stiffness;
    chain_.position.set(chain_.links, end);
    chain_.position.set(0, end - (chain_.top_length + stretch) * bore);
    anchor_.hang(chain_.position.at(0), Eigen::Quaterniond(anchor_axes(bore, bore)));
    anchor_.turn_flukes(-setup_.anchor.fluke_angle);
}

/// Lets the anchor sink against bore and plating until these bear it with the cable. Half its speed is taken
/// from it in every step: what falls into its seat wedges there, and strains the cable by more than its
/// weight.
void GroundTackle::settle_in_pipe(const EnvironmentDef& environment, const HullSurface& hull) {
    constexpr double kStep = 1.0 / 300, kTime = 3; // s
    const WindlassLevers levers{
        .brake = 1, .clutch_in = setup_.clutch_in, .stopper_closed = setup_.stopper_closed};
    const Vec3 lip = under_way_.lip;
    windlass_.state().brake.position = 1;
    for (int k = 0; k < static_cast<int>(kTime / kStep); ++k) {
        if (begin(environment, kStep, levers, {}, lip, &hull, true)) finish(environment, {});
        anchor_.set_motion(0.5 * anchor_.motion());
        for (int i = 0; i <= chain_.links; ++i)
            chain_.velocity.set(i, 0.5 * chain_.velocity.at(i));
    }
    windlass_.state().brake.position = setup_.brake;
}

void GroundTackle::start_aboard(const EnvironmentDef& environment, const HullSurface& hull) {
    HullSurface still = hull;
    still.motion.velocity = still.motion.spin = Vec3::Zero();
    if (setup_.pipe && windlass_.drawn_in() > 0) settle_in_pipe(environment, still);
    const auto speed = [&](const Vec3& at) -> Vec3 {
        return hull.motion.velocity + hull.motion.spin.cross(at - hull.motion.position);
    };
    for (int i = 0; i <= chain_.links; ++i)
        chain_.velocity.set(i, speed(chain_.position.at(i)));
    Vector6 motion;
    motion << speed(anchor_.pose().position), hull.motion.spin;
    anchor_.set_motion(motion);
}

} // namespace windlass::physics
