// The server's own chain (server/physics/solver/chain_solver.hpp) as one of the methods: SHAKE with
// compliance, all links solved at once, the axial force weighted over three instants. Sources:
// server/physics/chain/chain.hpp. And the same in phase, which the server is not.

#include "bench/methods/in_phase.hpp"
#include "bench/methods/list.hpp"
#include "bench/methods/production_obstacles.hpp"
#include "server/physics/solver/chain_solver.hpp"
#include "server/physics/solver/chain_substeps.hpp"

#include <optional>
#include <stdexcept>

namespace windlass::lab {
namespace {

using namespace physics;

/// The upper end, where it is held: no chain passes it.
bool held(const End& end) {
    return end.kind == EndKind::fixed || end.kind == EndKind::driven;
}

/// Most parts that a step is divided into.
constexpr int kMaxSubsteps = 1000;

class Production final : public Method {
public:
    Production(const Problem& problem, int links, double dt, bool in_phase)
        : environment_(problem.environment),
          bed_(level_bed(problem.environment)),
          flipped_(!held(problem.upper)),
          lower_(flipped_ ? problem.upper : problem.lower),
          upper_(flipped_ ? problem.lower : problem.upper),
          def_(line_of(problem, links)),
          dt_(dt),
          current_(compass(environment_.current_towards) * environment_.current_speed),
          state_(straight_chain(def_, Vec3::Zero(), Vec3::UnitX(), problem.length, links)),
          solver_(def_, links),
          obstacles_(problem.obstacles, links) {
        for (int i = 0; i <= links; ++i) {
            const double arc = problem.length * i / links;
            state_.position.set(i, problem.start(flipped_ ? problem.length - arc : arc));
        }
        if (in_phase) in_phase_.emplace(def_, problem.environment.depth, links);
        foot_ = state_.position.at(0);
        hawse_ = state_.position.at(links);
        for (int i = 0; i < links; ++i) {
            const double rest = link_length(def_, state_, i);
            const double stretch = (state_.position.at(i + 1) - state_.position.at(i)).norm() - rest;
            state_.set_tension(i, std::max(0.0, def_.stiffness * stretch / rest));
        }
    }

    void step() override {
        // As in an exercise: the step is divided where the chain is so taut that it must be.
        const int substeps = chain_substeps(def_, state_, dt_, kMaxSubsteps).count;
        iterations_ = 0;
        for (int k = 1; k <= substeps; ++k) {
            const double end = (static_cast<double>(steps_) + static_cast<double>(k) / substeps) * dt_;
            const Vec3 hawse = upper_.kind == EndKind::driven ? upper_.motion(end) : hawse_;
            const double dt = dt_ / substeps;
            if (in_phase_ && in_phase_->step(state_, dt, tail(end, dt), hawse)) {
                ++iterations_;
                continue;
            }
            ContactSet* contacts =
                obstacles_.empty() ? nullptr : &obstacles_.find(def_, state_, dt, !held(lower_));
            solver_.predict(state_, environment_, dt, tail(end, dt), locked_, hawse);
            last_ = solver_.solve(state_, environment_, locked_, nullptr, contacts);
            iterations_ += last_.iterations;
        }
        ++steps_;
    }

    double time() const override { return static_cast<double>(steps_) * dt_; }
    int links() const override { return state_.links; }
    Vec3 position(int node) const override { return state_.position.at(own(node)); }
    double tension(int link) const override {
        return state_.tension[flipped_ ? state_.links - 1 - link : link];
    }
    int iterations() const override { return iterations_; }

    /// The speed of the last half step, brought to this instant; of a node that an obstacle may bear, as it
    /// is.
    Vec3 velocity(int node) const override {
        const int i = own(node);
        return moves(i) && !obstacles_.touched(i)
                   ? Vec3(state_.velocity.at(i) + 0.5 * state_.last_step * acceleration(i))
                   : state_.velocity.at(i);
    }

private:
    static ChainDef line_of(const Problem& problem, int links) {
        ChainDef def = problem.line;
        def.length = problem.length;
        def.node_spacing = problem.length / links;
        return def;
    }

    int own(int node) const { return flipped_ ? state_.links - node : node; }

    bool moves(int i) const { return i > 0 ? i < state_.links : !held(lower_); }

    /// The half link that the lower end stands for, as water and seabed see it, with what hangs on it.
    NodeMedium end_medium() const {
        NodeMedium m;
        const Vec3 along = state_.position.at(1) - state_.position.at(0);
        if (along.norm() > 0) m.tangent = along.normalized();
        m.length = 0.5 * link_length(def_, state_, 0);
        const double z = state_.position.z[0];
        m.submerged = submerged_share(z, m.length);
        const double displaced = m.submerged * environment_.water_density * def_.displacement * m.length;
        const double mass = def_.mass_per_metre * m.length + lower_.mass;
        m.mass_normal = mass + def_.added_mass_normal * displaced;
        m.mass_axial = mass + def_.added_mass_axial * displaced;
        m.penetration = std::max(0.0, -environment_.depth - z);
        m.bed_stiffness = environment_.bed_stiffness * def_.contact_diameter * m.length;
        return m;
    }

