// The two clients over real DDS without a server: what they send, and how they end.

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"
#include "station/lever_sender.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <future>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;

wire::JoinOptions session(const std::string& name) {
    return {.domain = own_domain(), .partition = "exercise/clients", .name = name};
}

/// What a server would hear of the levers.
class Ear {
public:
    std::vector<WindlassCommand> heard() const {
        const std::scoped_lock lock{mutex_};
        return heard_;
    }
    int helm_heard() const {
        const std::scoped_lock lock{mutex_};
        return helm_heard_;
    }
    bool matched() const { return windlass_.matched() > 0 && helm_.matched() > 0; }
    int instructor_heard() const {
        const std::scoped_lock lock{mutex_};
        return instructor_heard_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<WindlassCommand> heard_;
    int helm_heard_ = 0, instructor_heard_ = 0;
    wire::Participant participant_{session("ear")};
    wire::Reader<WindlassCommand> windlass_{participant_, wire::topics::windlass_command,
                                            [this](const WindlassCommand& sample) {
                                                const std::scoped_lock lock{mutex_};
                                                heard_.push_back(sample);
                                            }};
    wire::Reader<HelmCommand> helm_{participant_, wire::topics::helm_command, [this](const HelmCommand&) {
                                        const std::scoped_lock lock{mutex_};
                                        ++helm_heard_;
                                    }};
    wire::Reader<WindlassCommand> instructor_{participant_, wire::topics::instructor_windlass_command,
                                              [this](const WindlassCommand&) {
                                                  const std::scoped_lock lock{mutex_};
                                                  ++instructor_heard_;
                                              }};
    wire::Reader<HelmCommand> instructor_helm_{participant_, wire::topics::instructor_helm_command,
                                               [](const HelmCommand&) {}};
};

TEST(LeverSender, SendNothingUntilTouchedAndThenAgainAndAgain) {
    const Ear ear;
    station::Client client{session("trainee"), station::Seat::trainee};
    station::LeverSender levers{client, SIDE_PORT};
    ASSERT_TRUE(
        eventually([&] { return ear.matched() && levers.matched() >= 2; })); // its own reader, the ear
    levers.move([](station::LeverSet& set) { set.helm.engine = 0.2; });
    ASSERT_TRUE(eventually([&] { return ear.helm_heard() >= 6; })); // as many turns of the sender
    EXPECT_TRUE(ear.heard().empty()) << "the windlass was not touched";

    levers.move([](station::LeverSet& set) { set.windlass.brake = 0.4; });
    ASSERT_TRUE(eventually([&] { return ear.heard().size() >= 5; }));
    const auto heard = ear.heard(); // the first that was sent among them
    for (std::size_t i = 0; i < heard.size(); ++i) {
        EXPECT_EQ(heard[i].brake(), 0.4);
        EXPECT_EQ(heard[i].origin().source(), "trainee");
        if (i > 0) {
            EXPECT_GT(heard[i].origin().serial(), heard[i - 1].origin().serial());
        }
    }
}

TEST(LeverSender, LastMoveArrivesThoughTheStationLeavesAtOnce) {
    const Ear ear;
    {
        station::Client client{session("trainee"), station::Seat::trainee};
        station::LeverSender levers{client, SIDE_STARBOARD};
        ASSERT_TRUE(
            eventually([&] { return ear.matched() && levers.matched() >= 2; })); // its own reader, the ear
        levers.move([](station::LeverSet& set) { set.windlass.stopper_closed = true; });
        levers.move([](station::LeverSet& set) { set.windlass.brake = 0.9; });
    }
    ASSERT_TRUE(eventually([&] { return !ear.heard().empty() && ear.heard().back().brake() == 0.9; }));
    EXPECT_EQ(ear.heard().back().side(), SIDE_STARBOARD);
    EXPECT_TRUE(ear.heard().back().stopper_closed());
}

TEST(LeverSender, AreKeptWithinTheirRange) {
    const Ear ear;
    station::Client client{session("trainee"), station::Seat::trainee};
    station::LeverSender levers{client, SIDE_PORT};
    ASSERT_TRUE(
        eventually([&] { return ear.matched() && levers.matched() >= 2; })); // its own reader, the ear
    levers.move([](station::LeverSet& set) {
        set.windlass.brake = -3;
        set.windlass.speed_lever = 7;
    });
    ASSERT_TRUE(eventually([&] { return !ear.heard().empty(); }));
    EXPECT_EQ(ear.heard().back().brake(), 0);
    EXPECT_EQ(ear.heard().back().speed_lever(), 1);
}

TEST(LeverSender, OfAnInstructorSendsOnTheInstructorsTopic) {
    const Ear ear;
    station::Client client{session("instructor"), station::Seat::instructor};
    station::LeverSender levers{client, SIDE_PORT};
    ASSERT_TRUE(eventually([&] { return levers.matched() >= 2; }));
    levers.move([](station::LeverSet& set) { set.windlass.brake = 0.4; });
    EXPECT_TRUE(eventually([&] { return ear.instructor_heard() > 0; }));
    EXPECT_TRUE(ear.heard().empty());
    EXPECT_TRUE(eventually([&] {
        const auto in_force = client.picture().tackle[SIDE_PORT].levers_in_force();
        return in_force && in_force->origin().source() == "instructor";
    }));
}

TEST(LeverSender, FindsASpeedLeverThatHasSprungBackAndNotWhereAHandThatIsGoneHadIt) {
    wire::Participant server{session("server")};
    wire::Writer<ForecastleView> forecastle{server, wire::topics::forecastle_view};
    wire::Writer<WindlassCommand> gone{server, wire::topics::windlass_command,
                                       station::LeverSender::kStrength};
    station::Client client{session("trainee"), station::Seat::trainee};
    const station::LeverSender levers{client, SIDE_PORT};
    ForecastleView view;
    view.brake_position(0.5);
    WindlassCommand heaving;
    heaving.brake(0.25), heaving.speed_lever(0.5);
    ASSERT_TRUE(eventually([&] { // a stream is best-effort
        forecastle.write(view), gone.write(heaving);
        const station::Picture now = client.picture();
        return now.tackle[SIDE_PORT].view && now.tackle[SIDE_PORT].levers;
    }));
    EXPECT_EQ(levers.get().windlass.speed_lever, 0);
    EXPECT_EQ(levers.get().windlass.brake, 0.25);
}

TEST(LeverSender, FindsTheHelmAsItIsOrderedWhateverTheShipDoesYet) {
    wire::Participant server{session("server")};
    wire::Writer<BridgeView> bridge{server, wire::topics::bridge_view};
    station::Client client{session("trainee"), station::Seat::trainee};
    const station::LeverSender levers{client, SIDE_PORT};
    BridgeView view;
    view.engine(0.1), view.engine_ordered(0.4);
    view.rudder_ordered(0.2), view.bow_thruster_ordered(-0.5), view.stern_thruster_ordered(0.5);
    ASSERT_TRUE(eventually([&] { // a stream is best-effort
        bridge.write(view);
        return bool(client.picture().bridge);
    }));
    EXPECT_EQ(
        levers.get().helm,
        (station::HelmLevers{.engine = 0.4, .rudder = 0.2, .bow_thruster = -0.5, .stern_thruster = 0.5}));
}

/// A server that publishes one truth and one view.
TEST(Client, HearsWhatItsSeatMayAndNothingElse) {
    wire::Participant server{session("server")};
    wire::Writer<ExerciseStatus> status{server, wire::topics::exercise_status};
    wire::Writer<ExerciseTruth> truth{server, wire::topics::exercise_truth};
    wire::Writer<Event> event{server, wire::topics::event};
    wire::Writer<SeatEvent> forecastle_event{server, wire::topics::forecastle_event};
    wire::Writer<SeatEvent> bridge_event{server, wire::topics::bridge_event};
    wire::Writer<ForecastleView> forecastle{server, wire::topics::forecastle_view};
    wire::Writer<BridgeView> bridge{server, wire::topics::bridge_view};
    using station::Seat;
    for (const Seat seat : {Seat::forecastle, Seat::conning, Seat::trainee, Seat::coach, Seat::instructor}) {
        station::Client client{session("looker"), seat};
        ASSERT_TRUE(eventually([&] { return client.server_present(); }));
        ASSERT_TRUE(eventually([&] { // streams are best-effort: again until all that is due has come
            status.write({}), truth.write({}), event.write({}), forecastle_event.write({});
            bridge_event.write({}), forecastle.write({}), bridge.write({});
            const station::Picture now = client.picture();
            return now.status && bool(now.truth) == has_truth(seat) &&
                   now.events.kept.empty() != has_truth(seat) &&
                   now.seat_events[0].kept.empty() != on_forecastle(seat) &&
                   now.seat_events[1].kept.empty() != on_bridge(seat) &&
                   bool(now.tackle[SIDE_PORT].view) == on_forecastle(seat) &&
                   bool(now.bridge) == on_bridge(seat);
        })) << int(seat);
    }
}

TEST(Client, SerialsGoOnAboveThoseOfAnEarlierClientOfTheSameName) {
    std::uint64_t last = 0;
    {
        station::Client first{session("trainee"), station::Seat::trainee};
        for (int i = 0; i < 20; ++i)
            last = first.next_origin().serial();
    }
    pace(std::chrono::milliseconds(30)); // a client's first serial is the clock's, one a millisecond
    station::Client second{session("trainee"), station::Seat::trainee};
    EXPECT_GT(second.next_origin().serial(), last);
}

const std::string trainee = TRAINEE_CLIENT;
const std::string console = INSTRUCTOR_CONSOLE;
std::string lonely() {
    return " --domain " + std::to_string(own_domain()) + " --partition lonely ";
}

/// A recorder and instructors' stations hear every order. That the server does not hear it yet is common on a
/// busy machine: its hundreds of readers are not all discovered at once.
TEST(Console, GivesItsOrderWhenTheServerHearsItAndNotWhenARecorderDoes) {
    wire::JoinOptions here = session("server");
    here.partition = "exercise/late";
    wire::Participant server{here};
    wire::Writer<ExerciseStatus> status{server, wire::topics::exercise_status};
    wire::Writer<ExerciseTruth> truth{server, wire::topics::exercise_truth};
    wire::Writer<EnvironmentState> environment{server, wire::topics::environment_state};
    here.name = "recorder";
    wire::Participant recorder{here};
    std::atomic<int> too_early = 0;
    wire::Reader<ExerciseCommand> looker{recorder, wire::topics::exercise_command,
                                         [&](const ExerciseCommand&) { ++too_early; }};
    std::atomic<bool> paused = false;
    const auto tell = [&] {
        ExerciseStatus sample;
        sample.state(paused ? RUN_PAUSED : RUN_RUNNING);
        status.write(sample), truth.write({}), environment.write({});
    };
    auto order = std::async(std::launch::async, [] {
        return run(console + " --domain " + std::to_string(own_domain()) +
                   " --partition late --timeout 20 pause");
    });
    ASSERT_TRUE(eventually([&] {
        tell();
        return looker.matched() > 0; // by the console's writer
    }));
    for (int i = 0; i < 30; ++i) { // it hears the server thirty times, and looks each 10 ms
        tell();
        EXPECT_TRUE(status.wait_acknowledged(std::chrono::seconds(20)));
        pace(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(too_early, 0);
    const wire::Reader<ExerciseCommand> orders{server, wire::topics::exercise_command,
                                               [&](const ExerciseCommand&) { paused = true; }};
    EXPECT_TRUE(eventually([&] {
        tell();
        return order.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
    }));
    EXPECT_TRUE(paused);
    const Ending ending = order.get();
    EXPECT_EQ(ending.code, 0) << ending.text;
}

/// A server with --duration ends with its exercises; its last word may come behind the news that it is gone.
TEST(Console, KnowsWhatAServerDidThatIsGoneBeforeItAnswers) {
    const std::vector<std::tuple<std::string, int, std::string>> orders{
        {"stop", 0, "finished"}, {"pause", 1, "the server ended before it answered"}};
    for (const auto& [order, code, said] : orders) {
        wire::JoinOptions here = session("server");
        here.partition = "exercise/gone";
        wire::Participant server{here};
        std::atomic<bool> ordered = false;
        std::optional<wire::Reader<ExerciseCommand>> orders_heard;
        orders_heard.emplace(server, wire::topics::exercise_command,
                             [&](const ExerciseCommand&) { ordered = true; });
        std::optional<wire::Writer<ExerciseStatus>> status;
        status.emplace(server, wire::topics::exercise_status);
        wire::Writer<ExerciseTruth> truth{server, wire::topics::exercise_truth};
        wire::Writer<EnvironmentState> environment{server, wire::topics::environment_state};
        auto ending = std::async(std::launch::async, [&order = order] {
            return run(console + " --domain " + std::to_string(own_domain()) +
                       " --partition gone --timeout 20 " + order);
        });
        ASSERT_TRUE(eventually([&] {
            ExerciseStatus sample;
            sample.state(RUN_RUNNING);
            status->write(sample), truth.write({}), environment.write({});
            return ordered.load();
        }));
        status.reset(), orders_heard.reset();
        const Ending told = ending.get();
        EXPECT_EQ(told.code, code) << told.text;
        EXPECT_THAT(told.text, HasSubstr(said));
    }
}

TEST(Programs, TellTheirExitCodesInHelp) {
    for (const auto& program : {trainee, console}) {
        const Ending ending = run(program + " --help");
        EXPECT_EQ(ending.code, 0);
        EXPECT_THAT(ending.text, HasSubstr("Exit codes: 0"));
    }
}

TEST(Programs, RefuseBadOptionsWithCode2AndSayWhy) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {trainee + " --brake 1", "--brake"},
        {trainee + " --domain 300", "0 to 232"},
        {trainee + " --side middle", "middle"},
        {trainee + " --partition 'a b'", "letters, digits"},
        {trainee + " --timeout -1", "--timeout"},
        {trainee + " --name ''", "1 to 32"},
        {console, "subcommand"},
        {console + " dance", "dance"},
        {console + " time-scale fast", "fast"},
        {console + " fault brake-gone", "brake-gone is no fault code"},
        {console + " fault brake-lining-faded --severity 2", "severity"},
        {console + " fault brake-lining-faded --at 5 --at-load 100", "excludes"},
        {console + " fault brake-lining-faded --clear --at 5", "excludes"},
        {console + " fault brake-lining-faded --at-event anchor.let_go --between 1 2", "excludes"},
        {console + " fault brake-lining-faded --at-event levers.taken", "anchor.let_go"},
        {console + " fault brake-lining-faded --at-order dance", "no order of the bridge"},
        {console + " fault brake-lining-faded --between 5", "--between"},
        {console + " environment", "--wind-speed"},
        {console + " environment --time-of-day 25:00", "HH:MM"},
        {console + " environment --wind-from 720", "-360"},
        {console + " environment --wind-speed 1e30", "0.000000 to 60.000000"},
        {console + " environment --current-speed -1", "0.000000 to 5.000000"},
        {console + " environment --current-profile 5", "DEPTH:SHARE"},
        {console + " order dance", "dance is no order"},
        {console + " order pay-out", "needs a number of shackles"},
        {console + " watch-circle --radius 5", "--radius"},
        {console + " alerts", "subcommand"},
        {trainee + " --coach --seat bridge", "excludes"},
        {console + " status --timeout 0", "--timeout"},
    };
    for (const auto& [command, reason] : bad) {
        const Ending ending = run(command);
        EXPECT_EQ(ending.code, 2) << command << "\n" << ending.text;
        EXPECT_THAT(ending.text, HasSubstr(reason)) << command;
    }
}

TEST(Programs, RefuseABadScriptWithCode3AndItsPlace) {
    const auto file = std::filesystem::temp_directory_path() / ("bad-" + std::to_string(getpid()) + ".json");
    std::ofstream{file} << R"({"steps": [{"do": {"brake": 7}}]})";
    const Ending ending = run(trainee + lonely() + "--script " + file.string());
    std::filesystem::remove(file);
    EXPECT_EQ(ending.code, 3);
    EXPECT_THAT(ending.text, HasSubstr(file.string() + ": /steps/0/do/brake: 7 is not allowed"));
    EXPECT_EQ(run(trainee + lonely() + "--script /nowhere.json").code, 3);
}

TEST(Programs, RefuseAScriptThatLooksAtTheTruthUnlessACoachPlaysIt) {
    const std::string script = "--connect 0.2 --script " WINDLASS_CONFIG_DIR "/scripts/walk_back_60m.json ";
    const Ending ending = run(trainee + lonely() + script);
    EXPECT_EQ(ending.code, 3);
    EXPECT_THAT(ending.text, HasSubstr("walk_back_60m.json: /steps/5/when/cable_out: this is the truth"));
    EXPECT_THAT(ending.text, HasSubstr("--coach"));
    EXPECT_EQ(run(trainee + lonely() + script + "--coach").code, 4); // taken; there is no server
}

TEST(Programs, RefuseAScriptThatTheirSeatCannotPlay) {
    const std::string scripts = " --connect 0.2 --script " WINDLASS_CONFIG_DIR "/scripts/";
    for (const auto& [played, place] : std::vector<std::pair<std::string, std::string>>{
             {"L27_good.json --seat ship", "/steps/0/order is not allowed at --seat ship: bridge"},
             {"L01_good.json --seat bridge", "report is not allowed at --seat bridge: forecastle or ship"},
             {"L27_good.json --seat forecastle", "is not allowed at --seat forecastle: bridge"},
             {"mate_port.json --seat bridge", "/mate is not allowed at --seat bridge: forecastle or ship"}}) {
        const Ending ending = run(trainee + lonely() + scripts + played);
        EXPECT_EQ(ending.code, 3) << played;
        EXPECT_THAT(ending.text, HasSubstr(place));
    }
    EXPECT_EQ(run(trainee + lonely() + scripts + "L27_good.json --seat bridge").code,
              4); // there is no server
}

TEST(Programs, EndWithCode4WhereNoServerIs) {
    Ending ending = run(trainee + lonely() + "--connect 0.5 --view line");
    EXPECT_EQ(ending.code, 4);
    EXPECT_THAT(ending.text, HasSubstr("no server heard on domain"));
    for (const char* command : {"status", "start", "fault brake-lining-faded", "watch", "snapshot"}) {
        ending = run(console + lonely() + "--timeout 0.3 " + command);
        EXPECT_EQ(ending.code, 4) << command;
        EXPECT_THAT(ending.text, HasSubstr("no server heard on domain"));
    }
    ending = run(console + lonely() + "--timeout 0.3 --json status");
    EXPECT_EQ(ending.code, 4);
    EXPECT_THAT(ending.text, HasSubstr(R"("ok":false)"));
}

} // namespace
} // namespace windlass::test
