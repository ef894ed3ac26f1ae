// A running windlass_server and its clients, over DDS.

#include "idl/wire.hpp"
#include "rigs/server_process.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>

namespace windlass::test {
using namespace rigs;

namespace {

namespace topics = wire::topics;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Hears what a server says, and gives it orders.
class Client {
public:
    explicit Client(const std::string& exercise, const std::string& name = "trainee-1", int strength = 10)
        : name_(name),
          participant_({own_domain(), wire::exercise_partition(exercise), name}),
          status_(participant_, topics::exercise_status,
                  [this](const ExerciseStatus& s) { keep(last_status_, s); }),
          truth_(participant_, topics::exercise_truth,
                 [this](const ExerciseTruth& s) { keep(last_truth_, s); }),
          load_(participant_, topics::windlass_load, [this](const WindlassLoad& s) { keep(last_load_, s); }),
          taken_(participant_, topics::order_taken,
                 [this](const OrderTaken& s) {
                     const std::lock_guard lock(mutex_);
                     if (s.kind() == ORDER_TAKEN_WINDLASS)
                         speeds_taken_.push_back(s.windlass().speed_lever());
                 }),
          chain_(participant_, topics::chain_state, [this](const ChainState& s) { keep(last_chain_, s); }),
          event_(participant_, topics::event,
                 [this](const Event& s) {
                     const std::lock_guard lock(mutex_);
                     events_.push_back(s);
                 }),
          levers_(participant_, topics::windlass_command, strength),
          orders_(participant_, topics::exercise_command),
          faults_(participant_, topics::fault_command) {}

    bool is_joined() const {
        return levers_.matched() == 1 && orders_.matched() == 1 && faults_.matched() == 1 &&
               status().tick() > 0 && load().tick() > 0;
    }
    bool joined() const {
        return eventually([&] { return is_joined(); });
    }

    ExerciseStatus status() const { return copy(last_status_); }
    ExerciseTruth truth() const { return copy(last_truth_); }
    WindlassLoad load() const { return copy(last_load_); }
    ChainState chain() const { return copy(last_chain_); }

    bool has_event(const std::string& code, const std::string& text = "") const {
        const std::lock_guard lock(mutex_);
        for (const auto& event : events_) {
            if (event.code() == code && event.text().to_string().find(text) != std::string::npos) return true;
        }
        return false;
    }

    int events(const std::string& code) const {
        const std::lock_guard lock(mutex_);
        return static_cast<int>(
            std::count_if(events_.begin(), events_.end(), [&](const Event& e) { return e.code() == code; }));
    }

    /// The exercise has taken an order for this speed lever, whoever gave it and however soon it changed.
    bool has_taken(double speed) const {
        const std::lock_guard lock(mutex_);
        return std::count(speeds_taken_.begin(), speeds_taken_.end(), speed) > 0;
    }

    /// Levers of the port windlass. A serial of 0 stands for the next one.
    void levers(double brake, double speed, std::uint64_t serial = 0) {
        WindlassCommand command;
        command.side(SIDE_PORT);
        command.brake(brake);
        command.speed_lever(speed);
        sign(command, serial);
        EXPECT_TRUE(levers_.write(command));
    }

    void order(ExerciseAction action, double time_scale = 1) {
        ExerciseCommand command;
        command.action(action);
        command.time_scale(time_scale);
        sign(command);
        EXPECT_TRUE(orders_.write(command));
    }

    void fault(FaultCode code) {
        FaultCommand command;
        command.code(code);
        command.severity(1);
        sign(command);
        EXPECT_TRUE(faults_.write(command));
    }

    /// Holds the levers, as a client does, until the condition is met.
    bool hold(double brake, double speed, const std::function<bool()>& until) {
        return eventually([&] {
            levers(brake, speed);
            return until();
        });
    }

private:
    template <class T>
    void keep(T& last, const T& sample) {
        const std::lock_guard lock(mutex_);
        last = sample;
    }
    template <class T>
    T copy(const T& last) const {
        const std::lock_guard lock(mutex_);
        return last;
    }
    template <class T>
    void sign(T& command, std::uint64_t serial = 0) {
        command.origin().source(name_);
        command.origin().serial(serial != 0 ? serial : ++serial_);
    }

