// Trainee and instructor with the real server: what each command does, and a let-go from "stand by" to
// "brought up".

#include "idl/types.hpp"
#include "rigs/server_process.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string exercise_file = std::string{WINDLASS_CONFIG_DIR} + "/exercises/let_go_port_25m.json";
const std::string let_go_script = std::string{WINDLASS_CONFIG_DIR} + "/scripts/let_go_port_25m.json";

std::string session() {
    return " --domain " + std::to_string(own_domain()) + " --partition stations ";
}

std::vector<std::string> options(std::vector<std::string> more) {
    std::vector<std::string> all{"--exercise",  exercise_file, "--domain", std::to_string(own_domain()),
                                 "--partition", "stations"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

Ending console(const std::string& command) {
    return run(INSTRUCTOR_CONSOLE + session() + "--timeout 20 " + command);
}

Ending trainee(const std::string& more) {
    return run(TRAINEE_CLIENT + session() + "--connect 20 --json " + more);
}

json status() {
    return json::parse(console("status --json").output);
}

/// The last line that holds the summary of a script.
json summary(const Ending& ending) {
    std::istringstream lines{ending.output};
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("{") && json::parse(line).contains("summary"))
            return json::parse(line)["summary"];
    return {};
}

/// Into a pipe that nobody reads.
Ending into_closed_pipe(const std::string& command) {
    return run("bash -c '(sleep 0.5; exec " + command + ") | true; exit ${PIPESTATUS[0]}'");
}

class ScriptFile {
public:
    explicit ScriptFile(const std::string& text)
        : path_{std::filesystem::temp_directory_path() / ("stations-" + std::to_string(getpid()) + ".json")} {
        std::ofstream{path_} << text;
    }
    ~ScriptFile() { std::filesystem::remove(path_); }
    std::string option() const { return "--script " + path_.string() + " "; }

private:
    std::filesystem::path path_;
};

TEST(ClosedPipe, EndsNoProgramByASignal) {
    EXPECT_EQ(into_closed_pipe(std::string{INSTRUCTOR_CONSOLE} + " faults").code, 1);
    EXPECT_EQ(into_closed_pipe(std::string{TRAINEE_CLIENT} + " --help").code, 1);
    const ServerProcess server{options({})};
    const Ending watched = into_closed_pipe(INSTRUCTOR_CONSOLE + session() + "--timeout 20 --json watch");
    EXPECT_EQ(watched.code, 1) << watched.text;
    EXPECT_THAT(watched.text, HasSubstr("nobody reads the output"));
    const std::string log_unread = " --duration 1 --time-scale 0 2>&1 --partition unread --domain ";
    EXPECT_EQ(into_closed_pipe(WINDLASS_SERVER + log_unread + std::to_string(own_domain())).code, 0);
}

TEST(Console, OrdersAreCarriedOutAndSeenInTheStatus) {
    const ServerProcess server{options({"--wait"})};
    EXPECT_EQ(status().at("state"), "RUN_READY");
    EXPECT_EQ(console("start").code, 0);
    EXPECT_EQ(status().at("state"), "RUN_RUNNING");
    EXPECT_EQ(console("time-scale 4").code, 0);
    EXPECT_EQ(status().at("time_scale"), 4);
    EXPECT_EQ(console("pause").code, 0);
    EXPECT_EQ(status().at("state"), "RUN_PAUSED");
    EXPECT_EQ(console("environment --wind-speed 12.5").code, 0); // also while the exercise stands still
    EXPECT_EQ(status().at("environment").at("now").at("wind_speed"), 12.5);
    EXPECT_EQ(status().at("environment").at("now").at("current_speed"), 0.3);
    EXPECT_EQ(console("environment --wind-speed 20 --visibility 3000 --ramp 60").code, 0);
    EXPECT_EQ(status().at("environment").at("after").at("wind_speed"), 20);
    EXPECT_EQ(status().at("environment").at("after").at("visibility"), 3000);
    EXPECT_EQ(status().at("environment").at("now").at("wind_speed"), 12.5); // the exercise stands still
    EXPECT_EQ(console("reset").code, 0);
    EXPECT_EQ(status().at("tick"), 0);
    EXPECT_EQ(console("load let_go_port_25m.json").code, 0);
    EXPECT_EQ(console("start").code, 0);
    EXPECT_EQ(console("stop").code, 0);
    EXPECT_EQ(status().at("state"), "RUN_FINISHED");
}

TEST(Console, WaitsForAnExerciseThatBeginsAtAnchorAsLongAsTheServerIsAtWork) {
    const ServerProcess server{options({"--wait"})};
    Ending loaded;
    EXPECT_TRUE(eventually([&] { // on a busy machine three seconds may not do to hear of the server
        loaded = run(INSTRUCTOR_CONSOLE + session() + "--timeout 3 load at_anchor_25m.json");
        return loaded.code != 4;
    }));
    EXPECT_EQ(loaded.code, 0) << loaded.text << server.text();
    EXPECT_EQ(status().at("exercise"), "at-anchor-25m");
}

TEST(Trainee, ScriptThatIsGivenUpByTheClockSaysHowFastTheMachineRan) {
    const ServerProcess server{options({"--time-scale", "10"})};
    const ScriptFile script{R"({"steps": [{"when": {"after": 1e5}, "timeout": 1e6}]})"};
    const Ending ending = trainee("--timeout 3 " + script.option());
    EXPECT_EQ(ending.code, 1);
    EXPECT_THAT(ending.text, testing::ContainsRegex("gave up after 3 s of wall time: this machine runs at "
                                                    "x[0-9.]+ of the x10 asked[.] step 1 of 1"));
}

TEST(Console, GoesBackToACheckpointAndOnFromThere) {
    const ServerProcess server{options({"--time-scale", "10"})};
    ASSERT_TRUE(eventually([] { return status().at("time") > 12; }));
    EXPECT_EQ(console("snapshot").code, 0);   // the server's Checkpoint arrives
    EXPECT_EQ(console("restore 11").code, 0); // the one of 10 s is the last before
    EXPECT_EQ(status().at("state"), "RUN_PAUSED");
    EXPECT_EQ(status().at("tick"), 3000);
    EXPECT_EQ(console("start").code, 0);
    EXPECT_TRUE(eventually([] { return status().at("tick") > 3000; }));
    const Ending ending = console("restore -- -1");
    EXPECT_EQ(ending.code, 1);
    EXPECT_THAT(ending.text, HasSubstr("restore_time = -1 refused"));
}

TEST(Console, RefusedOrdersEndWithCode1AndTheServersReason) {
    const ServerProcess server{options({"--wait"})};
    const std::vector<std::pair<std::string, std::string>> refused{
        {"pause", "start it first"},
        {"time-scale 50", "0.1..20"},
        {"time-scale nan", "0.1..20"},
        {"load nothere.json", "nothere.json"},
        {"load ../../secret.json", "inside the server's exercise folder"},
        {"environment --wave-height 10 --wave-period 3", "wave_period"},
        {"fault brake-lining-faded --between 60 5", "trigger_until"},
        {"order let-go --side starboard --repeat-within 1e9", "repeat_within"},
        {"watch-circle --radius 2000 --x 1e30 --y 0", " x = "},
        {"fault brake-lining-faded --side starboard", "only cable"},
    };
    for (const auto& [command, reason] : refused) {
        const Ending ending = console(command);
        EXPECT_EQ(ending.code, 1) << command;
        EXPECT_THAT(ending.text, HasSubstr(reason)) << command;
    }
    EXPECT_EQ(status().at("state"), "RUN_READY");
    // The status that counts them comes five times a second.
    EXPECT_TRUE(eventually([&] { return status().at("commands_refused") == refused.size(); }));
}

TEST(Console, FaultsAreArmedRaisedAndCleared) {
    const ServerProcess server{options({"--wait"})};
    EXPECT_EQ(console("fault brake-lining-faded --severity 0.5 --at-cable-out 60").code, 0);
    json fault = status().at("faults").at(0);
    EXPECT_EQ(fault.at("code"), "FAULT_BRAKE_LINING_FADED");
    EXPECT_EQ(fault.at("phase"), "FAULT_PHASE_ARMED");
    EXPECT_EQ(fault.at("severity"), 0.5);
    EXPECT_EQ(fault.at("trigger"), "TRIGGER_AT_CABLE_OUT");
    EXPECT_EQ(fault.at("trigger_value"), 60);
    EXPECT_EQ(console("fault load-cell-dead --at-load 250").code, 0);
    EXPECT_EQ(status().at("faults").at(1).at("trigger_value"), 250000);
    EXPECT_EQ(console("fault brake-lining-faded").code, 0);
    EXPECT_EQ(status().at("faults").at(0).at("phase"), "FAULT_PHASE_ACTIVE");
    EXPECT_EQ(console("fault brake-lining-faded --clear").code, 0);
    EXPECT_EQ(status().at("faults").at(0).at("phase"), "FAULT_PHASE_CLEARED");
}

TEST(Console, FaultsWaitForMoreThanAMomentOrALength) {
    const ServerProcess server{options({"--wait"})};
    const auto armed = [](const std::string& how) {
        EXPECT_EQ(console("fault brake-lining-faded --ramp 5 " + how).code, 0) << how;
        return status().at("faults").at(0);
    };
    EXPECT_EQ(armed("--at-cable-out-at-most 30").at("trigger"), "TRIGGER_AT_CABLE_OUT_AT_MOST");
    EXPECT_EQ(armed("--at-load-at-most 50").at("trigger_value"), 50000);
    EXPECT_EQ(armed("--at-event anchor.on_bottom").at("trigger_event"), "anchor.on_bottom");
    EXPECT_EQ(armed("--at-order let-go").at("trigger_order"), static_cast<int>(BRIDGE_ORDER_LET_GO));
    const json chance = armed("--between 60 120");
    EXPECT_EQ(chance.at("trigger"), "TRIGGER_AT_CHANCE");
    EXPECT_EQ(chance.at("trigger_value"), 60);
    EXPECT_EQ(chance.at("trigger_until"), 120);
    EXPECT_EQ(chance.at("ramp"), 5);
}

TEST(Console, OrdersAreGivenRepeatedBackAndTakenBack) {
    const ServerProcess server{options({})};
    EXPECT_EQ(console("order hold-on 6 --side port").code, 0);
    const auto orders = [] { return json::parse(console("orders --json").output); };
    ASSERT_EQ(orders().size(), 1U);
    EXPECT_EQ(orders().at(0).at("state"), "ORDER_GIVEN");
    EXPECT_EQ(orders().at(0).at("value"), 6);
    const ScriptFile script{R"({"steps": [{"when": {"order": "hold_on"},
        "report": {"code": "order_repeated", "order": "hold_on", "side": "port", "value": 6}}]})"};
    EXPECT_EQ(trainee(script.option()).code, 0);
    EXPECT_TRUE(eventually([&] { return orders().at(0).at("state") == "ORDER_REPEATED"; }));
    EXPECT_EQ(console("order let-go").code, 0);
    EXPECT_EQ(console("order cancel 2").code, 0);
    EXPECT_EQ(orders().at(1).at("state"), "ORDER_CANCELLED");
}

