// Who has the levers, over real DDS: taken over, handed back, and lost by a client that stops, hangs or is
// killed. The commanding client is a process of its own. Judged is whose hand the server says has them, and
// where the lever is; on a loaded machine anybody may be silent for a second, and nobody have them for a
// moment.

#include "rigs/server_process.hpp"
#include "station/client.hpp"
#include "station/lever_sender.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace windlass::test {
using namespace rigs;

namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

constexpr double kTraineesLever = 0.25, kInstructorsLever = 0.5;

class Authority : public testing::Test {
protected:
    static std::vector<std::string> join(std::vector<std::string> command) {
        command.insert(command.end(), {"--domain", std::to_string(own_domain()), "--partition", "authority"});
        return command;
    }
    static wire::JoinOptions session(const std::string& name) {
        return {.domain = own_domain(), .partition = "exercise/authority", .name = name};
    }
    /// instructor_console holding the port windlass's speed lever where it tells who has it. It looks for the
    /// server for as long as the tests wait: on a busy machine its own 3 s may not do. timeout: s.
    static std::vector<std::string> instructor(std::vector<std::string> more = {},
                                               const char* timeout = "20") {
        std::vector<std::string> command{INSTRUCTOR_CONSOLE, "levers",  "--name",
                                         "instructor",       "--speed", std::to_string(kInstructorsLever),
                                         "--timeout",        timeout};
        command.insert(command.end(), more.begin(), more.end());
        return join(std::move(command));
    }

    void SetUp() override {
        ASSERT_TRUE(eventually([&] { return bool(onlooker_.picture().tackle[SIDE_PORT].load); }))
            << server_.text();
    }

    double speed_lever() const { return onlooker_.picture().tackle[SIDE_PORT].load->speed_lever(); }
    /// Seconds of wall time from now until the server's load topic shows the lever there; negative: never.
    double seconds_until(double lever) const {
        const auto start = station::Clock::now();
        const bool seen = onlooker_.wait(std::chrono::seconds(60), [&](const station::Picture& now) {
            return now.tackle[SIDE_PORT].load->speed_lever() == lever;
        });
        return seen ? std::chrono::duration<double>(station::Clock::now() - start).count() : -1;
    }
    int events(const std::string& code) const {
        const auto all = onlooker_.picture().events.kept;
        return static_cast<int>(
            std::count_if(all.begin(), all.end(), [&](const Event& e) { return e.code() == code.c_str(); }));
    }
    /// The port windlass comes, and by the server's log is, into that hand, which holds the lever there.
    bool comes_into_hand(const std::string& name, double lever) const {
        return onlooker_.wait(std::chrono::seconds(60), [&](const station::Picture& now) {
            return now.tackle[SIDE_PORT].load->speed_lever() == lever && hand(now) == name;
        });
    }
    /// Who has the port windlass, as the server told last; empty: nobody.
    static std::string hand(const station::Picture& picture) {
        const auto& events = picture.events.kept;
        for (auto event = events.rbegin(); event != events.rend(); ++event) {
            const std::string code = event->code().to_string(), text = event->text().to_string();
            if (code == "levers.lost") return "";
            if (code == "levers.taken") return text.substr(0, text.find(" has the port windlass"));
        }
        return "";
    }
    std::string last_event(const std::string& code) const {
        const auto all = onlooker_.picture().events.kept;
        const auto found =
            std::find_if(all.rbegin(), all.rend(), [&](const Event& e) { return e.code() == code.c_str(); });
        return found == all.rend() ? "" : found->text().to_string();
    }

    ServerProcess server_{join({})};
    station::Client onlooker_{session("onlooker"), station::Seat::instructor};
};

/// A trainee who holds the lever, in this process, or somebody stronger.
class HoldingTrainee {
public:
    explicit HoldingTrainee(const wire::JoinOptions& session, station::Seat seat = station::Seat::trainee,
                            int strength = station::LeverSender::kStrength)
        : client_(session, seat), levers_{client_, SIDE_PORT, strength} {
        levers_.move([](station::LeverSet& set) { set.windlass.speed_lever = kTraineesLever; });
    }

private:
    station::Client client_;
    station::LeverSender levers_;
};

