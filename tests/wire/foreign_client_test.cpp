// A client in C over Cyclone DDS (examples/cyclone_c) with the real server, both ways.

#include "rigs/server_process.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::test {
namespace {

using testing::HasSubstr;

TEST(CycloneClient, HearsEveryTopicAndWorksTheWindlass) {
    const std::string domain = std::to_string(own_domain());
    const ServerProcess server({"--domain", domain, "--partition", "foreign"});
    ASSERT_TRUE(eventually([&] { return server.text().find("exercise.started") != std::string::npos; }))
        << server.text();
    // 10 s: long enough for the hand-wheel to get to 0.75 and for discovery on a slow machine.
    const Ending ending =
        run("CYCLONEDDS_URI=file://" CYCLONE_CONFIG " " BRIDGE_CLIENT " " + domain + " foreign 10 0.75 0.25");
    EXPECT_EQ(ending.code, 0) << ending.text; // every stream was heard
    EXPECT_THAT(ending.text, HasSubstr("brake 0.750 speed_lever 0.250"));
    EXPECT_THAT(server.text(), HasSubstr("bridge has the port windlass"));
    EXPECT_TRUE(eventually([&] { // the server tells when it is gone
        return server.text().find("bridge is no longer heard") != std::string::npos;
    })) << server.text();
    EXPECT_EQ(server.text().find("command.refused"), std::string::npos) << server.text();
}

} // namespace
} // namespace windlass::test
