// Two hosts: network namespaces joined by a cable (a veth pair). The server is on one, the stations are on
// the other.

#include "rigs/child_process.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;

const std::string kDiscovery = "10.99.7.1:11811";

class Network : public testing::Test {
protected:
    void SetUp() override {
        const auto made =
            run("command -v ip && ip netns add " + here_ + " && ip netns add " + there_ +
                " && ip link add wl0 netns " + here_ + " type veth peer name wl1 netns " + there_);
        if (made.code != 0)
            GTEST_SKIP() << "network namespaces are not to be had here (root, ip): " << made.text;
        for (const auto& [host, cable, address] :
             {std::tuple{here_, "wl0", "10.99.7.1/24"}, std::tuple{there_, "wl1", "10.99.7.2/24"}}) {
            const auto set = "ip -n " + host;
            ASSERT_EQ(run(set + " addr add " + address + " dev " + cable + " && " + set + " link set " +
                          cable + " up && " + set + " link set lo up")
                          .code,
                      0);
        }
        // Fast DDS looks at the interfaces when a program starts: one that is not up by then is not used.
        for (const auto& [host, cable] : {std::pair{here_, "wl0"}, std::pair{there_, "wl1"}}) {
            const auto look = "ip -n " + host + " link show " + cable;
            ASSERT_TRUE(eventually([&] { return run(look).text.find("state UP") != std::string::npos; }));
        }
    }
    void TearDown() override { run("ip netns del " + here_ + "; ip netns del " + there_); }

    /// The program with its arguments on that host.
    static std::vector<std::string> on(const std::string& host, const std::vector<std::string>& command) {
        std::vector<std::string> words{"/usr/bin/env", "ip", "netns", "exec", host};
        words.insert(words.end(), command.begin(), command.end());
        return words;
    }

    static std::vector<std::string> server(const std::vector<std::string>& network) {
        std::vector<std::string> words{WINDLASS_SERVER, "--partition", "far", "--time-scale", "8"};
        words.insert(words.end(), network.begin(), network.end());
        return words;
    }

    /// The trainee on the other host sees the exercise, and its hands let go the anchor in it.
    void expect_trainee_lets_go(const std::vector<std::string>& network, const ChildProcess& server) const {
        const std::string script = WINDLASS_CONFIG_DIR "/scripts/let_go_port_25m.json";
        std::vector<std::string> words{TRAINEE_CLIENT, "--coach", "--script", script,
                                       "--partition",  "far",     "--view",   "line"};
        words.insert(words.end(), network.begin(), network.end());
        const ChildProcess trainee(on(there_, words));
        EXPECT_TRUE(
            eventually([&] { return trainee.text().find("anchor on the bottom") != std::string::npos; },
                       std::chrono::seconds(40)))
            << trainee.text() << server.text();
        EXPECT_THAT(server.text(), HasSubstr("trainee has the port windlass"));
    }

    const std::string here_ = "windlass-a" + std::to_string(getpid());
    const std::string there_ = "windlass-b" + std::to_string(getpid());
};

TEST_F(Network, ServerAndTraineeOnTwoHostsMeetByMulticast) {
    const ChildProcess running(on(here_, server({"--lan"})));
    expect_trainee_lets_go({"--lan"}, running);
}

TEST_F(Network, ServerAndTraineeOnTwoHostsMeetThroughTheDiscoveryServer) {
    if (run("command -v fast-discovery-server").code != 0)
        GTEST_SKIP() << "fast-discovery-server is not here";
    const ChildProcess discovery(
        on(here_, {"fast-discovery-server", "-i", "0", "-l", "10.99.7.1", "-p", "11811"}));
    ASSERT_TRUE(eventually([&] { return discovery.text().find("Server is running") != std::string::npos; }))
        << discovery.text();
    // No multicast: the cable does not carry it.
    for (const auto& [host, cable] : {std::pair{here_, "wl0"}, std::pair{there_, "wl1"}})
        ASSERT_EQ(run("ip -n " + host + " link set " + cable + " multicast off").code, 0);
    const ChildProcess running(on(here_, server({"--discovery-server", kDiscovery})));
    expect_trainee_lets_go({"--discovery-server", kDiscovery}, running);
}

TEST_F(Network, WithoutAWordAboutTheNetworkAnExerciseStaysOnItsHost) {
    const ChildProcess running(on(here_, server({})));
    ASSERT_TRUE(eventually([&] { return running.text().find("exercise.started") != std::string::npos; }));
    ChildProcess console(
        on(there_, {INSTRUCTOR_CONSOLE, "--partition", "far", "--lan", "--timeout", "2", "status"}));
    EXPECT_EQ(console.exit_code(), 4) << console.text();
}

TEST(NetworkOptions, BadOnesAreRefusedWithWhatIsAllowed) {
    const auto told = [](const std::string& options) {
        return run(std::string(INSTRUCTOR_CONSOLE) + " " + options + " status");
    };
    for (const auto& [server, why] : {std::pair{"10.0.0.1", "HOST:PORT"},
                                      {"10.0.0.1:0", "a port from 1 to 65535"},
                                      {"10.0.0.1:70000", "a port from 1 to 65535"},
                                      {"10.0.0.1:11811x", "a port from 1 to 65535"},
                                      {"no-such-host.invalid:11811", "no IPv4 address"}}) {
        const auto answer = told(std::string("--discovery-server ") + server);
        EXPECT_EQ(answer.code, 1) << server;
        EXPECT_THAT(answer.text, HasSubstr(why));
    }
    EXPECT_EQ(told("--lan --discovery-server 10.0.0.1:11811").code, 2);
    const auto both = run("FASTRTPS_DEFAULT_PROFILES_FILE=/nowhere.xml " INSTRUCTOR_CONSOLE " --lan status");
    EXPECT_EQ(both.code, 1);
    EXPECT_THAT(told("--security . --discovery-server 10.0.0.1:11811").text, HasSubstr("use --lan"));
    EXPECT_THAT(both.text, HasSubstr("do not go with it"));
}

} // namespace
} // namespace windlass::test
