#include "server/keep/keeper.hpp"

#include "common/thread_name.hpp"
#include "server/keep/kept_folders.hpp"

#include <pthread.h>

namespace windlass::keep {

namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;

constexpr auto kWriteEvery = 10ms; // what a server that is killed has not handed to the system yet
constexpr auto kSyncEvery = 1s;    // what is lost when the power goes

/// Writes in what time the exercises leave, whatever the thread that began this one is.
void leave_realtime() {
    const sched_param ordinary{};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
}

} // namespace

Keeper::Keeper(const fs::path& folder) : folder_(folder), lock_(folder) {
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
}

std::vector<std::string> Keeper::kept() const {
    return kept_in(folder_);
}

std::optional<TakenUp> Keeper::take_up(const std::string& id, const TakeUp& wanted) const {
    return keep::take_up(folder_of(folder_, id), id, folder_ / "aside", wanted);
}

std::shared_ptr<KeptExercise> Keeper::keep(const std::string& id, std::uint64_t definition_hash) {
    auto exercise = std::make_shared<KeptExercise>(folder_of(folder_, id), id, definition_hash);
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
