// States that no exercise ever had, as a checkpoint from outside may bring: refused with the field that is
// wrong, or run on without harm to the server and the exercises beside.

#include "server/exercise/tick/deck.hpp"
#include "server/run/session.hpp"

#include "rigs/drill.hpp"
#include "rigs/grip_in_proportion.hpp"
#include "tests/scenario/forged_state.hpp"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace windlass {
using namespace rigs;

namespace {

using namespace exercise;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
const std::array kHostile{Hostile{0, 0},
                          Hostile{-1, -1},
                          Hostile{1e300, 100'000'000},
                          Hostile{std::nan(""), kLeast},
                          Hostile{kInfinity, kMost},
                          Hostile{std::numeric_limits<double>::denorm_min(), 1LL << 32}, // an int's 0
                          Hostile{1e6, 2}};
/// For several fields at once: what the check of one field lets pass, and what it does not.
const std::array kHostileTogether{Hostile{0, 0},          Hostile{-1, -1},          Hostile{1, 1},
                                  Hostile{1e300, 2},      Hostile{std::nan(""), 3}, Hostile{kInfinity, 4},
                                  Hostile{1e6, 1000},     Hostile{-9e18, kLeast},   Hostile{1e4, 255},
                                  Hostile{-1e4, 1 << 20}, Hostile{1e10, -2},        Hostile{1e-3, 0},
                                  Hostile{30, 1},         Hostile{-30, 0},          Hostile{0.3, 1}};

/// Ends the process when a state does not come back.
void hangs(int) {
    constexpr std::string_view kWhy = "HANGS\n";
    (void)!write(STDERR_FILENO, kWhy.data(), kWhy.size());
    _exit(99);
}
void watch(bool on) {
    constexpr int kPatience = 30; // s of processor time, of what takes some hundredths
    std::signal(SIGPROF, hangs);
    const itimerval limit{{}, {on ? kPatience : 0, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

/// What became of a state.
enum class Outcome { refused, stopped, ran_on };
struct Tried {
    Outcome outcome = Outcome::ran_on;
    std::string refusal; ///< its text
};

constexpr int kTicks = 30;

/// Restores the state in a session, as RestoreCommand does, and runs it for some ticks.
Tried try_state(run::Session& session, std::vector<std::uint8_t> checkpoint) {
    const auto give = [&](run::OrderContent order) {
        run::Inbox inbox;
        inbox.orders.push_back({"instructor", std::move(order)});
        static double now = 0;
        session.take(inbox, now += 10); // wall time enough for every refusal to be told
    };
    watch(true);
    session.clear_news();
    give(run::StateOrder{.from = "outside", .checkpoint = std::move(checkpoint)});
    for (const ExerciseEvent& event : session.events())
        if (event.code == "command.refused") return {Outcome::refused, event.text};
    give(run::RunOrder()); // to start
    give(Order{WindlassOrder{.brake = 0.5}});
    for (int tick = 0; tick < kTicks; ++tick)
        session.tick(); // throws what a host would have to set the exercise aside for
    return {session.running() ? Outcome::ran_on : Outcome::stopped, ""};
}

/// What a tick of a forged state may cost, as Exercise::visits() counts it; every machine counts the same. A
/// quarter of what a tick has time for, so that the others of a server have theirs. Of 20 000 states the
/// dearest came to 15 600.
constexpr std::int64_t kMostVisits = exercise::kMaxTickVisits / 4;

/// The dearest of the first ticks of a state that is not refused.
std::int64_t most_visits(const std::vector<std::uint8_t>& checkpoint) {
    Exercise exercise = read_checkpoint(checkpoint);
    std::int64_t most = 0;
    for (int tick = 0; tick < kTicks && exercise.step(1.0 / exercise.def().tick_rate_hz); ++tick)
        most = std::max(most, exercise.visits());
    return most;
}

/// A session to restore states in.
run::Session session_for(const ForgedState& state) {
    run::SessionOptions options;
    options.fault_folder = "/nowhere"; // no dumps
    return {state.source().def(), options};
}

/// Several changes, which a seed draws.
Changes drawn(std::uint64_t seed, int fields) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
    Changes changes;
    const int count = 2 + below(6);
    for (int k = 0; k < count; ++k) {
        // Half of them near the first, so that what belongs together comes together.
        int field = below(static_cast<std::size_t>(fields));
        if (k > 0 && below(2) == 0) field = std::clamp(changes[0].field + below(41) - 20, 0, fields - 1);
        const auto put = static_cast<std::size_t>(below(kHostileTogether.size()));
        if (std::ranges::none_of(changes, [&](const Change& c) { return c.field == field; }))
            changes.push_back({.field = field, .hostile = kHostileTogether[put]});
    }
    return changes;
}

/// Several small changes, which a seed draws: a state that looks as if an exercise might have come to it.
Changes nudged(std::uint64_t seed, int fields) {
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    Changes changes;
    const int count = 1 + below(12);
    for (int k = 0; k < count; ++k) {
        Change change{.field = below(fields), .hostile = {}, .added = below(4) != 0, .spread = {}};
        if (k > 0 && below(2) == 0)
            change.field = std::clamp(changes[0].field + below(41) - 20, 0, fields - 1);
        const double size = std::pow(10.0, below(10) - 5);
        change.hostile = {(below(2) == 0 ? -1 : 1) * (1 + below(9)) * size, below(7) - 3};
        change.spread = static_cast<Spread>(below(3));
        if (std::ranges::none_of(changes, [&](const Change& c) { return c.field == change.field; }))
            changes.push_back(change);
    }
    return changes;
}

/// What a child process tells of its work as long as it lives.
struct Told {
    std::uint64_t seed = 0; ///< at work
    std::array<int, 3> outcomes{};
    std::int64_t most_visits = 0; ///< of any tick of a state that was not refused
    std::array<char, 200> thrown{};
};
/// Memory that a child shares with us.
class Shared {
public:
    Shared() : told_(mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (told_ == MAP_FAILED) throw std::runtime_error("no memory to share");
        new (told_) Told;
    }
    ~Shared() { munmap(told_, sizeof(Told)); }
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;
    Told& told() { return *static_cast<Told*>(told_); }

private:
    void* told_;
};

/// Does the work in a process of its own, which may die of it. Says how it died; empty: it did not.
std::string in_child(Told& told, const std::function<void()>& work) {
    constexpr int kThrew = 98; // exit code
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) return "is not there: no fork";
    if (child == 0) {
        try {
            work();
        } catch (const std::exception& error) {
            std::snprintf(told.thrown.data(), told.thrown.size(), "throws %s", error.what());
            _exit(kThrew);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return std::string("ends by ") + strsignal(WTERMSIG(status));
    if (WEXITSTATUS(status) == kThrew) return told.thrown.data();
    if (WEXITSTATUS(status) != 0) return "ends with exit code " + std::to_string(WEXITSTATUS(status));
    return "";
}

/// Tries the states of these seeds. A process that dies of one is told with the fewest changes that do it.
void try_seeds(const Exercise& source, Changes (*draw)(std::uint64_t, int), std::uint64_t first,
               std::uint64_t end) {
    const ForgedState state(source);
    Shared shared;
    Told& told = shared.told();
    while (first < end) {
        const std::string died = in_child(told, [&] {
            run::Session session = session_for(state);
            for (std::uint64_t seed = first; seed < end; ++seed) {
                told.seed = seed;
                const std::vector<std::uint8_t> checkpoint = state.checkpoint(draw(seed, state.fields()));
                const Tried tried = try_state(session, checkpoint);
                ++told.outcomes[static_cast<std::size_t>(tried.outcome)];
                if (tried.outcome != Outcome::refused)
                    told.most_visits = std::max(told.most_visits, most_visits(checkpoint));
            }
        });
        if (died.empty()) break;
        Changes changes = draw(told.seed, state.fields());
        const auto dies = [&](const Changes& of) {
            return !in_child(told, [&] {
                        run::Session session = session_for(state);
                        try_state(session, state.checkpoint(of));
                    }).empty();
        };
        const bool alone = dies(changes);
        for (std::size_t k = 0; alone && k < changes.size();) {
            Changes fewer = changes;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
            if (dies(fewer))
                changes = fewer;
            else
                ++k;
        }
        ADD_FAILURE() << "seed " << told.seed << (alone ? " " : ", after those before it, ") << died << ": "
                      << state.words(changes);
        first = told.seed + 1;
    }
    const auto& [refused, stopped, ran_on] = told.outcomes;
    EXPECT_GT(refused, 0);
    EXPECT_GT(ran_on, 0);
    // What no exercise comes to is to be refused: a fault that stops it is for what nobody foresaw.
    EXPECT_LE(50 * stopped, ran_on + stopped);
    EXPECT_LE(told.most_visits, kMostVisits);
    std::printf("%d states refused, %d ran on, %d were stopped by a fault; a tick cost %lld visits at most\n",
                refused, ran_on, stopped, static_cast<long long>(told.most_visits));
}

/// Each step-th field of the state in turn, with every hostile value.
void try_fields(const Exercise& source, int step) {
    const ForgedState state(source);
    run::Session session = session_for(state);
    ASSERT_GT(state.fields(), 100);
    ASSERT_EQ(state.checkpoint({}), state.honest());
    ASSERT_EQ(try_state(session, state.honest()).outcome, Outcome::ran_on);
    std::array<int, 3> outcomes{};
    for (int field = 0; field < state.fields(); field += step) {
        for (const Hostile& hostile : kHostile) {
            const Changes changes{{.field = field, .hostile = hostile}};
            SCOPED_TRACE(state.words(changes));
            Tried tried;
            EXPECT_NO_THROW(tried = try_state(session, state.checkpoint(changes)));
            ++outcomes[static_cast<std::size_t>(tried.outcome)];
            if (tried.outcome != Outcome::refused) continue;
            const std::string& name = state.names()[static_cast<std::size_t>(field)];
            const bool lengths = tried.refusal.find("a checkpoint ") != std::string::npos;
            EXPECT_TRUE(tried.refusal.find(name.substr(name.rfind('.') + 1)) != std::string::npos || lengths)
                << tried.refusal;
        }
    }
    watch(false);
    const auto& [refused, stopped, ran_on] = outcomes;
    EXPECT_GT(refused, 0);
    EXPECT_GT(ran_on, 0);
    std::printf("%d fields: %d states refused, %d ran on, %d were stopped by a fault\n",
                (state.fields() + step - 1) / step, refused, ran_on, stopped);
}

/// Anchor and cable run out; a fault is armed, a report waits to be called.
Drill running() {
    Drill drill(let_go_def());
    drill.fault(FaultCode::brake_lining_faded, 0.2, FaultTrigger::at_cable_out, 1000);
    drill.brake(0);
    drill.run(4);
    drill.exercise().apply(ReportMade{.code = ReportCode::let_go, .side = 0, .value = 0, .text = ""});
    return drill;
}

/// More wind than the anchor holds.
Drill dragging() {
    ExerciseDef def = let_go_def();
    def.tackle[0].anchor.holding_sand = 1;
    Drill drill(def);
    drill.wind(20);
    EXPECT_TRUE(let_go_and_pay_out(drill, 3));
    EXPECT_TRUE(drill.run_until_event("anchor.dragging", 900));
    return drill;
}

/// The cable has parted at a link that the instructor weakened: run out for a while, and snubbed by the
/// emergency stop's spring.
Drill parted() {
    Drill drill(quiet_def(100, 15));
    drill.run(1);
    drill.fault(FaultCode::chain_link_weak, 0.93);
    drill.brake(0);
    drill.run(5);
    drill.emergency_stop(true);
    EXPECT_TRUE(drill.run_until_event("cable.parted", 60));
    return drill;
}

/// Brought up to where the chain lies, some of it asleep, the rest left to the catenary.
Drill lying() {
    Drill drill(steady_breeze_def());
    EXPECT_TRUE(lie_quietly(drill));
    return drill;
}

/// Hangs from the hawse, held by the brake.
Drill hanging() {
    Drill drill(quiet_def(100, 15));
    drill.run(2);
    return drill;
}

using Moment = Drill (*)();
struct State {
    const char* name;
    Moment moment;
};
class HostileState : public testing::TestWithParam<State> {};
class EveryHostileState : public testing::TestWithParam<State> {};
constexpr std::array kStates{State{"Hanging", hanging}, State{"Running", running},
                             State{"Dragging", dragging}, State{"Parted", parted}, State{"Lying", lying}};
const auto name_of = [](const auto& param) { return param.param.name; };

// One of some dozen fields each, so that all come up in one of the states; the long ones try every field.
TEST_P(HostileState, InOneFieldHarmsNobody) {
    constexpr int kSome = 13;
    const Drill drill = GetParam().moment();
    try_fields(drill.exercise(), kSome);
}
TEST_P(EveryHostileState, InOneFieldHarmsNobody) {
    const Drill drill = GetParam().moment();
    try_fields(drill.exercise(), 1);
}

TEST_P(HostileState, InSeveralFieldsHarmsNobody) {
    const Drill drill = GetParam().moment();
    try_seeds(drill.exercise(), drawn, 0, 600);
}
TEST_P(HostileState, NudgedHarmsNobody) {
    const Drill drill = GetParam().moment();
    try_seeds(drill.exercise(), nudged, 0, 400);
}
TEST_P(EveryHostileState, InSeveralFieldsHarmsNobody) {
    const Drill drill = GetParam().moment();
    try_seeds(drill.exercise(), drawn, 800, 20'000);
}
TEST_P(EveryHostileState, NudgedHarmsNobody) {
    const Drill drill = GetParam().moment();
    try_seeds(drill.exercise(), nudged, 400, 20'000);
}

/// Cable of links of 0.1 m comes to the ground, in as many substeps as a file may ask for: what a tick has no
/// time for is taken in one step, and the state stays finite.
TEST(HostileStateOnce, WorkOfATickIsBounded) {
    constexpr int kLinks = 1780,
                  kIterations = 36; // of a step, at most; and a link touches ground and two others
    ExerciseDef def = quiet_def(180, kLinks / 10);
    def.model.adaptive = false;
    def.max_substeps = 64;
    def.tackle[0].chain.node_spacing = 0.1;
    grip_in_proportion(def.tackle[0].windlass); // by a man's five turns the fall begins too softly
    Drill drill(def);
    drill.brake(0);
    std::int64_t most = 0;
    for (int tick = 0; tick < 900; ++tick) {
        ASSERT_TRUE(drill.tick());
        most = std::max(most, drill.exercise().visits());
    }
    EXPECT_GT(most, kMaxTickVisits);
    EXPECT_LE(most, kMaxTickVisits + kIterations * 3 * kLinks); // and one step
}

/// What ended the whole server once, or made every tick of it long: refused now, each by the field that it
/// names first.
TEST(HostileStateOnce, HarmfulIsRefused) {
    using Fields = std::vector<std::pair<const char*, Hostile>>;
    const std::string point = "port.tackle.anchor.body.p.";
    const std::string flags = point + "m_contactPointFlags", friction = point + "m_combinedRollingFriction";
    const std::string at = "port.tackle.anchor.body.m_localPointA";
    const std::vector<Fields> cases{
        {{flags.c_str(), {0, -1}}, {friction.c_str(), {1e4, 0}}},
        {{at.c_str(), {1e300, 0}}, {flags.c_str(), {0, -1}}},
        {{at.c_str(), {-1e8, 0}}},
        {{"ship.floats.heave_speed", {1e10, 0}},
         {"port.tackle.windlass.state.gypsy.behind", {1, 0}},
         {"port.tackle.anchor.holding.bent", {1, 0}}},
        {{"port.tackle.windlass.loads.jam", {std::nan(""), 0}}, {"weather.now.wind_from", {-1, 0}}},
        {{"weather.now.gust_period", {-9e18, 0}}, {"weather.now.wind_from", {-1, 0}}},
        {{"ship.x", {1e10, 0}}, {"port.from.surge", {-9e18, 0}}},
        {{"port.tackle.anchor.body.at.position", {1e10, 0}}},
        {{"port.tackle.windlass.state.cable_speed", {-1e10, 0}}},
        {{"pull.force", {-9e18, 0}}},
        {{"port.tackle.anchor.body.points", {1e300, 1 << 20}}, {flags.c_str(), {0, -1}}},
        {{"port.tackle.anchor.body.manifolds", {1e4, -1}}, {flags.c_str(), {0, -1}}},
        // These did not end the server: the exercise was stopped as a fault in its first tick.
        {{"ship.heading", {-0.7, 0}}},
        {{"ship.floats.heave", {50, 0}}},
        {{"port.from.waves.heave", {-30, 0}}},
        {{"foreign_ship.has", {1, 1}}}};
    const Drill drill = lying();
    const ForgedState state(drill.exercise());
    run::Session session = session_for(state);
    for (const Fields& fields : cases) {
        Changes changes;
        for (const auto& [name, hostile] : fields)
            changes.push_back({.field = state.field(name), .hostile = hostile});
        SCOPED_TRACE(state.words(changes));
        EXPECT_EQ(try_state(session, state.checkpoint(changes)).outcome, Outcome::refused);
    }
    watch(false);
}

INSTANTIATE_TEST_SUITE_P(Of, HostileState, testing::ValuesIn(kStates), name_of);
INSTANTIATE_TEST_SUITE_P(Of, EveryHostileState, testing::ValuesIn(kStates), name_of);

} // namespace
} // namespace windlass
