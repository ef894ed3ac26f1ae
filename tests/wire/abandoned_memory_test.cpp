// Shared memory that killed programs leave behind goes; all else stays.

#include "idl/fast_dds_2_9/abandoned_memory.hpp"
#include "tests/recorder/folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>

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

TEST_F(AbandonedMemory, PortThatNobodyHasMappedGoesWithItsLockAndMutex) {
    const std::vector<std::string> files{kPort, std::string(kPort) + "_el",
                                         "sem." + std::string(kPort) + "_mutex"};
    for (const auto& file : files)
        put(file);
    const int port = open((folder_ / kPort).c_str(), O_RDWR);
    void* memory = mmap(nullptr, 1, PROT_READ | PROT_WRITE, MAP_SHARED, port, 0);
    ASSERT_NE(memory, MAP_FAILED);
    close(port);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 0);
    munmap(memory, 1);
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 60s), 0); // perhaps not yet mapped
    for (const auto& file : files)
        EXPECT_TRUE(there(file)) << file;
    EXPECT_EQ(remove_abandoned_memory(folder_.path(), 0s), 1);
    for (const auto& file : files)
        EXPECT_FALSE(there(file)) << file;
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

} // namespace
} // namespace windlass::test
