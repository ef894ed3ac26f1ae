#include "server/keep/keeper.hpp"

#include "common/thread_name.hpp"

#include <spdlog/fmt/fmt.h>

#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace windlass::keep {

namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;

constexpr auto kWriteEvery = 10ms;           // what a server that is killed has not handed to the system yet
constexpr auto kSyncEvery = 1s;              // what is lost when the power goes
constexpr const char* kPrefix = "exercise-"; // an exercise may be called ".." or "aside"

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

/// Writes in what time the exercises leave, whatever the thread that began this one is.
void leave_realtime() {
    const sched_param ordinary{};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
}

} // namespace

Keeper::Keeper(const fs::path& folder) : folder_(made(folder)), lock_(lock(folder_)) {
    const ThreadName name("keep");
    writing_ = std::thread([this] { write(); });
    const ThreadName disk("keep-disk");
    syncing_ = std::thread([this] { sync(); });
}

Keeper::~Keeper() {
    {
        const std::lock_guard guard(mutex_);
        stop_ = true;
    }
    stopped_.notify_all();
    writing_.join();
    syncing_.join();
    close(lock_);
}

fs::path Keeper::folder_of(const std::string& id) const {
    return folder_ / (kPrefix + id);
}

std::vector<std::string> Keeper::kept() const {
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const std::string name = entry.path().filename();
        if (name.starts_with(kPrefix) && !kept_files(entry.path()).empty())
            ids.push_back(name.substr(std::string(kPrefix).size()));
    }
    std::ranges::sort(ids);
    return ids;
}

std::optional<TakenUp> Keeper::take_up(const std::string& id, const TakeUp& wanted) const {
    return keep::take_up(folder_of(id), id, folder_ / "aside", wanted);
}

std::shared_ptr<KeptExercise> Keeper::keep(const std::string& id, std::uint64_t definition_hash) {
    auto exercise = std::make_shared<KeptExercise>(folder_of(id), id, definition_hash);
    const std::lock_guard guard(mutex_);
    exercises_.push_back(exercise);
    return exercise;
}

std::vector<std::shared_ptr<KeptExercise>> Keeper::exercises() {
    const std::lock_guard guard(mutex_);
    return exercises_;
}

/// False: the keeper has come to its end.
bool Keeper::wait(std::chrono::milliseconds time) {
    std::unique_lock guard(mutex_);
    return !stopped_.wait_for(guard, time, [this] { return stop_; });
}

void Keeper::write() {
    leave_realtime();
    while (wait(kWriteEvery)) {
        for (const auto& exercise : exercises()) {
            if (exercise->write_waiting()) continue;
            const std::lock_guard guard(mutex_);
            std::erase(exercises_, exercise);
        }
    }
}

/// On a thread of its own: while the disk is waited for, what comes is written on.
void Keeper::sync() {
    leave_realtime();
    while (wait(kSyncEvery))
        for (const auto& exercise : exercises())
            exercise->sync();
}

} // namespace windlass::keep
