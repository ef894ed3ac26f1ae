// A program that is started again listens where nobody listened before.

#include "idl/ports.hpp"
#include "idl/wire.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/wait.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <set>

namespace windlass::test {
namespace {

/// Locks of ports in shared memory that the process has open: one for each at which it listens.
std::set<std::string> listens_at(pid_t process) {
    std::set<std::string> ports;
    for (const auto& open : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/fd")) {
        std::error_code closed;
        const auto file = std::filesystem::read_symlink(open, closed).filename().string();
        if (file.starts_with("fastrtps_port")) ports.insert(file);
    }
    return ports;
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

TEST(FreshPort, IsTheOnlyOneInSharedMemoryAtWhichAParticipantListens) {
    const wire::Participant one({own_domain(), "exercise/a", "one"}),
        other({own_domain(), "exercise/a", "other"});
    const auto ports = listens_at(getpid());
    EXPECT_EQ(ports.size(), 2U);
    for (const std::string& lock : ports)
        EXPECT_TRUE(wire::is_sample_port(lock.substr(0, lock.size() - 3))) << lock;
}

/// Whom the killed one's writers still reach in shared memory, the next program must not be.
TEST(FreshPort, OfAKilledProgramIsNotTakenAgain) {
    std::set<std::string> killed;
    constexpr int kTimes = 5;
    for (int i = 0; i < kTimes; ++i) {
        const pid_t child = fork(); // before this process has a participant of its own
        if (child == 0) {
            const wire::Participant member({own_domain(), "exercise/a", "killed"});
            pause();
            _exit(0);
        }
        ASSERT_TRUE(eventually([&] { return listens_at(child).size() == 1; }));
        killed.merge(listens_at(child));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        ASSERT_EQ(killed.size(), static_cast<std::size_t>(i + 1));
    }
}

} // namespace
} // namespace windlass::test
