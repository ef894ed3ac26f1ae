// Ports at which samples are heard.

#include "idl/fast_dds_2_9/ports.hpp"
#include "idl/wire.hpp"
#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"
#include "tests/recorder/folder.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace windlass::test {
namespace {

/// Of those in our range, at which this process hears UDP.
std::set<int> own_udp_ports() {
    std::set<std::string> sockets;
    for (const auto& file : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        const std::string name = std::filesystem::read_symlink(file.path(), gone).string();
        if (name.starts_with("socket:[")) sockets.insert(name.substr(8, name.size() - 9));
    }
    std::set<int> ports;
    std::ifstream table("/proc/self/net/udp");
    std::string line;
    std::getline(table, line); // names of the columns
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        std::string number, local, word, inode;
        fields >> number >> local;
        for (int column = 3; column <= 10; ++column)
            fields >> (column == 10 ? inode : word);
        const int port = std::stoi(local.substr(local.find(':') + 1), nullptr, 16);
        const bool ours =
            port >= wire::kFirstSamplePort && port < wire::kFirstSamplePort + wire::kSamplePorts;
        if (ours && sockets.contains(inode)) ports.insert(port);
    }
    return ports;
}

TEST(SamplePorts, AFurtherPartitionOfAMemberIsHeardAtAPortOfItsOwn) {
    const std::string one = "exercise/one", other = "exercise/other";
    wire::Participant member({rigs::own_domain(), one, "member", {}, {}});
    std::atomic<int> heard_in_one = 0, heard_in_other = 0;
    const wire::Reader<Report> in_one(member, wire::topics::report, [&](const Report&) { ++heard_in_one; });
    EXPECT_TRUE(own_udp_ports().empty()) << "its first is heard at its own, where others look for it";
    wire::Participant also(member, other);
    const wire::Reader<Report> in_other(also, wire::topics::report, [&](const Report&) { ++heard_in_other; });
    EXPECT_EQ(own_udp_ports().size(), 1U);

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
