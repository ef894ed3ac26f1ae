// What a step of the chain, of a whole ground tackle and of an exercise costs. See README.md.

#include "rigs/chain_step.hpp"
#include "rigs/tackle_rig.hpp"
#include "server/exercise/exercise.hpp"
#include "server/physics/tackle/chain_contacts.hpp"
#include "server/physics/tackle/ground_tackle.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace windlass;
using physics::Vec3;

constexpr int kTickRate = 300;            ///< Hz
constexpr double kTick = 1.0 / kTickRate; ///< s
constexpr double kCable = 200;            ///< m
constexpr double kDeep = 300;             ///< m, where the cable hangs clear of the bottom
constexpr double kShallow = 40;           ///< m, where half of it lies on the bottom

physics::ChainDef cable_of(int links) {
    physics::ChainDef chain;
    chain.node_spacing = kCable / links;
    return chain;
}

physics::EnvironmentDef sea(double depth) {
    physics::EnvironmentDef environment;
    environment.depth = depth;
    return environment;
}

/// A hawse pipe lip in a swell of 1 m and 8 s, so that the chain never comes to rest.
Vec3 in_swell(const Vec3& lip, double time) {
    return lip + Vec3(0, 0, 1 - std::cos(2 * std::numbers::pi / 8 * time));
}

/// Times faster than real time on one core, for the benchmark's table.
void report_speed(benchmark::State& state, double simulated_seconds) {
    state.counters["x_real_time"] = benchmark::Counter(simulated_seconds, benchmark::Counter::kIsRate);
}

/// Steps that were not what they should be, of each thousand, by kind; kinds that there are none of are left
/// out.
void report_steps(benchmark::State& state, const physics::StepCounts& counts) {
    const auto report = [&](const char* name, std::uint64_t number) {
        if (number > 0)
            state.counters[name] = 1e3 * static_cast<double>(number) / static_cast<double>(counts.steps);
    };
    report("implicit", counts.implicit);
    report("unsolved", counts.unsolved);
    report("friction", counts.friction);
    report("contacts", counts.contacts);
    report("dropped", counts.dropped);
    report("capped", counts.capped);
}

/// One link of a cable at rest: its tension, N, and the way it points from the anchor up.
struct LinkAtRest {
    double tension = 0;
    Vec3 direction = Vec3::UnitZ();
};

/// The chain alone with a held top: what the solver itself costs.
struct Cable {
    physics::ChainDef def;
    physics::EnvironmentDef environment;
    physics::ChainState chain;
    physics::ChainSolver solver;
    physics::LockedEnd top;
    Vec3 lip = Vec3::Zero();
    double dt = kTick; ///< s, the substep that a ground tackle would take
    double time = 0;
    double foot_mass = 0, foot_weight = 0; ///< kg, N; none: made fast

    /// Starts at rest from the given foot, link by link; at_rest(s) gives the link at s metres from the foot.
    template <class AtRest>
    Cable(int links, double depth, const Vec3& foot, const AtRest& at_rest)
        : def(cable_of(links)),
          environment(sea(depth)),
          chain(physics::straight_chain(def, foot, foot + Vec3(0, 0, kCable), kCable, links + 2)),
          solver(def, links + 2) {
        environment.current_speed = 0;
        double max = 0;
        for (int i = 0; i < links; ++i) {
            const LinkAtRest link = at_rest((i + 0.5) * def.node_spacing);
            const double length = def.node_spacing * (1 + link.tension / def.stiffness);
            chain.position.set(i + 1, chain.position.at(i) + length * link.direction);
            chain.set_tension(i, link.tension);
            max = std::max(max, link.tension);
        }
        lip = chain.position.at(links);
        const double wave = std::sqrt(max / def.mass_per_metre); // m/s, as GroundTackle::substeps()
        dt = kTick / std::ceil(kTick * wave / (0.5 * def.node_spacing));
    }

    /// contacts: looked for and taken into the step; may be null.
    void step(physics::ChainContacts* contacts = nullptr, const physics::HullSurface* hull = nullptr) {
        time += dt;
        physics::ChainTail tail;
        if (foot_mass > 0) {
            tail.inverse_mass.xx = tail.inverse_mass.yy = tail.inverse_mass.zz = 1 / foot_mass;
            tail.velocity_before = chain.velocity.at(0);
            tail.velocity = tail.velocity_before - Vec3(0, 0, step_kick(chain, dt) * foot_weight / foot_mass);
        }
        const auto result = rigs::step_chain(
            solver, chain, environment, dt, tail, top, in_swell(lip, time), nullptr,
            contacts == nullptr ? nullptr : &contacts->find(def, environment, chain, dt, nullptr, hull));
        ++steps, iterations += result.iterations;
    }