    mutable std::mutex mutex_;
    ExerciseStatus last_status_;
    ExerciseTruth last_truth_;
    WindlassLoad last_load_;
    ChainState last_chain_;
    std::vector<Event> events_;
    std::vector<double> speeds_taken_;
    std::string name_;
    std::uint64_t serial_ = 0;
    wire::Participant participant_;
    wire::Reader<ExerciseStatus> status_;
    wire::Reader<ExerciseTruth> truth_;
    wire::Reader<WindlassLoad> load_;
    wire::Reader<OrderTaken> taken_;
    wire::Reader<ChainState> chain_;
    wire::Reader<Event> event_;
    wire::Writer<WindlassCommand> levers_;
    wire::Writer<ExerciseCommand> orders_;
    wire::Writer<FaultCommand> faults_;
};

ServerProcess server(const std::string& partition, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--domain", std::to_string(own_domain()), "--partition", partition});
    return ServerProcess(std::move(more));
}

TEST(ServerWire, StatusStreamsAndLogArrive) {
    auto running = server("a");
    Client client("a");
    ASSERT_TRUE(client.joined()) << running.text();
    EXPECT_EQ(client.status().state(), RUN_RUNNING);
    EXPECT_EQ(client.status().exercise().to_string(), "let-go-port-25m");
    // Told before the client was there; each topic is found for itself, and the log may be last.
    EXPECT_TRUE(eventually([&] { return client.has_event("exercise.started"); }));
    EXPECT_TRUE(eventually([&] { return client.chain().nodes().size() >= 2; }));
    const auto tick = client.load().tick();
    EXPECT_TRUE(eventually([&] { return client.load().tick() > tick; }));
}

TEST(ServerWire, CommandMovesTheBrakeAsFarAsToldAndNoFurther) {
    auto running = server("a", {"--time-scale", "5"});
    Client client("a");
    ASSERT_TRUE(client.joined()) << running.text();
    ASSERT_TRUE(client.hold(1, 0, [&] { return client.load().brake_position() > 0.999; }));
    EXPECT_TRUE(client.hold(0.8, 0, [&] { return std::abs(client.load().brake_position() - 0.8) < 1e-6; }));
}

TEST(ServerWire, BadValuesAreRefusedWithAnEventAndChangeNothing) {
    auto running = server("a");
    Client client("a");
    ASSERT_TRUE(client.joined()) << running.text();
    ASSERT_TRUE(client.hold(1, 0.25, [&] { return client.load().speed_lever() == 0.25; }));
    const auto refused = client.truth().commands_refused();

    client.levers(kNan, 0.9);
    client.levers(1e30, 0.9);
    client.levers(-1, 0.9);
    client.levers(1, 1e30);
    client.order(EXERCISE_TIME_SCALE, -3);
    for (const char* text :
         {"brake = nan refused; allowed: 0..1", "brake = 1e+30 refused", "brake = -1 refused",
          "speed_lever = 1e+30 refused", "time_scale = -3 refused"}) {
        // Held on meanwhile: levers that nobody holds would spring to zero.
        EXPECT_TRUE(client.hold(1, 0.25, [&] { return client.has_event("command.refused", text); })) << text;
    }
    EXPECT_TRUE(client.hold(1, 0.25, [&] { return client.truth().commands_refused() == refused + 5; }));
    EXPECT_TRUE(client.truth().faults().empty());
    EXPECT_EQ(client.status().time_scale(), 1);
    EXPECT_TRUE(client.hold(1, 0.5, [&] { return client.has_taken(0.5); })); // it still takes orders
    EXPECT_FALSE(client.has_taken(0.9) || client.has_taken(1e30));
}

TEST(ServerWire, StaleSerialIsRefusedAndChangesNothing) {
    auto running = server("a");
    Client client("a");
    ASSERT_TRUE(client.joined()) << running.text();
    client.levers(1, 0.25, 1000000);
    ASSERT_TRUE(eventually([&] { return client.has_taken(0.25); }));
    client.levers(1, 0.9, 1000000);
    client.levers(1, 0.9, 999999);
    EXPECT_TRUE(
        eventually([&] { return client.has_event("command.refused", "origin.serial = 999999 refused"); }));
    EXPECT_TRUE(client.has_event("command.refused", "origin.serial = 1000000 refused"));
    client.levers(1, 0.5, 1000001);
    EXPECT_TRUE(eventually([&] { return client.has_taken(0.5); }));
    EXPECT_FALSE(client.has_taken(0.9));
}

TEST(ServerWire, InstructorTakesTheLeversOverAndTheyFallBackWhenHeLetsGo) {
    auto running = server("a");
    Client trainee("a", "trainee-1", 10);
    ASSERT_TRUE(trainee.joined()) << running.text();
    ASSERT_TRUE(trainee.hold(1, 0.25, [&] { return trainee.load().speed_lever() == 0.25; }));
    Client instructor("a", "instructor", 20);
    ASSERT_TRUE(instructor.joined());
    ASSERT_TRUE(instructor.hold(1, 0.75, [&] {
        return trainee.load().speed_lever() == 0.75 &&
               trainee.has_event("levers.taken", "instructor has the port windlass");
    }));
    // While he holds them, the trainee does not get them back.
    EXPECT_TRUE(eventually([&] {
        const int before = trainee.events("levers.taken");
        for (int i = 0; i < 10; ++i) {
            instructor.levers(1, 0.75);
            trainee.levers(1, 0.25);
            pace(std::chrono::milliseconds(20));
        }
        return trainee.events("levers.taken") == before && trainee.load().speed_lever() == 0.75;
    }));
    // He falls silent without leaving.
    const int taken = trainee.events("levers.taken");
    EXPECT_TRUE(trainee.hold(1, 0.5, [&] {
        return trainee.load().speed_lever() == 0.5 && trainee.events("levers.taken") > taken;
    }));
}

TEST(ServerWire, TwoPartitionsDoNotMix) {
    auto first = server("one");
    auto second = server("two");
    Client one("one");
    Client two("two");
    ASSERT_TRUE(one.joined()) << first.text();
    ASSERT_TRUE(two.joined()) << second.text(); // each with one server only
    two.order(EXERCISE_PAUSE);
    ASSERT_TRUE(two.hold(1, 0.5, [&] { return two.status().state() == RUN_PAUSED; }));
    EXPECT_TRUE(one.hold(1, -0.5, [&] { return one.load().speed_lever() == -0.5; }));
    EXPECT_EQ(one.status().state(), RUN_RUNNING);
    EXPECT_FALSE(one.has_event("exercise.paused"));
}

TEST(ServerWire, TwoExercisesOfOneServerDoNotMix) {
    const auto domain = std::to_string(own_domain());
    const ServerProcess both({"--domain", domain, "--partition", "one", "--partition", "two"});
    Client one("one");
    Client two("two");
    ASSERT_TRUE(one.joined()) << both.text();
    ASSERT_TRUE(two.joined()) << both.text();
    two.order(EXERCISE_PAUSE);
    ASSERT_TRUE(two.hold(1, 0.5, [&] { return two.status().state() == RUN_PAUSED; }));
    EXPECT_TRUE(one.hold(1, -0.5, [&] { return one.load().speed_lever() == -0.5; }));
    EXPECT_EQ(one.status().state(), RUN_RUNNING);
    EXPECT_FALSE(one.has_event("exercise.paused"));
}

TEST(ServerWire, InstructorStartsPausesHurriesAndResets) {
    auto running = server("a", {"--wait"});
    Client client("a", "instructor", 20);
    ASSERT_TRUE(eventually([&] { return client.status().exercise().size() > 0; })) << running.text();
    EXPECT_EQ(client.status().state(), RUN_READY);
    EXPECT_EQ(client.status().tick(), 0U);
    client.order(EXERCISE_START);
    ASSERT_TRUE(
        eventually([&] { return client.status().state() == RUN_RUNNING && client.status().tick() > 0; }));
    client.order(EXERCISE_TIME_SCALE, 4);
    EXPECT_TRUE(eventually([&] { return client.status().time_scale() == 4; }));
    client.order(EXERCISE_PAUSE);
    EXPECT_TRUE(eventually([&] { return client.status().state() == RUN_PAUSED; }));
    client.order(EXERCISE_RESET);
    EXPECT_TRUE(
        eventually([&] { return client.status().state() == RUN_READY && client.status().tick() == 0; }));
    client.order(EXERCISE_STOP);
    EXPECT_TRUE(eventually([&] { return client.status().state() == RUN_FINISHED; }));
}

TEST(ServerWire, LastStatusSaysFinishedWhenTheServerIsStopped) {
    auto running = server("a");
    Client client("a");
    ASSERT_TRUE(client.joined()) << running.text();
    running.signal(SIGTERM);
    EXPECT_EQ(running.exit_code(), 0);
    EXPECT_TRUE(eventually([&] { return client.status().state() == RUN_FINISHED; }));
    EXPECT_TRUE(client.has_event("exercise.finished", "terminated"));
}

} // namespace
} // namespace windlass::test