TEST_F(Authority, InstructorTakesTheLeversOverAndHandsThemBack) {
    const HoldingTrainee trainee(session("trainee-1"));
    ASSERT_TRUE(comes_into_hand("trainee-1", kTraineesLever)) << server_.text();
    ChildProcess instructor(this->instructor({"--duration", "2"}));
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << instructor.text();
    EXPECT_EQ(instructor.exit_code(), 0) << instructor.text();
    EXPECT_THAT(instructor.text(), HasSubstr("instructor has the port windlass"));
    EXPECT_THAT(instructor.text(), HasSubstr("port windlass handed back"));
    EXPECT_TRUE(comes_into_hand("trainee-1", kTraineesLever)) << server_.text();
}

TEST_F(Authority, PersonHasTheLeversBesideAScriptAtOnceAndTheScriptAgainWhenHeLetsGo) {
    constexpr double kScriptsLever = 0.75;
    const auto file =
        std::filesystem::temp_directory_path() / ("authority-" + std::to_string(getpid()) + ".json");
    std::ofstream(file) << R"({"steps": [{"do": {"speed_lever": 0.75}}, {"when": {"time": 3600}}]})";
    const ChildProcess script(join({TRAINEE_CLIENT, "--name", "script", "--view", "line", "--script", file}));
    ASSERT_TRUE(comes_into_hand("script", kScriptsLever)) << script.text();
    {
        const HoldingTrainee trainee(session("trainee-1"));
        EXPECT_TRUE(comes_into_hand("trainee-1", kTraineesLever)) << server_.text();
    }
    EXPECT_TRUE(comes_into_hand("script", kScriptsLever)) << script.text();
    std::filesystem::remove(file);
}

TEST_F(Authority, NoStrengthHelpsATraineeAgainstAnInstructor) {
    ChildProcess instructor(this->instructor());
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << instructor.text();
    wire::Participant strong(session("strongman"));
    wire::Writer<WindlassCommand> writer(strong, wire::topics::windlass_command, 1 << 30);
    WindlassCommand command;
    command.side(SIDE_PORT);
    command.speed_lever(kTraineesLever);
    command.origin().source() = "strongman";
    for (int i = 1; i <= 20; ++i) {
        command.origin().serial(static_cast<std::uint64_t>(i));
        command.origin().sent_unix_ns(i);
        ASSERT_TRUE(writer.write(command));
        pace(milliseconds(50));
    }
    EXPECT_GT(writer.matched(), 0);
    // On a loaded machine the instructor may be silent for a second, and be preferred again at his next word.
    EXPECT_TRUE(comes_into_hand("instructor", kInstructorsLever));
    instructor.signal(SIGTERM);
    EXPECT_EQ(instructor.exit_code(), 0);
}

/// A station on a machine with other work: its words come each 0.8 s. Whether one of them took the machine
/// longer than a slow hand is given is told by the sender's own clock, and then tried again.
TEST_F(Authority, HandWhoseWordsComeLateKeepsTheLeversAtAnyTimeScale) {
    wire::Participant station(session("slow"));
    wire::Writer<WindlassCommand> hand(station, wire::topics::windlass_command, 10);
    wire::Writer<ExerciseCommand> orders(station, wire::topics::exercise_command);
    ASSERT_TRUE(
        eventually([&] { return hand.matched() >= 2 && orders.matched() > 0; })); // onlooker and server
    std::uint64_t serial = 0;
    const auto signed_by_us = [&](auto sample) {
        sample.origin().source() = "slow";
        sample.origin().serial(++serial);
        return sample;
    };
    WindlassCommand heaving;
    heaving.side(SIDE_PORT);
    heaving.speed_lever(kTraineesLever);
    for (const double scale : {1.0, 10.0}) {
        ExerciseCommand order;
        order.action(EXERCISE_TIME_SCALE);
        order.time_scale(scale);
        ASSERT_TRUE(orders.write(signed_by_us(order)));
        ASSERT_TRUE(eventually([&] { return onlooker_.picture().status->time_scale() == scale; }));
        EXPECT_TRUE(eventually(
            [&] {
                EXPECT_TRUE(eventually([&] { // in its hand, and known to be slow
                    hand.write(signed_by_us(heaving));
                    pace(milliseconds(50));
                    return speed_lever() == kTraineesLever;
                }));
                const int lost = events("levers.lost");
                double longest = 0;
                for (int word = 0; word < 6; ++word) {
                    const auto before = station::Clock::now();
                    pace(milliseconds(800));
                    hand.write(signed_by_us(heaving));
                    longest = std::max(longest,
                                       std::chrono::duration<double>(station::Clock::now() - before).count());
                }
                if (longest > 1) return false;
                EXPECT_EQ(events("levers.lost"), lost) << "at x" << scale << server_.text();
                return true;
            },
            std::chrono::seconds(120)))
            << "the sender itself never kept its time";
    }
}

