// Position-based dynamics as published for the anchor chain of a windlass simulator: Jiang, Ren, He (2020),
// PLoS ONE 15(8), doi 10.1371/journal.pone.0237563, on Mueller, Heidelberger, Hennix, Ratcliff (2007). Its
// stiffness depends on step and iteration count, as that of all such methods does.
//
// A step: free motion by forward Euler; contacts found on the way; sweeps over links (stretch and slack),
// bends, long-range attachment to the hawse and pin to the anchor, each as often as its count says and spread
// evenly over the rounds, contacts at the end of every round; velocities from the way made; damping of the
// pin. Chain in the sweeps has one inverse mass in all directions, as published: added mass along and across
// the chain does not differ there.
//
// Tension as the method itself measures it: the multiplier of the link over dt^2. What the long-range
// attachment bears is not in it.

#include "bench/methods/list.hpp"
#include "bench/methods/particles.hpp"
#include "bench/methods/pbd_constraints.hpp"
#include "bench/methods/pbd_obstacles.hpp"
#include "bench/methods/pbd_self_collision.hpp"

#include <algorithm>
#include <stdexcept>

namespace windlass::lab {

namespace {

constexpr int kIterations = 10; ///< over the links

/// What hangs on an end: a body of its own, pinned to the chain's last particle.
struct Body {
    int node = 0;
    double reach = 0;         ///< m of chain to the hawse
    double inverse_mass = 0;  ///< 1/kg
    Vec3 fall = Vec3::Zero(); ///< m/s2
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
};

/// The line without what hangs on its ends.
Problem unloaded(Problem problem) {
    for (End* end : {&problem.lower, &problem.upper})
        if (end->kind == EndKind::mass) end->kind = EndKind::free;
    return problem;
}

/// The flat seabed among the obstacles.
std::vector<Obstacle> with_bed(const Problem& problem, bool bed) {
    std::vector<Obstacle> all = problem.obstacles;
    if (!bed) return all;
    Obstacle flat;
    flat.point = {0, 0, -problem.environment.depth};
    flat.material.friction = problem.environment.bed_friction;
    all.push_back(flat);
    return all;
}

/// The node that the long-range attachment leads to: the upper end, the lower if only that is held; -1:
/// none.
int hawse_of(const Problem& problem, int links) {
    return held(problem.upper) ? links : held(problem.lower) ? 0 : -1;
}

std::vector<double> reaches(int links, double rest, int hawse) {
    std::vector<double> reach;
    for (int i = 0; i <= links; ++i)
        reach.push_back(rest * (hawse == 0 ? i : links - i));
    return reach;
}

class Pbd final : public ParticleMethod {
public:
    Pbd(const Problem& problem, int links, double dt, const MethodSettings& settings)
        : ParticleMethod(unloaded(problem), links, dt, SeabedBy::method),
          settings_(settings),
          hawse_(hawse_of(problem, links)),
          stretch_(links, particles_.line.rest, settings.k_stretch, settings.k_slack),
          bend_(links + 1, settings.k_bend),
          angle_(links + 1, settings.k_bend, settings.rest_angle),
          attachment_(reaches(links, particles_.line.rest, hawse_), settings.k_lra),
          self_collision_(links + 1, radius(), particles_.line.rest),
          obstacles_(with_bed(problem, particles_.line.bed_in_reach()), settings.rest_distance) {
        if (settings_.iterations == 0) settings_.iterations = kIterations;
        if (hawse_ < 0) settings_.lra_iterations = 0;
        rounds_ = std::max({settings_.iterations, settings_.bend_iterations, settings_.lra_iterations,
                            settings_.pin_iterations, 1});
        load(problem.lower, 0);
        load(problem.upper, links);
        begin();
    }

    void step() override {
        particles_.predict();
        predict_bodies();
        begin();
        find_contacts();
        const Order order = settings_.coloured ? Order::coloured : Order::upwards;
        for (int round = 0; round < rounds_; ++round) {
            if (due(settings_.bend_iterations, round)) bend(order);
            if (due(settings_.lra_iterations, round)) attach();
            if (due(settings_.pin_iterations, round)) pin_bodies();
            if (due(settings_.iterations, round)) stretch_.sweep(particles_.target, order);
            push_contacts();
        }
        if (!obstacles_.empty()) {
            obstacles_.guard(particles_.position, particles_.target, particles_.inverse_mass);
            obstacles_.guard(body_from_, body_to_, body_inverse_mass_);
        }
        particles_.accept();
        accept_bodies();
    }

