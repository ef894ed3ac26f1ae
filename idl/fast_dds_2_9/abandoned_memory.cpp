#include "idl/fast_dds_2_9/abandoned_memory.hpp"

#include "idl/fast_dds_2_9/ports.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <string>
#include <string_view>

namespace windlass::wire {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = "fastrtps_", kLock = "_el";
constexpr std::size_t kDigits = 16;

bool is_segment(std::string_view name) {
    return name.size() == kPrefix.size() + kDigits && name.starts_with(kPrefix) &&
           name.find_first_not_of("0123456789abcdef", kPrefix.size()) == std::string_view::npos;
}

/// Ours, and so old that its program has had the time to lock it.
bool is_of_age(const struct stat& info, std::chrono::seconds age) {
    return info.st_uid == geteuid() && std::time(nullptr) - info.st_mtime >= age.count();
}

/// Removes the memory and its lock, if the program that had the lock is gone.
bool remove_if_abandoned(const std::string& memory, std::chrono::seconds age) {
    const std::string lock = memory + std::string(kLock);
    const int file = open(lock.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return false;
    struct stat info {};
    const bool abandoned =
        fstat(file, &info) == 0 && is_of_age(info, age) && flock(file, LOCK_EX | LOCK_NB) == 0;
    if (abandoned) { // and locked by us, so that nobody else is at it
        unlink(memory.c_str());
        unlink(lock.c_str());
    }
    close(file);
    return abandoned;
}

/// Whether nobody else has the file open or mapped: the kernel gives a lease only then (fcntl(2)).
bool is_unused(int file) {
    // Who opens the file while we have the lease has us sent a signal, of which nothing comes.
    return fcntl(file, F_SETSIG, SIGURG) == 0 && fcntl(file, F_SETLEASE, F_WRLCK) == 0;
}

/// Removes the port's memory, lock and mutex if nobody has it mapped. A lock alone would not do: who wrote to
/// a listener that is gone still has its memory, and would not hear of the next one at that port.
bool remove_unused_port(const std::string& memory, const std::string& mutex, std::chrono::seconds age) {
    const int file = open(memory.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return false;
    struct stat info {};
    const bool unused = fstat(file, &info) == 0 && is_of_age(info, age) && is_unused(file);
    if (unused) {
        unlink(memory.c_str());
        unlink((memory + std::string(kLock)).c_str());
        unlink(mutex.c_str());
    }
    close(file);
    return unused;
}

} // namespace

int remove_abandoned_memory(const fs::path& folder, std::chrono::seconds age) {
    int removed = 0;
    std::error_code unreadable;
    for (auto entry = fs::directory_iterator(folder, unreadable); entry != fs::directory_iterator();
         entry.increment(unreadable)) {
        if (unreadable) break;
        const std::string memory = entry->path().string(), name = entry->path().filename().string();
        if (is_segment(name)) {
            if (remove_if_abandoned(memory, age)) ++removed;
        } else if (is_sample_port(name)) {
            if (remove_unused_port(memory, folder / ("sem." + name + "_mutex"), age)) ++removed;
        }
    }
    return removed;
}

} // namespace windlass::wire
