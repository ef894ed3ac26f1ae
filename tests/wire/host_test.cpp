// Many exercises in one process: each goes its own way, and falls alone.

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"
#include "server/assess/result.hpp"
#include "server/exercise/exercise.hpp"
#include "server/host/classroom.hpp"
#include "server/host/realtime.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/no_memory.hpp"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>

namespace windlass::host {
namespace {

using exercise::ExerciseDef;
using exercise::RunState;
using rigs::eventually;
using test::Folder;

constexpr double kSeconds = 12; // the anchor is on the bottom, with its cable coming after it

/// The brake left open: the cable runs out, and the anchor lands.
ExerciseDef let_go(double depth) {
    ExerciseDef def;
    def.environment.depth = depth;
    def.tackle.front().brake = 0;
    return def;
}

/// Wind beyond every number: no model stays finite in it.
ExerciseDef impossible() {
    ExerciseDef def;
    def.weather.wind_speed = std::numeric_limits<double>::infinity();
    return def;
}

class HostTest : public testing::Test {
protected:
    run::SessionOptions options(double time_scale = 0, double duration = kSeconds) const {
        run::SessionOptions options;
        options.time_scale = time_scale;
        options.duration = duration;
        options.fault_folder = folder_ / "";
        return options;
    }

    /// State hash at the last tick, heard on the wire as any client hears it.
    class Listener {
    public:
        Listener(const wire::Participant& member, const std::string& id)
            : participant_(member, wire::exercise_partition(id)),
              reader_(participant_, wire::topics::exercise_status,
                      [this](const ExerciseStatus& s) {
                          const std::lock_guard lock(mutex_);
                          last_ = s;
                      }),
              truth_reader_(participant_, wire::topics::exercise_truth, [this](const ExerciseTruth& s) {
                  const std::lock_guard lock(mutex_);
                  truth_ = s;
              }) {}
        ExerciseTruth truth() const {
            const std::lock_guard lock(mutex_);
            return truth_;
        }
        ExerciseStatus last() const {
            const std::lock_guard lock(mutex_);
            return last_;
        }

    private:
        mutable std::mutex mutex_;
        ExerciseStatus last_;
        ExerciseTruth truth_;
        wire::Participant participant_;
        wire::Reader<ExerciseStatus> reader_;
        wire::Reader<ExerciseTruth> truth_reader_;
    };

    /// An instructor of one exercise.
    class Client {
    public:
        Client(const wire::Participant& member, const std::string& id)
            : participant_(member, wire::exercise_partition(id)),
              orders_(participant_, wire::topics::exercise_command) {
            EXPECT_TRUE(eventually([&] { return orders_.matched() > 0; }));
        }
        void order(ExerciseAction action) {
            ExerciseCommand order;
            order.origin().source() = "instructor";
            order.origin().serial(++serial_);
            order.action(action);
            orders_.write(order);
        }

    private:
        std::uint64_t serial_ = 0;
        wire::Participant participant_;
        wire::Writer<ExerciseCommand> orders_;
    };

    static int occurrences(const std::string& text, const std::string& word) {
        int count = 0;
        for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
            ++count;
        return count;
    }