TEST(Console, AlertsAreListedSilencedAndAcknowledged) {
    const ServerProcess server{options({})};
    EXPECT_EQ(console("levers --emergency-stop true --duration 2").code, 0);
    const auto alerts = [] { return json::parse(console("alerts list --json").output); };
    ASSERT_TRUE(eventually([&] { return !alerts().empty(); }));
    const std::string code = alerts().at(0).at("code");
    EXPECT_EQ(console("alerts silence all").code, 0);
    EXPECT_EQ(console("alerts acknowledge " + code).code, 0);
    const Ending none = console("alerts acknowledge brake.gone");
    EXPECT_EQ(none.code, 1);
    EXPECT_THAT(none.text, HasSubstr("no alert brake.gone stands"));
}

TEST(Console, BookmarksGoIntoTheLog) {
    ServerProcess server{options({})};
    EXPECT_EQ(console("bookmark 'brake too early'").code, 0);
    EXPECT_THAT(server.text(), HasSubstr("brake too early"));
}

TEST(Trainee, HearsNothingOfTheTruth) {
    const ServerProcess server{options({})};
    const ScriptFile script{R"({"steps": [{"when": {"after": 2}, "say": "two seconds"}]})"};
    const Ending seat = trainee(script.option());
    EXPECT_EQ(seat.code, 0) << seat.text;
    EXPECT_THAT(seat.text, HasSubstr("\"forecastle\":"));
    for (const char* truth : {"\"truth\":", "\"windlass\":", "\"chain\":", "\"ship\":", "\"event\":"})
        EXPECT_THAT(seat.text, testing::Not(HasSubstr(truth)));
    EXPECT_THAT(trainee(script.option() + "--coach ").text, HasSubstr("\"windlass\":"));
}

