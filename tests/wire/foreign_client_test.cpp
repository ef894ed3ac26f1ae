// A client in C over Cyclone DDS (examples/cyclone_c) with the real server, both ways.

#include "rigs/server_process.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;

TEST(CycloneClient, HearsWhatABridgeMayHearAndWorksTheWindlass) {
    const std::string domain = std::to_string(own_domain());
    const ServerProcess server({"--domain", domain, "--partition", "foreign"});
    ASSERT_TRUE(eventually([&] { return server.text().find("exercise.started") != std::string::npos; }))
        << server.text();
    // 10 s: long enough for the hand-wheel to get to 0.75 and for discovery on a slow machine.
    const Ending ending =
        run("CYCLONEDDS_URI=file://" CYCLONE_CONFIG " " BRIDGE_CLIENT " " + domain + " foreign 10 0.75 0.25");
    EXPECT_EQ(ending.code, 0) << ending.text; // every topic was heard that always comes
    EXPECT_THAT(ending.text, HasSubstr("brake 0.750 speed_lever 0.250"));
    // Two hawses, each with the force of its cable; what all do is their sum.
    double all = 0, each = 0;
    for (const auto& [of, sum] :
         {std::pair<const char*, double*>{"port", &each}, {"starboard", &each}, {"all", &all}}) {
        const auto at = ending.text.find(std::string("\n") + of + " force ");
        ASSERT_NE(at, std::string::npos) << ending.text;
        double x = 0, y = 0, z = 0;
        ASSERT_EQ(std::sscanf(ending.text.c_str() + ending.text.find("force", at), "force %lf %lf %lf N", &x,
                              &y, &z),
                  3);
        *sum += z;
    }
    EXPECT_LT(all, 0) << ending.text; // anchor and cable hang on the ship
    EXPECT_NEAR(each, all, 2);        // N; each figure is rounded to 1
    EXPECT_THAT(server.text(), HasSubstr("bridge has the port windlass"));
    EXPECT_TRUE(eventually([&] { // the server tells when it is gone
        return server.text().find("bridge is no longer heard") != std::string::npos;
    })) << server.text();
    EXPECT_EQ(server.text().find("command.refused"), std::string::npos) << server.text();
}

TEST(CycloneClient, SailsTheShipAndFeelsHerCables) {
    const std::string domain = std::to_string(own_domain());
    const ServerProcess server({"--domain", domain, "--partition", "sails"});
    ASSERT_TRUE(eventually([&] { return server.text().find("exercise.started") != std::string::npos; }))
        << server.text();
    const Ending ending = run("CYCLONEDDS_URI=file://" CYCLONE_CONFIG " " OWN_SHIP " " + domain + " sails 8");
    EXPECT_EQ(ending.code, 0) << ending.text << server.text(); // the server's ship was where it had her
    double force = 0;
    ASSERT_EQ(std::sscanf(ending.text.c_str() + std::min(ending.text.find("cables"), ending.text.size()),
                          "cables %lf N", &force),
              1)
        << ending.text;
    EXPECT_GT(force, 0);
    EXPECT_THAT(server.text(), HasSubstr("own_ship.foreign"));
    EXPECT_TRUE(eventually([&] { return server.text().find("own_ship.lost") != std::string::npos; }))
        << server.text();
    EXPECT_EQ(server.text().find("command.refused"), std::string::npos) << server.text();
}

} // namespace
} // namespace windlass::test