    std::ostringstream told_;
    const Folder folder_;
    const wire::Participant member_{{rigs::own_domain(), "exercise/none", "host-test"}};
};

/// What the exercise comes to with nobody beside it: no host, no thread, no wire.
std::uint64_t hash_alone(const ExerciseDef& def) {
    exercise::Exercise exercise(def);
    for (auto tick = std::llround(kSeconds * def.tick_rate_hz); tick > 0; --tick)
        exercise.step(1.0 / def.tick_rate_hz);
    exercise::Snapshot snapshot;
    exercise.view(snapshot);
    return snapshot.state_hash;
}

TEST_F(HostTest, ExerciseBesideSevenOthersComesToTheSameBitsAsAlone) {
    std::vector<std::unique_ptr<Listener>> listeners;
    HostThreads threads(2);
    Host host(member_, threads);
    for (int i = 0; i < 8; ++i) {
        listeners.push_back(std::make_unique<Listener>(member_, std::to_string(i)));
        host.open(std::to_string(i), let_go(i % 2 == 0 ? 25 : 30 + i), options());
    }
    ASSERT_TRUE(eventually([&] { return host.all_ended(); }, std::chrono::seconds(60)));
    for (int i = 0; i < 8; ++i) {
        const auto& listener = *listeners[static_cast<std::size_t>(i)];
        EXPECT_TRUE(eventually([&] { return listener.last().state() == RUN_FINISHED; }));
        EXPECT_EQ(listener.last().tick(), std::uint64_t(kSeconds * 300));
        EXPECT_EQ(listener.truth().state_hash(), hash_alone(let_go(i % 2 == 0 ? 25 : 30 + i))) << i;
    }
    EXPECT_NE(listeners[0]->truth().state_hash(), listeners[1]->truth().state_hash());
}

TEST_F(HostTest, PictureIsWantedOfTicksOnlyInWhichAStreamIsDueThatSomebodyHears) {
    wire::Participant server(member_, "exercise/heard");
    dds::PublishingPool pool(1);
    dds::Publisher publisher(server, pool);
    run::Session session({}, options(1, 0));
    publisher.prepare(1, 64);
    double now = 0;
    const auto wanted = [&](int ticks) {
        int pictures = 0;
        for (int k = 0; k < ticks; ++k) {
            now += session.dt();
            const bool wants = publisher.wants(session.now_tick() + 1, session.status(), now);
            pictures += wants ? 1 : 0;
            session.tick(wants);
            session.clear_news();
            if (session.seen()) publisher.offer(session.snapshot(), session.status(), now);
            if (wants) publisher.flush(std::chrono::milliseconds(50));
        }
        return pictures;
    };
    wanted(3);
    EXPECT_LE(wanted(300), 6); // status, truth and weather five times a second, for those who may come
    wire::Participant station({rigs::own_domain(), "exercise/heard", "station"});
    const wire::Reader<ForecastleView> reader(station, wire::topics::forecastle_view,
                                              [](const ForecastleView&) {});
    EXPECT_TRUE(eventually([&] { return wanted(300) >= 30; }));
}

TEST_F(HostTest, MarksReachASeatThatComesLateUntilTheyAreTakenBack) {
    wire::Participant server(member_, "exercise/marked");
    dds::PublishingPool pool(1);
    dds::Publisher publisher(server, pool);
    assess::Result marks;
    marks.tenths = 874;
    marks.criteria.push_back({.code = "held", .text = {}, .objective = {}, .reason = {}, .unit = {}});
    const auto told = [&](double score, std::size_t criteria) {
        wire::Participant seat({rigs::own_domain(), "exercise/marked", "seat"});
        std::mutex mutex;
        std::optional<Assessment> heard;
        const wire::Reader<Assessment> reader(seat, wire::topics::seat_assessment,
                                              [&](const Assessment& one) {
                                                  const std::lock_guard lock(mutex);
                                                  heard = one;
                                              });
        return eventually([&] {
            const std::lock_guard lock(mutex);
            return heard && std::abs(heard->score() - score) < 0.01 && heard->criteria().size() == criteria;
        });
    };
    publisher.take_marks_back(); // there are none: nothing is said
    publisher.tell_seats(marks);
    publisher.flush(std::chrono::milliseconds(50));
    EXPECT_TRUE(told(87.4, 1));
    publisher.take_marks_back();
    publisher.flush(std::chrono::milliseconds(50));
    EXPECT_TRUE(told(0, 0));
}

TEST_F(HostTest, AlertGoesToTheSeatOnWhosePanelItIsAndOneAboutTheSimulationToNone) {
    wire::Participant server(member_, "exercise/alerts");
    dds::PublishingPool pool(1);
    dds::Publisher publisher(server, pool);
    const auto raise = [&](const char* code, bool deck, bool bridge) {
        run::AlertView alert;
        alert.code = code;
        alert.deck_panel = deck;
        alert.bridge_panel = bridge;
        publisher.offer(alert);
    };
    raise("cable.runaway", true, false);
    raise("watch.circle", false, true);
    raise("model.in_doubt", false, false);
    publisher.flush(std::chrono::milliseconds(50));
    const auto told = [&](const wire::Topic<Alert>& topic) {
        wire::Participant late({rigs::own_domain(), "exercise/alerts", "late"});
        std::mutex mutex;
        std::string codes;
        const wire::Reader<Alert> reader(late, topic, [&](const Alert& alert) {
            const std::lock_guard lock(mutex);
            codes += alert.code().to_string() + " ";
        });
        EXPECT_TRUE(eventually([&] {
            const std::lock_guard lock(mutex);
            return !codes.empty();
        }));
        const std::lock_guard lock(mutex);
        return std::string(codes);
    };
    EXPECT_EQ(told(wire::topics::forecastle_alert), "cable.runaway ");
    EXPECT_EQ(told(wire::topics::alert), "watch.circle ");
    EXPECT_EQ(told(wire::topics::server_alert), "model.in_doubt ");
}

TEST_F(HostTest, EventGoesToTheSeatsThatNoticeItAndIsNumberedForEach) {
    wire::Participant server(member_, "exercise/events");
    dds::PublishingPool pool(1);
    dds::Publisher publisher(server, pool);
    const exercise::Snapshot seen{};
    for (const char* code : {"exercise.ready", "brake.hot", "motor.overload_trip", "watch.circle",
                             "briefing.forecastle", "fault.active", "order.given"}) {
        exercise::ExerciseEvent event;
        event.code = code;
        publisher.offer(event, seen, {});
    }
    publisher.flush(std::chrono::milliseconds(50));
    const auto told = [&](const wire::Topic<SeatEvent>& topic, std::size_t count) {
        wire::Participant late({rigs::own_domain(), "exercise/events", "late"});
        std::mutex mutex;
        std::vector<std::string> codes;
        const wire::Reader<SeatEvent> reader(late, topic, [&](const SeatEvent& event) {
            const std::lock_guard lock(mutex);
            codes.push_back(std::to_string(event.number()) + " " + event.code().to_string());
        });
        EXPECT_TRUE(eventually([&] {
            const std::lock_guard lock(mutex);
            return codes.size() >= count;
        }));
        const std::lock_guard lock(mutex);
        return std::vector<std::string>(codes);
    };
    EXPECT_EQ(told(wire::topics::forecastle_event, 4),
              (std::vector<std::string>{"1 exercise.ready", "2 brake.hot", "3 motor.trip", "4 order.given"}));
    EXPECT_EQ(told(wire::topics::bridge_event, 3),
              (std::vector<std::string>{"1 exercise.ready", "2 watch.circle", "3 order.given"}));
    EXPECT_EQ(told(wire::topics::forecastle_instruction, 1),
              (std::vector<std::string>{"1 briefing.forecastle"}));
}

TEST_F(HostTest, ExerciseThatFailsStopsAloneWithAlertAndDump) {
    std::atomic<int> alerts_of_good{0}, alerts_of_bad{0};
    wire::Participant good(member_, "exercise/good"), bad(member_, "exercise/bad");
    const wire::Reader<Alert> good_alerts(good, wire::topics::server_alert,
                                          [&](const Alert&) { ++alerts_of_good; });
    const wire::Reader<Alert> bad_alerts(bad, wire::topics::server_alert,
                                         [&](const Alert&) { ++alerts_of_bad; });
    HostThreads threads(2);
    Host host(member_, threads);
    host.open("good", let_go(25), options(1, 0));
    host.open("bad", impossible(), options(1, 0));
    const auto status = [&](const std::string& id) {
        for (const auto& one : host.status())
            if (one.id == id) return one;
        return HostedStatus{};
    };
    ASSERT_TRUE(eventually([&] { return status("bad").run.state == RunState::stopped_by_fault; }));
    EXPECT_NE(status("bad").failure.find("ceased to be finite"), std::string::npos) << status("bad").failure;
    EXPECT_TRUE(eventually([&] { return alerts_of_bad == 1; }));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "windlass-fault-bad-let-go-port-25m-0.json"));
    const auto tick = status("good").tick;
    EXPECT_TRUE(eventually([&] { return status("good").tick > tick + 300; }));
    EXPECT_EQ(status("good").run.state, RunState::running);
    EXPECT_EQ(status("good").failure, "");
    EXPECT_EQ(alerts_of_good, 0);
    EXPECT_TRUE(host.any_stopped_by_fault());
    EXPECT_TRUE(host.close("bad", "removed"));
    EXPECT_FALSE(host.any_stopped_by_fault());
}

