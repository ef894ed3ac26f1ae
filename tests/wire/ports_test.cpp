// Ports at which samples are heard.

#include "idl/fast_dds_2_9/ports.hpp"
#include "idl/wire.hpp"
#include "rigs/own_domain.hpp"
#include "rigs/udp_ports.hpp"
#include "rigs/wait.hpp"
#include "tests/recorder/folder.hpp"

#include <gtest/gtest.h>

#include <set>

namespace windlass::test {
namespace {

/// Of those in our range, at which this process hears UDP.
std::set<int> own_sample_ports() {
    std::set<int> ports = rigs::udp_ports_of(getpid());
    std::erase_if(ports, [](int port) {
        return port < wire::kFirstSamplePort || port >= wire::kFirstSamplePort + wire::kSamplePorts;
    });
    return ports;
}

TEST(SamplePorts, AFurtherPartitionOfAMemberIsHeardAtAPortOfItsOwn) {
    const std::string one = "exercise/one", other = "exercise/other";
    wire::Participant member({rigs::own_domain(), one, "member", {}, {}});
    std::atomic<int> heard_in_one = 0, heard_in_other = 0;
    const wire::Reader<Report> in_one(member, wire::topics::report, [&](const Report&) { ++heard_in_one; });
    EXPECT_TRUE(own_sample_ports().empty()) << "its first is heard at its own, where others look for it";
    wire::Participant also(member, other);
    const wire::Reader<Report> in_other(also, wire::topics::report, [&](const Report&) { ++heard_in_other; });
    EXPECT_EQ(own_sample_ports().size(), 1U);

    wire::Participant speaker({rigs::own_domain(), one, "speaker", {}, {}});
    wire::Participant also_speaks(speaker, other);
    wire::Writer<Report> says(speaker, wire::topics::report), also_says(also_speaks, wire::topics::report);
    ASSERT_TRUE(rigs::eventually([&] { return says.matched() == 1 && also_says.matched() == 1; }));
    says.write({});
    for (int i = 0; i < 3; ++i)
        also_says.write({});
    EXPECT_TRUE(rigs::eventually([&] { return heard_in_one == 1 && heard_in_other == 3; }))
        << heard_in_one << ", " << heard_in_other;
}

TEST(FreshPort, OfUdpIsHeardByNobody) {
    const int port = wire::fresh_udp_port();
    EXPECT_GE(port, wire::kFirstSamplePort);
    EXPECT_LT(port, wire::kFirstSamplePort + wire::kSamplePorts);
}

TEST(FreshPort, IsOneWithoutMemory) {
    const Folder folder;
    constexpr int kFree = wire::kFirstSamplePort + 4711;
    for (int port = wire::kFirstSamplePort; port < wire::kFirstSamplePort + wire::kSamplePorts; ++port)
        if (port != kFree) put(wire::port_memory(port, folder.path()), "");
    EXPECT_EQ(wire::fresh_port(folder.path()), kFree);
}

TEST(FreshPort, IsSomeOneWhereAllHaveMemory) {
    const Folder folder;
    for (int port = wire::kFirstSamplePort; port < wire::kFirstSamplePort + wire::kSamplePorts; ++port)
        put(wire::port_memory(port, folder.path()), "");
    const int port = wire::fresh_port(folder.path());
    EXPECT_GE(port, wire::kFirstSamplePort);
    EXPECT_LT(port, wire::kFirstSamplePort + wire::kSamplePorts);
}

} // namespace
} // namespace windlass::test