TEST_F(Authority, PaceOfAnExerciseThatIsHurriedWaitsForAHandThatIsKilledUntilItIsGivenUp) {
    ChildProcess instructor(this->instructor());
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << instructor.text();
    wire::Participant station(session("boss"));
    wire::Writer<ExerciseCommand> orders(station, wire::topics::exercise_command);
    ASSERT_TRUE(eventually([&] { return orders.matched() > 0; }));
    ExerciseCommand order;
    order.action(EXERCISE_TIME_SCALE);
    order.time_scale(20);
    order.origin().source() = "boss";
    order.origin().serial(1);
    ASSERT_TRUE(orders.write(order));
    ASSERT_TRUE(eventually([&] { return onlooker_.picture().status->time_scale() == 20; }));
    const auto time = [&] { return onlooker_.picture().tackle[SIDE_PORT].load->time(); };
    instructor.signal(SIGKILL);
    ASSERT_EQ(instructor.exit_code(), -1);
    const double dead_from = time();
    ASSERT_TRUE(eventually([&] { return events("levers.lost") > 0; }));
    const auto kept = onlooker_.picture().events.kept;
    const auto lost = std::ranges::find(kept, std::string("levers.lost"),
                                        [](const Event& event) { return event.code().to_string(); });
    // 3 s hurried, at most 5.05 at the clock's pace (DDS may miss it a second before), and what we had not
    // heard yet; at x20 throughout it would be 84 to 104.
    EXPECT_LT(lost->time() - dead_from, 14) << server_.text();
}

TEST_F(Authority, InstructorHearsWhoHasTheLeversInsteadAndEndsWithCode1) {
    const HoldingTrainee examiner(session("examiner"), station::Seat::instructor, 30);
    ASSERT_TRUE(comes_into_hand("examiner", kTraineesLever)) << server_.text();
    ChildProcess instructor(this->instructor({"--duration", "2"}, "5"));
    EXPECT_EQ(instructor.exit_code(), 1) << instructor.text();
    EXPECT_THAT(instructor.text(), HasSubstr("examiner has the port windlass"));
}

TEST_F(Authority, InstructorFromWhomTheLeversAreTakenSaysByWhomAndEndsWithCode1) {
    ChildProcess instructor(this->instructor({"--duration", "60"}));
    // He himself has to have heard that he had them: the onlooker hears it first on a busy machine.
    ASSERT_TRUE(eventually([&] {
        return instructor.text().find("instructor has the port windlass") != std::string::npos;
    })) << instructor.text();
    const HoldingTrainee examiner(session("examiner"), station::Seat::instructor, 30);
    EXPECT_EQ(instructor.exit_code(), 1) << instructor.text();
    EXPECT_THAT(instructor.text(), HasSubstr("examiner has taken the port windlass"));
}

TEST_F(Authority, OfTwoInstructorsOnlyTheOneWhoHasTheLeversSaysSo) {
    const HoldingTrainee other(session("instructor-2"), station::Seat::instructor);
    ASSERT_TRUE(comes_into_hand("instructor-2", kTraineesLever)) << server_.text();
    ChildProcess instructor(this->instructor({"--duration", "4"}, "5"));
    const int code = instructor.exit_code(); // DDS gives the levers to either of two that are as strong
    const bool was_given = server_.text().find("instructor has the port windlass") != std::string::npos;
    if (code == 0) {
        EXPECT_TRUE(was_given) << instructor.text() << server_.text();
    } else {
        EXPECT_EQ(code, 1);
        EXPECT_THAT(instructor.text(), HasSubstr("instructor-2 has"));
    }
}