TEST_F(HostTest, ClosedExerciseSaysSoAndItsNameIsFreeAgain) {
    const Listener listener(member_, "a");
    HostThreads threads(1);
    Host host(member_, threads);
    host.open("a", let_go(25), options(1, 0));
    ASSERT_TRUE(eventually([&] { return listener.last().state() == RUN_RUNNING; }));
    EXPECT_TRUE(host.close("a", "removed by the test"));
    EXPECT_TRUE(eventually([&] { return listener.last().state() == RUN_FINISHED; }));
    EXPECT_FALSE(host.close("a", "removed by the test"));
    host.open("a", let_go(25), options(1, 0));
    EXPECT_TRUE(eventually([&] { return listener.last().state() == RUN_RUNNING; }));
}

TEST_F(HostTest, ExceptionInsideStopsTheExerciseAndLeavesTheThread) {
    HostThreads threads(1);
    HostedExercise exercise(member_, threads, "a", let_go(25), options(0, 0));
    while (!exercise.stopped_by_fault() && exercise.status().time < 60) { // memory is asked for now and then
        test::out_of_memory = true;
        EXPECT_TRUE(exercise.run());
        std::this_thread::yield();
    }
    test::out_of_memory = false;
    EXPECT_TRUE(exercise.stopped_by_fault());
    EXPECT_TRUE(eventually([&] { return exercise.run() && exercise.status().failure == "std::bad_alloc"; }));
    exercise.finish("end of the test", true);
}