TEST(Trainee, ScriptThatWaitsInVainFailsWithStepWishAndValue) {
    const ServerProcess server{options({"--time-scale", "10"})};
    const ScriptFile script{R"({"steps": [{"do": {"engine": 0.1}},
                                          {"when": {"shackles": 6}, "say": "six", "timeout": 5}]})"};
    const Ending ending = trainee(script.option() + "--coach ");
    EXPECT_EQ(ending.code, 1);
    EXPECT_THAT(ending.text,
                HasSubstr("step 2 of 2 (\"six\") waits for shackles at least 6 shackles (now 0.18"));
    EXPECT_EQ(summary(ending).at("cable_out"), 5);
}

TEST(Trainee, ScriptOrdersBallAndLights) {
    const ServerProcess server{options({})};
    const ScriptFile script{R"({"steps": [{"show": {"anchor_ball": true, "anchor_lights": false}},
                                          {"when": {"after": 1}}]})"};
    EXPECT_EQ(trainee(script.option()).code, 0);
    EXPECT_THAT(server.text(), HasSubstr("anchor ball hoisted"));
}

TEST(Trainee, MateCarriesOutWhatAScriptOfTheBridgeOrders) {
    const ServerProcess server{options({"--time-scale", "10"})};
    const ScriptFile bridge{R"({"steps": [{"when": {"after": 2}, "order": {"code": "stand_by"}},
                                          {"when": {"after": 20}, "order": {"code": "let_go"}},
                                          {"when": {"after": 80}, "order": {"code": "hold_on", "value": 2}},
                                          {"when": {"after": 100}, "say": "that is all"}]})"};
    const std::string forecastle = TRAINEE_CLIENT + session() + "--connect 20 --view none --name mate " +
                                   "--seat forecastle --script " +
                                   WINDLASS_CONFIG_DIR "/scripts/mate_port.json";
    const std::string conn =
        TRAINEE_CLIENT + session() + "--connect 20 --view none --name conn --seat bridge " + bridge.option();
    const Ending both = run("bash -c '" + forecastle + " & mate=$!; " + conn +
                            "; code=$?; kill -TERM $mate; wait $mate; exit $code'");
    EXPECT_EQ(both.code, 0) << both.text;
    for (const char* said : {"reported: repeats: let go port anchor",
                             "reported: port anchor is on the bottom", "reported: 2 shackles in the pipe"})
        EXPECT_THAT(server.text(), HasSubstr(said));
}

