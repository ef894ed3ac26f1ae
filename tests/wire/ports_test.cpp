// Ports in shared memory, of those at which secure programs hear samples.

#include "idl/fast_dds_2_9/ports.hpp"
#include "tests/recorder/folder.hpp"

#include <gtest/gtest.h>

namespace windlass::test {
namespace {

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