/// What is said of an exercise that throws whenever it is looked at, and when it is due again.
TEST_F(HostTest, ExceptionAgainAndAgainIsToldOnceAndTakesNoThread) {
    const auto told = std::make_shared<spdlog::sinks::ostream_sink_mt>(told_);
    spdlog::default_logger()->sinks().push_back(told);
    auto throwing = options(1, 0);
    throwing.check = [](const ExerciseDef&) { throw 1; }; // no std::exception, and no refusal
    HostThreads threads(1);
    HostedExercise exercise(member_, threads, "a", let_go(25), throwing);
    Client client(member_, "a");
    client.order(EXERCISE_RESTORE);
    ASSERT_TRUE(eventually([&] { return exercise.run() && exercise.stopped_by_fault(); }));
    EXPECT_GT(exercise.due(), std::chrono::steady_clock::now() - std::chrono::milliseconds(5));
    for (int i = 0; i < 5; ++i) {
        client.order(EXERCISE_RESTORE);
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
        while (std::chrono::steady_clock::now() < end)
            EXPECT_TRUE(exercise.run());
    }
    spdlog::default_logger()->sinks().pop_back();
    EXPECT_EQ(occurrences(told_.str(), "exercise.stopped_by_fault"), 1) << told_.str();
    EXPECT_EQ(exercise.status().failure, "an exception that does not say what it is");
    exercise.finish("end of the test", true);
}

TEST_F(HostTest, NameInUseIsRefusedAndWhatRunsGoesOn) {
    HostThreads threads(1);
    Host host(member_, threads);
    host.open("a", let_go(25), options(1, 0));
    EXPECT_THROW(host.open("a", let_go(25), options(1, 0)), std::invalid_argument);
    EXPECT_EQ(host.size(), 1U);
    const auto tick = host.status().front().tick;
    EXPECT_TRUE(eventually([&] { return host.status().front().tick > tick + 30; }));
    EXPECT_TRUE(eventually([&] { return host.status().front().load > 0; }));
}

/// By which a supervisor is told that a tick hangs: it lasts, and its worker says so by saying nothing.
TEST_F(HostTest, KnowsHowLongABeatLastsThatAThreadIsAt) {
    const wire::Participant member({rigs::own_domain(), "classroom", "host"});
    HostThreads threads(1);
    Host host(member, threads);
    EXPECT_EQ(host.longest_beat().count(), 0);
    host.open("at-work", let_go(25), options(0, 0)); // as fast as possible: a thread is nearly always at it
    EXPECT_TRUE(eventually([&] { return host.longest_beat().count() > 0; }));
    host.close("at-work", "enough");
    EXPECT_EQ(host.longest_beat().count(), 0);
}