    bool finite() const { return std::isfinite(chain.position.z[0] + chain.tension[chain.links - 1]); }

    long steps = 0, iterations = 0;
};

/// Hanging into deep water with an anchor of 9.9 t at its end.
Cable hanging(int links) {
    const physics::ChainDef def;
    const double density = physics::EnvironmentDef{}.water_density;
    const double mass = physics::AnchorDef{}.mass;
    const double weight = mass * physics::kGravity * (1 - density / physics::kSteelDensity);
    Cable cable(links, kDeep, Vec3(0, 0, -kCable),
                [&](double s) { return LinkAtRest{weight + s * physics::weight_in_water(def, density)}; });
    cable.foot_mass = mass;
    cable.foot_weight = weight;
    return cable;
}

/// Half on the bottom, half in the catenary that belongs to it.
Cable half_on_bottom(int links) {
    const double lifted = 0.5 * kCable, height = kShallow;
    const double a = (lifted * lifted - height * height) / (2 * height); // horizontal tension / weight, m
    const double weight =
        physics::weight_in_water(physics::ChainDef{}, physics::EnvironmentDef{}.water_density);
    return Cable(links, kShallow, Vec3(0, 0, -kShallow), [&](double s) {
        const double up = std::max(0.0, s - lifted); // m of cable above the touch-down
        const double size = std::hypot(a, up);
        return LinkAtRest{weight * size, Vec3(a, 0, up) / size};
    });
}

void solver_step(benchmark::State& state, Cable (*make)(int)) {
    Cable cable = make(static_cast<int>(state.range(0)));
    for (int k = 0; k < 5 * kTickRate; ++k)
        cable.step();
    while (state.KeepRunning())
        cable.step();
    if (!cable.finite()) return state.SkipWithError("the chain blew up");
    report_speed(state, static_cast<double>(state.iterations()) * cable.dt);
    state.counters["steps_a_second"] = 1 / cable.dt;
    state.counters["iterations"] = static_cast<double>(cable.iterations) / static_cast<double>(cable.steps);
}

/// The same with all that the chain may touch looked for: itself, its least bend, a hull beside it. heading:
/// rad, of the hull's bow from the world's x axis, along which the cable leads aft; turned about, it leads
/// ahead.
void solver_step_with_contacts(benchmark::State& state, Cable (*make)(int), double heading) {
    Cable cable = make(static_cast<int>(state.range(0)));
    physics::ChainContacts contacts(cable.chain.links + 2, true);
    const physics::ShipDef ship;
    const physics::ObstacleMesh mesh = physics::hull_mesh(ship, cable.def.contact_diameter);
    physics::HullSurface hull{&mesh, {}, {}};
    hull.motion.attitude = Eigen::AngleAxisd(heading, Vec3::UnitZ());
    const Vec3 lip_on_board(ship.hawse_forward, ship.hawse_outboard, ship.hawse_height);
    const auto step = [&] { // the hull heaves with the lip
        hull.motion.position = in_swell(cable.lip, cable.time) - hull.motion.attitude * lip_on_board;
        cable.step(&contacts, &hull);
    };
    for (int k = 0; k < 5 * kTickRate; ++k)
        step();
    while (state.KeepRunning())
        step();
    if (!cable.finite()) return state.SkipWithError("the chain blew up");
    report_speed(state, static_cast<double>(state.iterations()) * cable.dt);
    state.counters["iterations"] = static_cast<double>(cable.iterations) / static_cast<double>(cable.steps);
    state.counters["touches"] =
        static_cast<double>(contacts.find(cable.def, cable.environment, cable.chain, cable.dt, nullptr, &hull)
                                .node_contacts()
                                .size());
}

