#include "rigs/whole_anchoring.hpp"

#include <ctime>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace windlass::rigs {

namespace {

using physics::Vec3;

double processor_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double share = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
    return (p - a - share * d).norm();
}

double distance(const Vec3& p, const std::vector<Vec3>& line) {
    double min = (p - line.front()).norm();
    for (std::size_t i = 1; i < line.size(); ++i)
        min = std::min(min, distance(p, line[i - 1], line[i]));
    return min;
}

/// Links land and lift with a rattle that no two models share: what a load gauge shows is its mean.
void smooth_loads(std::vector<Moment>& moments, int half_window) {
    std::vector<double> sum(moments.size() + 1);
    for (std::size_t k = 0; k < moments.size(); ++k)
        sum[k + 1] = sum[k] + moments[k].load;
    const int last = static_cast<int>(moments.size()) - 1;
    for (int k = 0; k <= last; ++k) {
        const int from = std::max(0, k - half_window), to = std::min(last, k + half_window);
        moments[k].load = (sum[to + 1] - sum[from]) / (to + 1 - from);
    }
}

} // namespace

AnchoringRun run_anchoring(const exercise::ExerciseDef& def, const Anchoring& anchoring) {
    constexpr int kMomentsPerSecond = 10;
    const std::uint64_t every = def.tick_rate_hz / kMomentsPerSecond;
    exercise::Exercise exercise(def);
    SameHand hand(anchoring, def.tick_rate_hz);
    exercise::Snapshot seen;
    AnchoringRun run;
    while (exercise.tick() < anchoring.end) {
        hand.work(exercise);
        const double start = processor_time();
        const bool looks = hand.looks() && exercise.tick() >= hand.next_tick();
        const std::uint64_t until = looks ? exercise.tick() + 1 : (exercise.tick() / every + 1) * every;
        do {
            if (!exercise.step(1.0 / def.tick_rate_hz)) throw std::runtime_error("the exercise blew up");
        } while (exercise.tick() < until && exercise.tick() < hand.next_tick());
        run.cost += processor_time() - start;
        if (exercise.tick() % every != 0) continue;
        exercise.view(seen);
        const exercise::TackleView& tackle = seen.tackle[0];
        Moment& moment = run.moments.emplace_back();
        moment.time = seen.time;
        moment.load = moment.gauge = tackle.windlass.hawse_tension;
        moment.cable_out = tackle.chain.cable_out;
        moment.level = seen.model_level;
        moment.error = seen.model_error;
        const physics::StepCounts& steps = seen.model_steps;
        moment.friction = static_cast<double>(steps.friction) /
                          static_cast<double>(std::max<std::uint64_t>(1, steps.steps));
        for (const Eigen::Vector3f& node : tackle.chain.nodes)
            moment.nodes.emplace_back(node.cast<double>());
    }
    smooth_loads(run.moments, kMomentsPerSecond);
    return run;
}

double shape_distance(const Moment& moment, const Moment& reference) {
    double sum = 0;
    for (const Vec3& node : moment.nodes) {
        const double d = distance(node, reference.nodes);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(moment.nodes.size()));
}

physics::ModelError difference(const AnchoringRun& run, const AnchoringRun& reference, std::uint64_t from,
                               std::uint64_t to, int tick_rate_hz) {
    double load = 0, whole = 0, shape = 0;
    long nodes = 0;
    const std::size_t count = std::min(run.moments.size(), reference.moments.size());
    for (std::size_t k = 0; k < count; ++k) {
        const Moment &a = run.moments[k], &b = reference.moments[k];
        const double tick = a.time * tick_rate_hz;
        if (tick < static_cast<double>(from) || tick >= static_cast<double>(to)) continue;
        load += (a.load - b.load) * (a.load - b.load);
        whole += b.load * b.load;
        for (const Vec3& node : a.nodes) {
            const double d = distance(node, b.nodes);
            shape += d * d;
            ++nodes;
        }
    }
    return {std::sqrt(load / whole), std::sqrt(shape / static_cast<double>(nodes))};
}

