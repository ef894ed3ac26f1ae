#include "bench/where.hpp"

#include "bench/process_cpu.hpp"
#include "server/config/config.hpp"
#include "server/dds/publisher.hpp"
#include "server/exercise/exercise.hpp"
#include "server/run/session.hpp"

#include <fmt/format.h>

#include <ctime>
#include <functional>
#include <vector>

namespace windlass::bench {

namespace {

using namespace run;

constexpr double kBegin = 7;  // s of exercise time
constexpr int kTogether = 15; // ticks between two looks at the clock, which costs as much as a small tick

double thread_cpu() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Plan {
    const exercise::ExerciseDef& def;
    double seconds;
    double dt() const { return 1.0 / def.tick_rate_hz; }
    int blocks(double s) const { return static_cast<int>(s * def.tick_rate_hz) / kTogether; }
};

/// ms of this thread for a second of exercise; between blocks of ticks, `meanwhile` is not counted.
double cost(
    const Plan& plan, const std::function<void()>& tick, const std::function<void()>& meanwhile = [] {}) {
    double sum = 0;
    const int before = plan.blocks(kBegin), all = before + plan.blocks(plan.seconds);
    for (int block = 0; block < all; ++block) {
        const double from = thread_cpu();
        for (int i = 0; i < kTogether; ++i)
            tick();
        if (block >= before) sum += thread_cpu() - from;
        meanwhile();
    }
    return 1000 * sum / plan.seconds;
}

double of_step(const Plan& plan) {
    exercise::Exercise exercise(plan.def);
    return cost(plan, [&] { exercise.step(plan.dt()); });
}

/// ms for a second of each of so many exercises, a tick of each in turn: with caches that others have used.
double of_turns(const Plan& plan, int exercises) {
    std::vector<exercise::Exercise> all;
    for (int i = 0; i < exercises; ++i)
        all.emplace_back(plan.def);
    const auto turns = [&](double s) {
        for (int k = plan.blocks(s) * kTogether; k > 0; --k)
            for (auto& one : all)
                one.step(plan.dt());
    };
    turns(kBegin);
    const double from = thread_cpu();
    turns(plan.seconds);
    return 1000 * (thread_cpu() - from) / plan.seconds / exercises;
}

/// show: every tick, or none of which nothing must be told.
double of_session(const Plan& plan, bool show) {
    run::Session session(plan.def, {});
    return cost(plan, [&] {
        session.tick(show);
        session.clear_news();
    });
}

struct Published {
    double tick = 0, publish = 0; // ms/s of the exercise's thread and of the one that writes
};

/// As a server does it, in wall time that goes as fast as the exercise's.
Published of_publishing(const Plan& plan, int domain) {
    wire::Participant member({domain, "exercise/where", "bench", {}, {}});
    dds::PublishingPool pool(1);
    dds::Publisher publisher(member, pool);
    run::Session session(plan.def, {});
    publisher.prepare(plan.def.tackle.size(), 2048);
    double now = 0, writing = 0;
    int block = 0;
    Published published;
    published.tick = cost(
        plan,
        [&] {
            now += plan.dt();
            session.tick(publisher.wants(session.now_tick() + 1, session.status(), now));
            session.clear_news();
            if (session.seen()) publisher.offer(session.snapshot(), session.status(), now);
        },
        [&] {
            publisher.flush(std::chrono::seconds(1));
            if (++block == plan.blocks(kBegin)) writing = cpu_by_thread(getpid())["publish"];
        });
    published.publish = 1000 * (cpu_by_thread(getpid())["publish"] - writing) / plan.seconds;
    if (publisher.dropped() > 0) throw std::runtime_error("pictures were dropped: this machine is too busy");
    return published;
}

} // namespace

void tell_where(const std::filesystem::path& exercise, double seconds, int domain) {
    const exercise::ExerciseDef def = config::load_exercise(exercise, WINDLASS_CONFIG_DIR);
    const Plan plan{def, seconds};
    const double step = of_step(plan), session = of_session(plan, false), each = of_session(plan, true);
    const Published published = of_publishing(plan, domain);
    const auto line = [](const char* what, double ms) { fmt::print("| {} | {:.2f} |\n", what, ms); };
    fmt::print("| of one exercise | ms/s |\n|---|---|\n");
    line("the model's steps", step);
    line("its run: orders, events, alerts, checkpoints", session - step);
    line("pictures when due, handed over", published.tick - session);
    line("written to nobody, on the writers' thread", published.publish);
    line("(the steps, with 200 exercises in turn on one thread)", of_turns(plan, 200));
    line("(a picture of every tick instead, none handed over)", each - session);
}

} // namespace windlass::bench