/// A heap: 200 m lowered straight down on the bottom, ten metres of it still hanging.
void heap_step(benchmark::State& state) {
    const int links = static_cast<int>(state.range(0));
    const physics::ChainDef def = cable_of(links);
    physics::EnvironmentDef environment = sea(kShallow);
    environment.current_speed = 0;
    physics::ChainState chain =
        physics::straight_chain(def, Vec3(0, 0, -kShallow), Vec3(0, 0, kCable - kShallow), kCable, links);
    physics::ChainSolver solver(def, links);
    physics::ChainContacts contacts(links, true);
    physics::LockedEnd top;
    double height = kCable - kShallow;
    std::size_t pairs = 0;
    const auto step = [&] {
        height = std::max(10 - kShallow, height - 4 * kTick);
        physics::ContactSet& set = contacts.find(def, environment, chain, kTick, nullptr, nullptr);
        rigs::step_chain(solver, chain, environment, kTick, {}, top, Vec3(0, 0, height), nullptr, &set);
        pairs = set.pair_contacts().size();
    };
    for (int k = 0; k < 55 * kTickRate; ++k)
        step();
    while (state.KeepRunning())
        step();
    if (!std::isfinite(chain.position.z[links / 2])) return state.SkipWithError("the heap blew up");
    report_speed(state, static_cast<double>(state.iterations()) * kTick);
    state.counters["touching_pairs"] = static_cast<double>(pairs);
}

/// Chain, anchor as a rigid body and windlass together, with as many substeps as its tension asks for.
void tackle_second(benchmark::State& state) {
    const physics::EnvironmentDef environment = sea(kDeep);
    const Vec3 lip(0, 0, 0);
    physics::TackleSetup setup;
    setup.chain = cable_of(static_cast<int>(state.range(0)));
    setup.cable_out = kCable;
    physics::GroundTackle tackle(setup, environment, lip);
    double time = 0;
    long steps = 0;
    while (state.KeepRunning()) {
        for (int tick = 0; tick < kTickRate; ++tick) {
            const int substeps = tackle.substeps(kTick, 16);
            for (int k = 0; k < substeps; ++k) {
                time += kTick / substeps;
                rigs::step_tackle(tackle, environment, kTick / substeps, {}, {}, in_swell(lip, time));
            }
            steps += substeps;
        }
    }
    if (!tackle.finite()) return state.SkipWithError("the tackle blew up");
    report_speed(state, static_cast<double>(state.iterations()));
    report_steps(state, tackle.step_counts());
    state.counters["substeps"] =
        static_cast<double>(steps) / static_cast<double>(state.iterations() * kTickRate);
}

/// A whole exercise, its anchor hanging on 200 m of cable in deep water.
exercise::Exercise exercise_hanging() {
    exercise::ExerciseDef def;
    def.model.adaptive = false; // every node of 1 m links in every step
    def.environment.depth = kDeep;
    def.tackle[0].cable_out = kCable;
    return exercise::Exercise(def);
}

/// The same after a let-go in 25 m with way on: most of the cable lies on the bottom.
exercise::Exercise exercise_let_go() {
    exercise::ExerciseDef def;
    def.model.adaptive = false;
    def.ship_start.surge = -2;
    exercise::Exercise exercise(def);
    exercise.apply(exercise::WindlassOrder{.brake = 0});
    exercise::Snapshot snapshot;
    do {
        for (int k = 0; k < kTickRate / 10; ++k)
            exercise.step(kTick);
        exercise.view(snapshot);
    } while (snapshot.tackle[0].chain.cable_out < kCable - 5);
    exercise.apply(exercise::WindlassOrder{.brake = 1});
    return exercise;
}

/// Riding to a cable of 200 m in 25 m, as the exercise's file has it: at the policy's settings.
exercise::Exercise riding(double swell_height) {
    exercise::ExerciseDef def;
    def.ship_start.surge = -2;
    def.weather.swell_height = swell_height;
    def.weather.swell_period = 11;
    def.weather.wave_height = 0.3 * swell_height;
    def.weather.wave_period = 4.5;
    exercise::Exercise exercise(def);
    exercise.apply(exercise::WindlassOrder{.brake = 0});
    exercise::Snapshot snapshot;
    do {
        for (int k = 0; k < kTickRate / 10; ++k)
            exercise.step(kTick);
        exercise.view(snapshot);
    } while (snapshot.tackle[0].chain.cable_out < kCable - 35);
    exercise.apply(exercise::WindlassOrder{.brake = 1});
    return exercise;
}
exercise::Exercise riding_in_calm() {
    return riding(0);
}
exercise::Exercise riding_in_swell() {
    return riding(2);
}

/// What 64 waves do to a ship at one instant.
void ship_in_waves(benchmark::State& state) {
    physics::SeaSurface sea({.wave_height = 1, .swell_height = 2}, 25);
    sea.order({.wave_height = 1, .wave_from = 1, .swell_height = 2, .swell_from = 1}, 0, 1e6);
    physics::ShipInWaves in_waves(physics::ShipDef{}, 25);
    double t = 0;
    while (state.KeepRunning())
        benchmark::DoNotOptimize(in_waves.motion(sea, {10, 20, 0.3}, t += kTick).heave);
    state.counters["waves"] = static_cast<double>(sea.components().size());
}