namespace {

/// In gear all the way: as ships do where it is too deep to let go.
bool walk_back(Drill& drill, int shackles) {
    constexpr double kLongest = 3600; // s
    drill.run(5);
    drill.brake(0);
    drill.run(2);
    drill.speed_lever(-1);
    if (!drill.run_until([&] { return drill.shackles() >= shackles; }, kLongest)) return false;
    drill.speed_lever(0);
    drill.run(2);
    drill.brake(1);
    drill.run(3);
    drill.clutch(false);
    return true;
}

} // namespace

Anchoring work_anchoring(const exercise::ExerciseDef& def, int shackles, double lying, bool must_hold) {
    Drill drill(def);
    const auto must = [](bool happened, const char* what) {
        if (!happened) throw std::runtime_error(std::string("anchoring: ") + what);
    };
    Anchoring anchoring;
    const bool in_gear = def.tackle[0].clutch_in;
    must(in_gear ? walk_back(drill, shackles) : let_go_and_pay_out(drill, shackles), "not paid out");
    // The cable comes to strain; the engine takes most of her way off, the anchor the rest.
    drill.run_until([&] { return drill.windlass().gypsy_load > 75e3 * drill.anchor_size(); }, 300);
    drill.engine(0.5);
    drill.run_until([&] { return drill.now().ship.surge > -0.15; }, 300);
    drill.engine(0);
    const bool holds = drill.run_until([&] { return drill.count("anchor.brought_up") > 0; }, 600);
    must(holds || !must_hold, "not brought up");
    anchoring.brought_up = drill.exercise().tick();
    drill.run(lying);

    anchoring.weigh = drill.exercise().tick();
    drill.clutch(true);
    must(drill.run_until([&] { return drill.windlass().clutch == exercise::ClutchState::in; }, 60),
         "clutch not in");
    drill.run(5);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(0.5);
    must(drill.run_until_event("anchor.aweigh", 3600), "anchor not aweigh");
    drill.run(10);
    drill.speed_lever(0);
    drill.brake(1);
    drill.run(10);
    anchoring.end = drill.exercise().tick();
    anchoring.orders = drill.orders();
    return anchoring;
}

exercise::ExerciseDef at_rate(exercise::ExerciseDef def, int times) {
    def.tick_rate_hz *= times;
    return def;
}

Anchoring at_rate(Anchoring anchoring, int times) {
    for (GivenOrder& order : anchoring.orders)
        order.tick *= times;
    anchoring.brought_up *= times, anchoring.weigh *= times, anchoring.end *= times;
    return anchoring;
}

namespace {
constexpr double kRuns = 0.05; // m/s
constexpr int kLate = 10;      // s
} // namespace

SameHand::SameHand(const Anchoring& anchoring, int tick_rate_hz)
    : orders_(anchoring.orders), late_(static_cast<std::uint64_t>(kLate) * tick_rate_hz) {}

bool SameHand::looks() const {
    return next_ < orders_.size() && std::abs(orders_[next_].cable_speed) > kRuns;
}

std::uint64_t SameHand::next_tick() const {
    if (next_ >= orders_.size()) return std::numeric_limits<std::uint64_t>::max();
    return orders_[next_].tick - (looks() ? std::min(late_, orders_[next_].tick) : 0);
}

void SameHand::work(exercise::Exercise& exercise) {
    for (; next_ < orders_.size(); ++next_) {
        const GivenOrder& order = orders_[next_];
        if (exercise.tick() < next_tick()) return;
        if (looks() && exercise.tick() < order.tick + late_) {
            exercise.view(snapshot_);
            const exercise::TackleView& tackle = snapshot_.tackle[0];
            const double left = order.cable_out - tackle.chain.cable_out;
            const bool short_of = order.cable_speed > 0 ? left > 0 : left < 0;
            const bool stands = std::abs(tackle.windlass.cable_speed) <= kRuns;
            if (short_of && !(stands && exercise.tick() >= order.tick)) return;
        }
        exercise.apply(order.command);
    }
}

} // namespace windlass::rigs
