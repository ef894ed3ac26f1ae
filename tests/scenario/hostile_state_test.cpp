// States that no exercise ever had, as a checkpoint from outside may bring: refused with the field that is
// wrong, or run on without harm to the server and the exercises beside.

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/run/session.hpp"

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <limits>

namespace windlass {
namespace {

using namespace exercise;
using physics::FieldName;

/// What is put in place of a field.
struct Hostile {
    double number = 0;
    std::int64_t integer = 0;
};

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

/// Writes a state as a checkpoint does, hash and all, but for one field, which it changes.
class Forger final : public physics::ConstStateVisitor {
public:
    Forger(int which, const Hostile& hostile) : which_(which), hostile_(hostile) {}

    void number(const FieldName& name, double value) override {
        double put = hit(name) ? hostile_.number : value;
        append(&put, sizeof put);
        hash_.number(name, put);
    }
    void integer(const FieldName& name, std::int64_t value) override {
        std::int64_t put = hit(name) ? hostile_.integer : value;
        append(&put, sizeof put);
        hash_.integer(name, put);
    }
    void numbers(const FieldName& name, const double* first, std::size_t count) override {
        std::vector<double> put(first, first + count);
        if (hit(name) && count > 0) put[count / 2] = hostile_.number; // one of the many stands for all
        append(put.data(), count * sizeof *first);
        hash_.numbers(name, put.data(), count);
    }
    void text(const FieldName& name, const std::string& value) override {
        std::string put = hit(name) ? "\x1b[2J" : value;
        const std::uint64_t size = put.size();
        append(&size, sizeof size);
        append(put.data(), put.size());
        hash_.text(name, put);
    }
    void enter(const FieldName& name) override { path_.push_back(name.text() + '.'); }
    void leave() override { path_.pop_back(); }

    int fields() const { return seen_; }
    const std::string& name() const { return name_; } ///< of the field that was changed
    std::vector<std::uint8_t> bytes() const {
        std::vector<std::uint8_t> all = bytes_;
        const std::uint64_t hash = hash_.value();
        const auto* from = reinterpret_cast<const std::uint8_t*>(&hash);
        all.insert(all.end(), from, from + sizeof hash);
        return all;
    }

private:
    bool hit(const FieldName& name) {
        if (seen_++ != which_) return false;
        for (const std::string& part : path_)
            name_ += part;
        name_ += name.text();
        return true;
    }
    void append(const void* from, std::size_t size) {
        const auto* first = static_cast<const std::uint8_t*>(from);
        bytes_.insert(bytes_.end(), first, first + size);
    }