/// One tick of an exercise: its step, its view, which the server takes after each step, or both.
void exercise_tick(benchmark::State& state, exercise::Exercise (*make)(), bool step, bool view) {
    exercise::Exercise exercise = make();
    for (int k = 0; k < 30 * kTickRate; ++k)
        exercise.step(kTick);
    exercise::Snapshot snapshot;
    exercise.view(snapshot);
    bool good = true;
    while (state.KeepRunning()) {
        if (step) good = exercise.step(kTick) && good;
        if (view) exercise.view(snapshot);
        benchmark::DoNotOptimize(snapshot.state_hash);
    }
    if (!good) return state.SkipWithError("the exercise blew up");
    if (step && view) report_speed(state, static_cast<double>(state.iterations()) * kTick);
    state.counters["nodes"] = snapshot.model_nodes;
    report_steps(state, snapshot.model_steps); // of the last ten seconds
}

/// Both windlasses with 12 shackles each, 11 of them to be had, at the policy's settings. Falling astern.
exercise::ExerciseDef two_windlasses(double depth, double cable_out) {
    exercise::ExerciseDef def;
    def.environment.depth = depth;
    def.ship_start.surge = -1.5;
    def.tackle[0].cable_out = cable_out;
    def.tackle.push_back(def.tackle[0]);
    def.tackle[1].side = exercise::Side::starboard;
    return def;
}

exercise::ExerciseDef both_hanging() {
    return two_windlasses(400, 300);
}
exercise::ExerciseDef both_let_go() {
    return two_windlasses(40, 5);
}

/// So many seconds of an exercise with two cables, step and view, from its start or after it has run for so
/// long before. brake: both hand-wheels.
void two_cables(benchmark::State& state, exercise::ExerciseDef (*define)(), double brake, int before) {
    constexpr int kSeconds = 30;
    unsigned nodes = 0;
    double out = 0; // m, of both
    physics::StepCounts counts;
    while (state.KeepRunning()) {
        state.PauseTiming();
        exercise::Exercise exercise(define());
        exercise::Snapshot snapshot;
        const auto order = [&](double position) {
            exercise.apply(exercise::WindlassOrder{.side = exercise::Side::port, .brake = position});
            exercise.apply(exercise::WindlassOrder{.side = exercise::Side::starboard, .brake = position});
        };
        order(brake);
        for (int k = 0; k < before * kTickRate; ++k) {
            exercise.step(kTick);
            if (k == before * kTickRate / 2) order(1);
        }
        state.ResumeTiming();
        for (int k = 0; k < kSeconds * kTickRate; ++k) {
            if (!exercise.step(kTick)) return state.SkipWithError("the exercise blew up");
            exercise.view(snapshot);
            if (k % (10 * kTickRate) == 0) counts = counts + snapshot.model_steps;
        }
        nodes = std::max(nodes, snapshot.model_nodes);
        out = snapshot.tackle[0].chain.cable_out + snapshot.tackle[1].chain.cable_out;
    }
    report_speed(state, static_cast<double>(state.iterations()) * kSeconds);
    report_steps(state, counts);
    state.counters["nodes"] = nodes;
    state.counters["shackles"] = physics::shackles_from_metres(out);
}

BENCHMARK_CAPTURE(solver_step, hanging, hanging)->Arg(50)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solver_step, half_on_bottom, half_on_bottom)
    ->Arg(50)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solver_step_with_contacts, hanging, hanging, 0)
    ->Arg(50)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solver_step_with_contacts, leading_ahead, half_on_bottom, std::numbers::pi)
    ->Arg(50)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solver_step_with_contacts, against_the_bow, half_on_bottom, 0)
    ->Arg(50)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(heap_step)->Arg(50)->Arg(200)->Unit(benchmark::kMicrosecond);
BENCHMARK(tackle_second)->Arg(50)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exercise_tick, hanging_step, exercise_hanging, true, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exercise_tick, hanging_view, exercise_hanging, false, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exercise_tick, hanging, exercise_hanging, true, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exercise_tick, let_go, exercise_let_go, true, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exercise_tick, riding_in_calm, riding_in_calm, true, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exercise_tick, riding_in_swell, riding_in_swell, true, true)->Unit(benchmark::kMicrosecond);
BENCHMARK(ship_in_waves)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(two_cables, hanging, both_hanging, 1, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_cables, let_go, both_let_go, 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_cables, laid_out, both_let_go, 0.019, 240)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