TEST(Trainee, ScriptEndsWhenAnOrderIsRefused) {
    const ServerProcess server{options({})};
    const ScriptFile script{R"({"steps": [{"do": {"rudder_deg": 44}}, {"when": {"counter_shackles": 6}}]})"};
    const Ending ending = trainee(script.option());
    EXPECT_EQ(ending.code, 1);
    EXPECT_THAT(ending.text, HasSubstr("the server refused an order: HelmCommand from trainee: rudder"));
}

TEST(Trainee, ScriptEndsWithCode4WhenTheServerIsLost) {
    ServerProcess server{options({})};
    const ScriptFile script{R"({"steps": [{"report": {"code": "standing_by"}},
                                          {"when": {"counter_shackles": 6}}]})"};
    bool begun = false;
    std::thread end{[&] {
        begun = eventually([&] { return server.text().find("report.made") != std::string::npos; });
        server.signal(SIGKILL);
    }};
    const Ending ending = trainee(script.option());
    end.join();
    EXPECT_TRUE(begun);
    EXPECT_EQ(ending.code, 4);
    EXPECT_THAT(ending.text, HasSubstr("the server is gone: step 2 of 2 waits for counter_shackles"));
}

TEST(Trainee, ScriptedLetGoEndsBroughtUpAtSixShackles) {
    const ServerProcess server{options({"--time-scale", "10"})};
    const Ending ending = trainee("--coach --script " + let_go_script);
    ASSERT_EQ(ending.code, 0) << ending.text;
    for (const char* event : {"anchor.let_go", "anchor.on_bottom", "cable.shackle", "anchor.brought_up"})
        EXPECT_THAT(ending.text, HasSubstr(event));
    const json end = summary(ending);
    // Wide limits: how soon the trainee brakes depends on the machine's load too.
    EXPECT_NEAR(end.at("cable_out").get<double>(), 165, 15);
    EXPECT_GT(end.at("largest_load"), 100e3); // the cable came to strain
    EXPECT_LT(end.at("largest_load"), 0.15 * end.at("breaking_load").get<double>());
    EXPECT_LT(end.at("largest_brake_load"), 0.5 * end.at("brake_rating").get<double>());
    EXPECT_LT(end.at("largest_pay_out_speed"), 9);
    EXPECT_GT(end.at("brake_energy"), 0.5e6);
}

} // namespace
} // namespace windlass::test