    NodeMedium medium(int i) const {
        return i == 0 ? end_medium() : node_medium(def_, environment_, state_, i);
    }

    /// N, upwards, of weight, buoyancy and, where it bears the node, seabed.
    double load(int i, const NodeMedium& m, const NodeDamping& damping, double dt) const {
        const double weight = node_weight(def_, environment_, m) + (i == 0 ? lower_.weight : 0);
        return (damping.bed_normal > 0 ? bed_push(m, damping, state_.velocity.z[i], dt) : 0) - weight;
    }

    /// m/s2, of node i under the present loads and the mean of the last two tensions: links too stiff for the
    /// step ring from one step to the next, and the step sees their mean.
    Vec3 acceleration(int i) const {
        const NodeMedium m = medium(i);
        const double dt = state_.last_step;
        const NodeDamping damping =
            node_damping(def_, environment_, bed_, m, state_.velocity.at(i), current_);
        const bool borne = damping.bed_normal > 0;
        Vec3 force(0, 0, load(i, m, damping, dt));
        const auto pull = [&](int link, int towards) -> Vec3 {
            return 0.5 * (state_.elastic_tension[link] + state_.elastic_tension_before[link]) *
                   (state_.position.at(towards) - state_.position.at(i)).stableNormalized();
        };
        if (i < state_.links) force += pull(i, i + 1);
        if (i > 0) force += pull(i - 1, i - 1);
        force -= along_and_across(state_.velocity.at(i) - damping.current, m.tangent, damping.normal,
                                  damping.axial);
        return (borne ? inverse_mass_on_bed(bed_, m, damping, bed_hold(damping, dt), dt)
                      : inverse_mass_afloat(m, damping, dt)) *
               force;
    }

    ChainTail tail(double end, double dt) const {
        ChainTail tail;
        tail.velocity_before = state_.velocity.at(0);
        if (lower_.kind == EndKind::driven)
            tail.velocity = (lower_.motion(end) - state_.position.at(0)) / dt;
        else if (lower_.kind == EndKind::fixed)
            tail.velocity = (foot_ - state_.position.at(0)) / dt;
        if (held(lower_)) return tail;
        const Vec3 v = state_.velocity.at(0);
        const double kick = step_kick(state_, dt);
        // In air nothing but weight acts: the terms of water and seabed would be a twentieth of a short
        // line's step.
        if (environment_.water_density == 0 && state_.position.z[0] > -environment_.depth) {
            const double length = 0.5 * link_length(def_, state_, 0);
            const double inverse = 1 / (def_.mass_per_metre * length + lower_.mass);
            const double weight = def_.mass_per_metre * length * kGravity + lower_.weight;
            tail.inverse_mass = {.xx = inverse, .yy = inverse, .zz = inverse};
            tail.velocity = v - Vec3(0, 0, kick * weight * inverse);
            return tail;
        }
        const NodeMedium m = end_medium();
        const NodeDamping damping = node_damping(def_, environment_, bed_, m, v, current_);
        const bool borne = damping.bed_normal > 0;
        tail.inverse_mass = borne ? inverse_mass_on_bed(bed_, m, damping, bed_hold(damping, dt), kick)
                                  : inverse_mass_afloat(m, damping, kick);
        Vec3 momentum = along_and_across(v, m.tangent, m.mass_normal, m.mass_axial) +
                        kick * along_and_across(damping.current, m.tangent, damping.normal, damping.axial);
        momentum.z() += kick * load(0, m, damping, dt);
        tail.velocity = tail.inverse_mass * momentum;
        return tail;
    }

    EnvironmentDef environment_;
    LevelBed bed_;
    bool flipped_; ///< the solver wants its held end on top
    End lower_, upper_;
    ChainDef def_;
    double dt_;
    Vec3 current_;
    ChainState state_;
    ChainSolver solver_;
    std::optional<InPhaseStep> in_phase_;
    ProductionObstacles obstacles_;
    LockedEnd locked_;
    Vec3 foot_, hawse_;
    ChainStepResult last_;
    int iterations_ = 0;
    long steps_ = 0;
};

std::unique_ptr<Method> make(const Problem& problem, int links, double dt, const MethodSettings&) {
    if (!held(problem.upper) && !held(problem.lower))
        throw std::invalid_argument("production: one end must be fixed or driven; both are loose");
    return std::make_unique<Production>(problem, links, dt, false);
}

std::unique_ptr<Method> make_in_phase(const Problem& problem, int links, double dt, const MethodSettings&) {
    if (!held(problem.upper) && !held(problem.lower))
        throw std::invalid_argument("production_in_phase: one end must be fixed or driven; both are loose");
    if (problem.environment.water_density != 0)
        throw std::invalid_argument("production_in_phase: does chain in air only");
    if (problem.line.damping_time != 0)
        throw std::invalid_argument("production_in_phase: does chain without structural damping only");
    return std::make_unique<Production>(problem, links, dt, true);
}

} // namespace

MethodEntry production_method() {
    return {"production",
            "direct solve of all links, gradient at the start of the step, force over three instants", "",
            make, true};
}

MethodEntry production_in_phase_method() {
    return {"production_in_phase", "production, waves kept in phase to fourth order; not in the server",
            "water, structural damping", make_in_phase};
}

} // namespace windlass::lab
