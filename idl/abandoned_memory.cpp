#include "idl/abandoned_memory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <string_view>

namespace windlass::wire {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = "fastrtps_", kLock = "_el";
constexpr std::size_t kDigits = 16;

bool is_lock_of_a_segment(std::string_view name) {
    if (name.size() != kPrefix.size() + kDigits + kLock.size() || !name.starts_with(kPrefix) ||
        !name.ends_with(kLock))
        return false;
    const auto digits = name.substr(kPrefix.size(), kDigits);
    return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The program that the lock belongs to is gone; if so, the segment goes, and the lock with it.
bool remove_if_abandoned(const fs::path& lock, std::chrono::seconds age) {
    const int file = open(lock.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return false;
    struct stat info {};
    const bool abandoned = fstat(file, &info) == 0 && info.st_uid == geteuid() &&
                           std::time(nullptr) - info.st_mtime >= age.count() &&
                           flock(file, LOCK_EX | LOCK_NB) == 0;
    if (abandoned) { // and locked by us, so that nobody else is at it
        const std::string path = lock.string();
        unlink(path.substr(0, path.size() - kLock.size()).c_str());
        unlink(path.c_str());
    }
    close(file);
    return abandoned;
}

} // namespace

int remove_abandoned_segments(const fs::path& folder, std::chrono::seconds age) {
    int removed = 0;
    std::error_code unreadable;
    for (auto entry = fs::directory_iterator(folder, unreadable); entry != fs::directory_iterator();
         entry.increment(unreadable)) {
        if (unreadable) break;
        if (is_lock_of_a_segment(entry->path().filename().string()) &&
            remove_if_abandoned(entry->path(), age))
            ++removed;
    }
    return removed;
}

} // namespace windlass::wire
