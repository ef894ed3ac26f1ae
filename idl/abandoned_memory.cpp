#include "idl/abandoned_memory.hpp"

#include "idl/ports.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

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

/// Those who write to a dead listener's port put new memory in its place, without a lock, and forget it when
/// they are killed themselves.
bool remove_if_never_listened_at(const std::string& memory, std::chrono::seconds age) {
    struct stat info {};
    return access((memory + std::string(kLock)).c_str(), F_OK) != 0 && lstat(memory.c_str(), &info) == 0 &&
           is_of_age(info, age) && unlink(memory.c_str()) == 0;
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
            if (!remove_if_abandoned(memory, age) && !remove_if_never_listened_at(memory, age)) continue;
            unlink((folder / ("sem." + name + "_mutex")).c_str());
            ++removed;
        }
    }
    return removed;
}

} // namespace windlass::wire