    int which_, seen_ = 0;
    Hostile hostile_;
    StateHash hash_;
    std::vector<std::uint8_t> bytes_;
    std::vector<std::string> path_;
    std::string name_;
};

/// Says which state was at work when the program dies of it or does not come back.
std::array<char, 300> at_work{};
void die(int signal) {
    const char* why = signal == SIGPROF ? "HANGS: " : "CRASHES: ";
    (void)!write(STDERR_FILENO, why, std::strlen(why));
    (void)!write(STDERR_FILENO, at_work.data(), std::strlen(at_work.data()));
    (void)!write(STDERR_FILENO, "\n", 1);
    _exit(99);
}
void watch(const std::string& what) {
    constexpr int kPatience = 30; // s of processor time, of what takes some hundredths
    std::snprintf(at_work.data(), at_work.size(), "%s", what.c_str());
    std::signal(SIGPROF, die);
    std::signal(SIGSEGV, die);
    const itimerval limit{{}, {kPatience, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

struct Outcome {
    int refused = 0, stopped = 0, ran_on = 0;
};

/// Restores the state in a session, as RestoreCommand does, and runs it for some ticks.
void try_state(server::Session& session, const std::string& what, const std::string& field,
               std::vector<std::uint8_t> checkpoint, Outcome& outcome) {
    watch(what);
    const auto give = [&](server::OrderContent order) {
        server::Inbox inbox;
        inbox.orders.push_back({"instructor", std::move(order)});
        static double now = 0;
        session.take(inbox, now += 10); // wall time enough for every refusal to be told
    };
    session.clear_news();
    give(server::StateOrder{.from = "outside", .checkpoint = std::move(checkpoint)});
    for (const ExerciseEvent& event : session.events()) {
        if (event.code != "command.refused") continue;
        ++outcome.refused;
        const std::string last = field.substr(field.rfind('.') + 1);
        const bool lengths = event.text.find("a checkpoint ") != std::string::npos;
        EXPECT_TRUE(event.text.find(last) != std::string::npos || lengths) << what << ": " << event.text;
        return;
    }
    give(server::RunOrder()); // to start
    give(Order{WindlassOrder{.brake = 0.5}});
    for (int tick = 0; tick < 30; ++tick)
        session.tick(); // throws what a host would have to set the exercise aside for
    ++(session.running() ? outcome.ran_on : outcome.stopped);
}

/// Each step-th field of the state in turn, with every hostile value.
void try_fields(const Exercise& source, int step) {
    server::SessionOptions options;
    options.fault_folder = "/nowhere"; // no dumps
    server::Session session(source.def(), options);
    const auto honest = write_checkpoint(source);
    Forger copy(-1, {});
    source.visit_state(copy);
    const auto head = honest.size() - copy.bytes().size();
    ASSERT_TRUE(
        std::equal(honest.begin() + static_cast<std::ptrdiff_t>(head), honest.end(), copy.bytes().begin()));
    ASSERT_GT(copy.fields(), 100);
    Outcome outcome;
    try_state(session, "the state as it is", "", honest, outcome);
    ASSERT_EQ(outcome.ran_on, 1);
    for (int which = 0; which < copy.fields(); which += step) {
        for (const Hostile& hostile : kHostile) {
            Forger forger(which, hostile);
            source.visit_state(forger);
            auto bytes = forger.bytes();
            bytes.insert(bytes.begin(), honest.begin(), honest.begin() + static_cast<std::ptrdiff_t>(head));
            const std::string what = forger.name() + " = " + std::to_string(hostile.number) + " or " +
                                     std::to_string(hostile.integer);
            EXPECT_NO_THROW(try_state(session, what, forger.name(), std::move(bytes), outcome)) << what;
        }
    }
    watch("nothing");
    EXPECT_GT(outcome.refused, 0);
    EXPECT_GT(outcome.ran_on, 0);
    std::printf("%d fields: %d states refused, %d ran on, %d were stopped by a fault\n",
                (copy.fields() + step - 1) / step, outcome.refused, outcome.ran_on, outcome.stopped);
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

/// The cable has parted at a link that the instructor weakened.
Drill parted() {
    Drill drill(quiet_def(100, 15));
    drill.run(1);
    drill.fault(FaultCode::chain_link_weak, 0.93);
    drill.brake(0);
    drill.run(4);
    drill.brake(1);
    EXPECT_TRUE(drill.run_until_event("cable.parted", 60));
    return drill;
}

/// Brought up to where the chain lies, some of it asleep, the rest left to the catenary.
Drill lying() {
    Drill drill(steady_breeze_def());
    EXPECT_TRUE(lie_quietly(drill));
    return drill;
}

// One of some dozen fields each, so that all come up in one of the states; the long ones try every field.
constexpr int kSome = 13;

TEST(HostileState, OfARunningCableHarmsNobody) {
    Drill drill = running();
    try_fields(drill.exercise(), kSome);
}

TEST(HostileState, OfADraggingAnchorHarmsNobody) {
    Drill drill = dragging();
    try_fields(drill.exercise(), kSome);
}

TEST(HostileState, OfAPartedCableHarmsNobody) {
    Drill drill = parted();
    try_fields(drill.exercise(), kSome);
}

TEST(HostileState, OfALyingCableHarmsNobody) {
    Drill drill = lying();
    try_fields(drill.exercise(), kSome);
}

TEST(EveryHostileState, OfARunningCableHarmsNobody) {
    Drill drill = running();
    try_fields(drill.exercise(), 1);
}

TEST(EveryHostileState, OfADraggingAnchorHarmsNobody) {
    Drill drill = dragging();
    try_fields(drill.exercise(), 1);
}

TEST(EveryHostileState, OfAPartedCableHarmsNobody) {
    Drill drill = parted();
    try_fields(drill.exercise(), 1);
}

TEST(EveryHostileState, OfALyingCableHarmsNobody) {
    Drill drill = lying();
    try_fields(drill.exercise(), 1);
}

} // namespace
} // namespace windlass
