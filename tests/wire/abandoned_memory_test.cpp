// Shared memory that killed programs leave behind goes; all else stays.

#include "idl/abandoned_memory.hpp"
#include "idl/wire.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/wait.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>

#include <atomic>

namespace windlass::test {
namespace {

using wire::remove_abandoned_memory;
using namespace std::chrono_literals;

constexpr const char* kSegment = "fastrtps_0123456789abcdef";
constexpr const char* kPort = "fastrtps_port20000"; // of those at which our programs hear samples

class AbandonedMemory : public testing::Test {
protected:
    void put(const std::string& name) const { std::ofstream(folder_ / name) << "x"; }
    bool there(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

    const Folder folder_;
};

TEST_F(AbandonedMemory, SegmentWithoutItsProgramGoesWithItsLock) {
    put(kSegment);
    put(std::string(kSegment) + "_el");
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 1);
    EXPECT_FALSE(there(kSegment));
    EXPECT_FALSE(there(std::string(kSegment) + "_el"));
}

TEST_F(AbandonedMemory, SegmentOfALivingProgramStays) {
    put(kSegment);
    put(std::string(kSegment) + "_el");
    const int lock = open((folder_ / (std::string(kSegment) + "_el")).c_str(), O_RDONLY);
    ASSERT_EQ(flock(lock, LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 0);
    EXPECT_TRUE(there(kSegment));
    close(lock);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 1);
}

TEST_F(AbandonedMemory, PortOfASampleListenerThatIsGoneGoesWithItsLockAndMutex) {
    const std::vector<std::string> files{kPort, std::string(kPort) + "_el",
                                         "sem." + std::string(kPort) + "_mutex"};
    for (const auto& file : files)
        put(file);
    const int lock = open((folder_ / files[1]).c_str(), O_RDONLY);
    ASSERT_EQ(flock(lock, LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 0); // alive
    close(lock);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 60s), 0); // perhaps not yet locked
    for (const auto& file : files)
        EXPECT_TRUE(there(file)) << file;
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 1);
    for (const auto& file : files)
        EXPECT_FALSE(there(file)) << file;
}

TEST_F(AbandonedMemory, PortAtWhichNobodyListensGoes) {
    put(kPort);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 60s), 0);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 1);
    EXPECT_FALSE(there(kPort));
}

TEST_F(AbandonedMemory, YoungOnesOtherPortsAndFilesOfOthersStay) {
    put(kSegment);
    put(std::string(kSegment) + "_el");
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 60s), 0);
    for (const char* name :
         {"fastrtps_port7410", "fastrtps_port7410_el", "sem.fastrtps_port7410_mutex", "fastrtps_port32000",
          "fastrtps_port20000x", "fastrtps_0123456789ABCDEF_el", "fastrtps_0123456789abcdef0_el", "other_el"})
        put(name);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 1);
    for (const char* name :
         {"fastrtps_port7410", "fastrtps_port7410_el", "sem.fastrtps_port7410_mutex", "fastrtps_port32000",
          "fastrtps_port20000x", "fastrtps_0123456789ABCDEF_el", "fastrtps_0123456789abcdef0_el", "other_el"})
        EXPECT_TRUE(there(name)) << name;
    EXPECT_EQ(remove_abandoned_memory(folder_ / "nowhere", 0s), 0);
}

/// Our belief about Fast DDS, held against it: what a live participant uses is locked.
TEST(LivingMemory, OfAParticipantStaysAndGoesOnCarryingSamples) {
    wire::Participant server({own_domain(), "exercise/a", "server", {}, {}});
    wire::Participant client({own_domain(), "exercise/a", "client", {}, {}});
    std::atomic<int> heard{0};
    const wire::Reader<Event> reader(client, wire::topics::event, [&](const Event&) { ++heard; });
    wire::Writer<Event> writer(server, wire::topics::event);
    ASSERT_TRUE(eventually([&] { return writer.matched() == 1; }));
    const auto locks = [] {
        std::size_t count = 0; // of segments, living ones and others'
        for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) {
            const auto name = entry.path().filename().string();
            const int file = name.starts_with("fastrtps_") && name.ends_with("_el") && name.size() == 28
                                 ? open(entry.path().c_str(), O_RDONLY)
                                 : -1;
            if (file < 0) continue;
            if (flock(file, LOCK_EX | LOCK_NB) != 0) ++count;
            close(file);
        }
        return count;
    };
    ASSERT_GE(locks(), 2U);
    std::this_thread::sleep_for(1100ms); // other programs of this host may be just starting
    remove_abandoned_memory("/dev/shm", 1s);
    EXPECT_GE(locks(), 2U);
    for (int i = 1; i <= 100; ++i)
        ASSERT_TRUE(writer.write(Event{}));
    EXPECT_TRUE(eventually([&] { return heard == 100; }));
}

} // namespace
} // namespace windlass::test