TEST_F(HostTest, OfALoadThatLeavesNoRoomNoExerciseIsCreated) {
    wire::Participant member({rigs::own_domain(), wire::kClassroomPartition, "server"});
    HostThreads threads(1);
    Host host(member, threads);
    std::atomic<double> load = 0.76;
    const auto ready = [](const std::string&) {
        std::promise<ExerciseDef> def;
        def.set_value(let_go(25));
        return run::Reading{.def = def.get_future(), .in_hand = {}};
    };
    Classroom classroom(member, "bridge", host, 1,
                        {.load = ready, .parse = {}, .options = [&](bool) { return options(1, 0); }},
                        [&] { return load.load(); });
    wire::Participant instructor({rigs::own_domain(), wire::kClassroomPartition, "console"});
    std::mutex mutex;
    std::string told;
    const wire::Reader<Event> events(instructor, wire::topics::event, [&](const Event& event) {
        const std::lock_guard lock(mutex);
        told += event.text().to_string() + '\n';
    });
    wire::Writer<ClassroomCommand> orders(instructor, wire::topics::classroom_command);
    ClassroomCommand order;
    order.origin().source() = "console";
    order.action(CLASSROOM_CREATE);
    order.server() = "bridge";
    order.exercise() = "x";
    const auto create = [&](const char* id, std::uint64_t serial) {
        order.id() = id;
        order.origin().serial(serial);
        EXPECT_TRUE(eventually([&] { return orders.matched() > 0; }));
        EXPECT_TRUE(orders.write(order));
    };
    const auto hears = [&](const std::string& words) {
        return eventually([&] {
            classroom.serve();
            const std::lock_guard lock(mutex);
            return told.find(words) != std::string::npos;
        });
    };
    create("one", 1);
    EXPECT_TRUE(hears("its exercises take 0.76 of 1 threads' time, and none is created beyond 0.75")) << told;
    EXPECT_EQ(host.size(), 0U);
    load = 0.74;
    create("two", 2);
    EXPECT_TRUE(hears("exercise two (let-go-port-25m) created by console")) << told;
    EXPECT_EQ(host.size(), 1U);
}

// Prints what becomes of an exercise in real time beside two that are hurried and cost more than there is:
// docs/failures.md.
TEST_F(HostTest, DISABLED_PrintCalmBesideHurried) {
    ExerciseDef fine = let_go(25);
    fine.model.adaptive = false;
    fine.tick_rate_hz = 1000;
    fine.tackle.front().chain.node_spacing = 0.2;
    const wire::Participant member({rigs::own_domain(), "classroom", "host"});
    HostThreads threads(2);
    Host host(member, threads);
    host.open("calm", let_go(25), options(1, 0));
    for (const char* id : {"hurried-1", "hurried-2"})
        host.open(id, fine, options(20, 0));
    std::this_thread::sleep_for(std::chrono::seconds(15));
    for (const HostedStatus& each : host.status())
        std::printf(
            "%-10s %5.2f of real time, its ticks %5.1f %% of a core, the latest end of one %5.1f ms\n",
            each.id.c_str(), each.run.time_scale_achieved, 100 * each.load, 1e3 * each.worst_lateness);
}

// Prints what 63 exercises in real time feel of one that throws at each order, or is hurried, in one process
// of two threads, by turns with rounds in which nothing happens: docs/failures.md.
TEST_F(HostTest, DISABLED_PrintNeighboursOfOne) {
    for (const std::string& refused : enter_realtime())
        std::printf("not as under --realtime: %s\n", refused.c_str());
    const wire::Participant member({rigs::own_domain(), "classroom", "host"});
    HostThreads threads(2);
    Host host(member, threads);
    for (int k = 1; k < 64; ++k)
        host.open("e" + std::to_string(k), ExerciseDef(), options(1, 0));
    auto throwing = options(1, 0);
    throwing.check = [](const ExerciseDef&) { throw 1; };
    const auto open_one = [&] { host.open("one", ExerciseDef(), throwing); };
    open_one();
    std::map<std::string, std::vector<double>> late; // ms, the worst of each second of each exercise
    const auto phase = [&](const std::string& what, const std::function<void()>& ten_times_a_second) {
        for (int tenth = 0; tenth < 200; ++tenth) {
            ten_times_a_second();
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            if (tenth % 10 != 9 || tenth < 30) continue; // of what it was before, in the first seconds
            for (const HostedStatus& each : host.status())
                if (each.id != "one") late[what].push_back(1e3 * each.worst_lateness);
        }
    };
    for (int round = 0; round < 3; ++round) {
        phase("nothing happens", [] {});
        {
            Client client(member, "one");
            phase("one throws", [&] { client.order(EXERCISE_RESTORE); });
        }
        host.close("one", "it has thrown");
        host.open("one", ExerciseDef(), options(20, 0));
        phase("one at x20", [] {});
        host.close("one", "it was hurried");
        open_one();
    }
    for (auto& [what, all] : late) {
        std::ranges::sort(all);
        const auto part = [&](double share) {
            return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
        };
        std::printf("%-16s half %5.2f ms, 99 %% %6.2f ms, all %7.2f ms (%zu seconds of an exercise)\n",
                    what.c_str(), part(0.5), part(0.99), part(1), all.size());
    }
}

} // namespace
} // namespace windlass::host