TEST_F(Authority, LeversOfAKilledClientFallToTheNext) {
    const HoldingTrainee trainee(session("trainee-1"));
    ASSERT_TRUE(comes_into_hand("trainee-1", kTraineesLever));
    ChildProcess instructor(this->instructor());
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << instructor.text();
    instructor.signal(SIGKILL);
    ASSERT_EQ(instructor.exit_code(), -1);
    EXPECT_TRUE(comes_into_hand("trainee-1", kTraineesLever)) << server_.text();
}

TEST_F(Authority, LeversOfAHangingClientFallToTheNextAndComeBackWhenItGoesOn) {
    const HoldingTrainee trainee(session("trainee-1"));
    ASSERT_TRUE(comes_into_hand("trainee-1", kTraineesLever));
    const ChildProcess instructor(this->instructor());
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << instructor.text();
    instructor.signal(SIGSTOP);
    EXPECT_TRUE(comes_into_hand("trainee-1", kTraineesLever)) << server_.text();
    instructor.signal(SIGCONT);
    EXPECT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << server_.text() << instructor.text();
}

// Nobody else is there: its writer is the one that was given up.
TEST_F(Authority, HandOfAClientThatWasHeldUpForLongHoldsItsLeversWhenItGoesOn) {
    const ChildProcess instructor(this->instructor());
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << instructor.text();
    instructor.signal(SIGSTOP);
    ASSERT_TRUE(eventually([&] { return events("levers.lost") == 1; })) << server_.text();
    instructor.signal(SIGCONT);
    ASSERT_TRUE(comes_into_hand("instructor", kInstructorsLever)) << server_.text();
    const auto time = [&] { return onlooker_.picture().tackle[SIDE_PORT].load->time(); };
    EXPECT_TRUE(eventually([&, from = time()] { return time() > from + 2; }));
    EXPECT_EQ(events("levers.taken"), 2) << server_.text();
    EXPECT_EQ(events("levers.lost"), 1);
}

TEST_F(Authority, WithNobodyLeftTheLeverSpringsToZeroAndTheBrakeStaysAsItIs) {
    ChildProcess instructor(this->instructor({"--brake", "0.75"}));
    ASSERT_GE(seconds_until(kInstructorsLever), 0) << instructor.text();
    const auto load = [&] { return *onlooker_.picture().tackle[SIDE_PORT].load; };
    ASSERT_TRUE(eventually([&] { return std::abs(load().brake_position() - 0.75) < 1e-6; }));
    const WindlassLoad before = load();
    instructor.signal(SIGKILL);
    ASSERT_GE(seconds_until(0), 0);
    EXPECT_TRUE(eventually([&] {
        return last_event("levers.lost") == "instructor is no longer heard and nobody has the port windlass: "
                                            "speed lever at zero; brake, clutch and stopper as they were";
    }));
    EXPECT_TRUE(eventually([&] {
        const auto alerts = onlooker_.picture().alerts;
        return alerts.size() == 1 && alerts[0].code() == "levers.unattended" &&
               alerts[0].condition() == ALERT_ACTIVE_UNACKNOWLEDGED;
    }));
    EXPECT_TRUE(eventually([&, from = load().time()] { return load().time() > from + 1; }));
    EXPECT_NEAR(load().brake_position(), 0.75, 1e-6); // where the hand-wheel was
    EXPECT_EQ(load().clutch(), before.clutch());
    EXPECT_EQ(load().stopper_closed(), before.stopper_closed());
    EXPECT_EQ(onlooker_.picture().status->state(), RUN_RUNNING);

    const HoldingTrainee trainee(session("trainee-1"));
    EXPECT_GE(seconds_until(kTraineesLever), 0);
    EXPECT_TRUE(eventually([&] {
        const auto alerts = onlooker_.picture().alerts;
        return alerts.size() == 1 && alerts[0].condition() == ALERT_RECTIFIED_UNACKNOWLEDGED;
    }));
}