    double tension(int link) const override {
        return std::max(0.0, stretch_.multiplier(link)) / (particles_.dt * particles_.dt);
    }
    int iterations() const override { return settings_.iterations; }

private:
    double radius() const {
        return settings_.radius > 0 ? settings_.radius : settings_.resolution * particles_.line.rest;
    }

    /// Whether one of count sweeps, spread evenly over the rounds, falls in this one; the last in the last.
    bool due(int count, int round) const { return (round + 1) * count / rounds_ > round * count / rounds_; }

    void load(const End& end, int node) {
        if (end.kind != EndKind::mass) return;
        Body body;
        body.node = node;
        body.reach = hawse_ < 0 ? 0 : particles_.line.rest * std::abs(hawse_ - node);
        body.inverse_mass = 1 / end.mass;
        body.fall = Vec3(0, 0, -end.weight / end.mass);
        body.position = particles_.position.at(node);
        body.velocity = particles_.velocity.at(node);
        bodies_.push_back(body);
        body_from_ = body_to_ = Field(static_cast<int>(bodies_.size()));
        body_inverse_mass_.push_back(body.inverse_mass);
    }

    void predict_bodies() {
        const double dt = particles_.dt;
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            Body& body = bodies_[k];
            body.velocity += dt * body.fall;
            body_from_.set(static_cast<int>(k), body.position);
            body_to_.set(static_cast<int>(k), body.position + dt * body.velocity);
        }
    }

    void begin() {
        stretch_.begin(particles_.inverse_mass);
        bend_.begin(particles_.inverse_mass);
        angle_.begin(particles_.inverse_mass);
    }

    void bend(Order order) {
        if (settings_.bend_by_angle)
            angle_.sweep(particles_.target, order);
        else
            bend_.sweep(particles_.target, order);
    }

    void find_contacts() {
        if (settings_.self_collision) self_collision_.find(particles_.target);
        if (obstacles_.empty()) return;
        obstacles_.find(particles_.position, particles_.target, particles_.inverse_mass, particles_.dt,
                        contacts_);
        obstacles_.find(body_from_, body_to_, body_inverse_mass_, particles_.dt, body_contacts_);
    }

    void push_contacts() {
        if (settings_.self_collision) self_collision_.project(particles_.target, particles_.inverse_mass);
        if (obstacles_.empty()) return;
        obstacles_.project(contacts_, particles_.position, particles_.target);
        obstacles_.project(body_contacts_, body_from_, body_to_);
    }

    void attach() {
        const Vec3 hawse = particles_.target.at(hawse_);
        attachment_.sweep(particles_.target, hawse, particles_.inverse_mass);
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            Vec3 place = body_to_.at(static_cast<int>(k));
            attachment_.hold(place, hawse, bodies_[k].reach);
            body_to_.set(static_cast<int>(k), place);
        }
    }

    void pin_bodies() {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const int node = bodies_[k].node, number = static_cast<int>(k);
            Pinned particle{particles_.target.at(node), particles_.inverse_mass[node]};
            Pinned body{body_to_.at(number), bodies_[k].inverse_mass};
            pin(particle, body, settings_.k_pin);
            particles_.target.set(node, particle.place);
            body_to_.set(number, body.place);
        }
    }

    void accept_bodies() {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            Body& body = bodies_[k];
            const Vec3 place = body_to_.at(static_cast<int>(k));
            body.velocity = (place - body.position) / particles_.dt;
            body.position = place;
            if (settings_.pin_damping == 0) continue;
            Vec3 velocity = particles_.velocity.at(body.node);
            damp_pin(velocity, particles_.inverse_mass[body.node], body.velocity, body.inverse_mass,
                     settings_.pin_damping);
            particles_.velocity.set(body.node, velocity);
        }
    }

    MethodSettings settings_;
    int hawse_, rounds_ = 0;
    StretchConstraint stretch_;
    BendConstraint bend_;
    AngleConstraint angle_;
    LongRangeAttachment attachment_;
    SelfCollision self_collision_;
    PbdObstacles obstacles_;
    std::vector<PbdContact> contacts_, body_contacts_;
    std::vector<Body> bodies_;
    Field body_from_, body_to_;
    std::vector<double> body_inverse_mass_;
};

std::unique_ptr<Method> make(const Problem& problem, int links, double dt, const MethodSettings& settings) {
    return std::make_unique<Pbd>(problem, links, dt, settings);
}

} // namespace

MethodEntry pbd_method() {
    return {"pbd",
            "position-based dynamics with Gauss-Seidel (Jiang, Ren, He 2020; Mueller and others 2007)",
            "EA (its stiffness is that of its sweeps), structural damping, direction of added mass, sinking "
            "into the seabed",
            make,
            true,
            true};
}

} // namespace windlass::lab
