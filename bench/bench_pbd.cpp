// One step of the direct solver beside one step of PBD at its published settings, in one run: what each costs
// and how far its links are from the elastic law. See README.md.

#include "bench/lab/case/processor_time.hpp"
#include "bench/problem/method.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace windlass;
using lab::Method;
using physics::Vec3;

constexpr int kParticles = 1000;          ///< as published
constexpr int kLinks = 1000;              ///< of the direct solver
constexpr double kLength = 200;           ///< m
constexpr double kAnchor = 10e3;          ///< kg
constexpr double kPbdStep = 1.0 / 60;     ///< s, a picture
constexpr double kDirectStep = 1.0 / 600; ///< s, the least at which 1000 links are stepped (README.md)
constexpr double kRun = 5;                ///< s, before the swing comes taut
constexpr int kBlock = 10;                ///< steps between two looks at the clock

/// 200 m of 76 mm chain in air with a 10 t anchor, as in cases/hang.json and cases/swing.json.
lab::Problem chain() {
    lab::Problem problem;
    problem.line = physics::stud_link_chain(0.076, physics::Grade::k3, kLength);
    problem.line.damping_time = 0;
    problem.environment.water_density = 0;
    problem.environment.depth = 1e6;
    problem.length = kLength;
    problem.lower = {
        .kind = lab::EndKind::mass, .mass = kAnchor, .weight = kAnchor * physics::kGravity, .motion = {}};
    return problem;
}

/// At rest in elastic balance, then its hawse end goes up and down by 1 m in 8 s.
lab::Problem hanging() {
    lab::Problem problem = chain();
    const double weight = problem.line.mass_per_metre * physics::kGravity;
    const double stiffness = problem.line.stiffness, pull = problem.lower.weight;
    problem.start = [=](double arc) {
        const double up = kLength - arc;
        return Vec3(0, 0, -up - (pull * up + weight * (kLength * up - 0.5 * up * up)) / stiffness);
    };
    problem.upper.kind = lab::EndKind::driven;
    problem.upper.motion = [](double time) {
        return Vec3(0, 0, 1 - std::cos(2 * std::numbers::pi / 8 * time));
    };
    return problem;
}

/// Released from horizontal.
lab::Problem swinging() {
    lab::Problem problem = chain();
    problem.start = [](double arc) { return Vec3(kLength - arc, 0, 0); };
    return problem;
}

/// One method that begins anew after kRun seconds.
class Runner {
public:
    Runner(const char* name, const lab::Problem& problem, int links, double dt,
           const lab::MethodSettings& settings = {})
        : entry_(*lab::find_method(name)), problem_(problem), links_(links), dt_(dt), settings_(settings) {
        begin();
    }

    void begin() { method_ = lab::make_method(entry_, problem_, links_, dt_, settings_); }
    Method& method() { return *method_; }

    /// Processor time of some steps, s.
    void run_block() {
        if (method_->time() + kBlock * dt_ > kRun) begin();
        const double before = lab::processor_seconds();
        for (int k = 0; k < kBlock; ++k)
            method_->step();
        spent_ += lab::processor_seconds() - before;
        steps_ += kBlock;
    }

    double microseconds() const { return 1e6 * spent_ / static_cast<double>(steps_); }
    double dt() const { return dt_; }

    /// Largest difference of any link's length, in any step of a run, from l (1 + T / EA) with the tension T
    /// that the method itself measures, over l; a link without tension may be as short as it likes.
    double largest_error() {
        begin();
        const double rest = kLength / links_;
        double largest = 0;
        while (method_->time() < kRun) {
            method_->step();
            for (int i = 0; i < links_; ++i) {
                const double tension = method_->tension(i);
                const double length = (method_->position(i + 1) - method_->position(i)).norm();
                const double error = length / rest - 1 - tension / problem_.line.stiffness;
                if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
                largest = std::max(largest, tension > 0 ? std::abs(error) : error);
            }
        }
        begin();
        return largest;
    }

private:
    const lab::MethodEntry& entry_;
    lab::Problem problem_;
    int links_;
    double dt_;
    lab::MethodSettings settings_;
    std::unique_ptr<Method> method_;
    double spent_ = 0;
    long steps_ = 0;
};

/// All side by side: a block of each in turn, so that whatever else the machine does meets all alike.
void direct_beside_pbd(benchmark::State& state, lab::Problem (*make)()) {
    const lab::Problem problem = make();
    Runner direct("production", problem, kLinks, kDirectStep);
    Runner long_step("production", problem, kLinks, kPbdStep);
    Runner pbd("pbd", problem, kParticles - 1, kPbdStep);
    Runner coloured("pbd", problem, kParticles - 1, kPbdStep, {.coloured = true});
    Runner colliding("pbd", problem, kParticles - 1, kPbdStep, {.self_collision = true});
    while (state.KeepRunning()) {
        for (Runner* runner : {&direct, &long_step, &pbd, &coloured, &colliding})
            runner->run_block();
    }
    const double direct_error = direct.largest_error(), pbd_error = pbd.largest_error();
    state.counters["direct_us"] = direct.microseconds();
    state.counters["pbd_us"] = pbd.microseconds();
    state.counters["coloured_us"] = coloured.microseconds();
    state.counters["self_collision_us"] = colliding.microseconds();
    state.counters["pbd/direct"] = pbd.microseconds() / direct.microseconds();
    state.counters["coloured/direct"] = coloured.microseconds() / direct.microseconds();
    state.counters["direct_error"] = direct_error;
    state.counters["pbd_error"] = pbd_error;
    state.counters["long_step_us"] = long_step.microseconds();
    state.counters["long_step_error"] = long_step.largest_error();
    state.counters["coloured_error"] = coloured.largest_error();
    state.counters["pbd/direct_error"] = pbd_error / direct_error;
    state.counters["direct_ms_per_s"] = 1e-3 * direct.microseconds() / direct.dt();
    state.counters["pbd_ms_per_s"] = 1e-3 * pbd.microseconds() / pbd.dt();
}

BENCHMARK_CAPTURE(direct_beside_pbd, hanging, hanging)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(direct_beside_pbd, swinging, swinging)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