// The server that is started anew knows nobody; the hand has lain on an open wheel since before.
TEST_F(Authority, HandThatLiesOnAnOpenWheelLetsGoNoAnchorOfAServerThatIsStartedAnew) {
    const auto load = [&] { return *onlooker_.picture().tackle[SIDE_PORT].load; };
    const auto run = [&] { return onlooker_.picture().status->run(); };
    const auto run_on = [&](double seconds) { // of exercise
        const double from = load().time();
        return eventually([&] { return load().time() > from + seconds; });
    };
    ASSERT_TRUE(eventually([&] { return bool(onlooker_.picture().status); }));
    const double on = load().brake_position();
    ASSERT_GT(on, 0.9);
    station::Client client(session("trainee-1"), station::Seat::trainee);
    station::LeverSender levers(client, SIDE_PORT);
    ASSERT_TRUE(client.meet_server(std::chrono::seconds(60)));
    levers.move([](station::LeverSet& set) { set.windlass.brake = 0; });
    ASSERT_TRUE(eventually([&] { return load().brake_position() == 0; })) << server_.text();

    const std::uint64_t before = run();
    server_.signal(SIGKILL);
    const ServerProcess anew(join({}));
    ASSERT_TRUE(eventually([&] { return run() != before && hand(onlooker_.picture()) == "trainee-1"; }))
        << anew.text();
    ASSERT_TRUE(run_on(3));
    EXPECT_EQ(load().brake_position(), on);

    levers.move([](station::LeverSet& set) { set.windlass.brake = 0.5; });
    EXPECT_TRUE(eventually([&] { return load().brake_position() == 0.5; })) << anew.text();
}

TEST_F(Authority, ClientThatWasKilledAndStartedAgainHasTheLeversAgain) {
    {
        const ChildProcess instructor(this->instructor());
        ASSERT_GE(seconds_until(kInstructorsLever), 0) << instructor.text();
    } // killed
    ASSERT_GE(seconds_until(0), 0);
    const ChildProcess again(this->instructor());
    EXPECT_GE(seconds_until(kInstructorsLever), 0) << again.text();
}

/// Timings for docs/command_authority.md; they decide nothing. Median and largest of so many losses.
TEST_F(Authority, DISABLED_PrintTimes) {
    constexpr int kTimes = 20;
    const auto print = [](const char* what, std::vector<double> times) {
        std::sort(times.begin(), times.end());
        std::printf("%-42s median %3.0f ms  largest %3.0f ms  of %zu\n", what, times[times.size() / 2] * 1e3,
                    times.back() * 1e3, times.size());
    };
    std::vector<double> takes, gives, kills, hangs, nobody;
    int unheld = 0; // losses in which nobody had the levers for a moment, though the next one spoke
    for (int i = 0; i < kTimes; ++i) {
        {
            ChildProcess alone(instructor());
            ASSERT_GE(seconds_until(kInstructorsLever), 0) << alone.text();
            alone.signal(SIGKILL);
            nobody.push_back(seconds_until(0));
        }
        const HoldingTrainee trainee(session("trainee-1"));
        ASSERT_GE(seconds_until(kTraineesLever), 0);
        {
            station::Client client{session("second"), station::Seat::instructor};
            auto levers = std::make_unique<station::LeverSender>(client, SIDE_PORT);
            ASSERT_TRUE(eventually([&] { return levers->matched() >= 4; })); // all of them know each other
            levers->move([](station::LeverSet& set) { set.windlass.speed_lever = kInstructorsLever; });
            takes.push_back(seconds_until(kInstructorsLever));
            pace(milliseconds(100));
            levers.reset();
            gives.push_back(seconds_until(kTraineesLever));
        }
        for (const int signal : {SIGKILL, SIGSTOP}) {
            ChildProcess instructor(this->instructor());
            ASSERT_GE(seconds_until(kInstructorsLever), 0) << instructor.text();
            pace(milliseconds(100 + 7 * i)); // anywhere between two of its words
            const int lost = events("levers.lost");
            instructor.signal(signal);
            (signal == SIGKILL ? kills : hangs).push_back(seconds_until(kTraineesLever));
            ASSERT_TRUE(comes_into_hand("trainee-1", kTraineesLever));
            unheld += events("levers.lost") - lost;
        }
    }
    print("instructor takes over", takes);
    print("instructor hands back", gives);
    print("killed, the trainee has them again", kills);
    print("hangs, the trainee has them again", hangs);
    print("killed and nobody left, lever at zero", nobody);
    std::printf("%d of %zu losses to the next left the levers in nobody's hand meanwhile\n", unheld,
                kills.size() + hangs.size());
}

} // namespace
} // namespace windlass::test
