#include "server/keep/folder_lock.hpp"

#include "server/keep/kept_file.hpp"

#include <spdlog/fmt/fmt.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace windlass::keep {

namespace fs = std::filesystem;

namespace {

/// Who holds the lock, as it wrote itself into it.
std::string holder(int descriptor) {
    std::array<char, 32> text{};
    const ssize_t read = pread(descriptor, text.data(), text.size() - 1, 0);
    return read > 0 ? fmt::format("process {}", text.data()) : "another server";
}

/// Throws KeptError.
int lock(const fs::path& folder) {
    const fs::path path = folder / "lock";
    const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0)
        throw KeptError(
            fmt::format("{}: cannot be made: {}", path.string(), std::generic_category().message(errno)));
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        const std::string who = holder(descriptor);
        close(descriptor);
        throw KeptError(fmt::format("{}: {} keeps its exercises here; each server has a folder of its own",
                                    folder.string(), who));
    }
    const std::string self = std::to_string(getpid());
    if (ftruncate(descriptor, 0) != 0 ||
        pwrite(descriptor, self.data(), self.size(), 0) != static_cast<ssize_t>(self.size())) {
        const int error = errno;
        close(descriptor);
        throw KeptError(
            fmt::format("{}: cannot be written: {}", path.string(), std::generic_category().message(error)));
    }
    return descriptor;
}

fs::path made(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw KeptError(fmt::format("{}: this folder cannot be made: {}", folder.string(), error.message()));
    return folder;
}

} // namespace

FolderLock::FolderLock(const fs::path& folder) : descriptor_(lock(made(folder))) {}

void FolderLock::leave_to_parent() {
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = -1;
}

} // namespace windlass::keep
