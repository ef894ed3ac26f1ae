#pragma once
// Keeps the exercises of one server on disk, so that a server that is lost can take them up again.

#include "server/keep/folder_lock.hpp"
#include "server/keep/kept_exercise.hpp"
#include "server/keep/take_up.hpp"

#include <condition_variable>
#include <thread>

namespace windlass::keep {

/// Owns a folder: `exercise-ID` for each exercise that is kept, `aside` for what could not be gone on from,
/// and the lock on it.
class Keeper {
public:
    /// Makes the folder. Throws KeptError, saying what is wrong with it and who has it.
    explicit Keeper(const std::filesystem::path& folder);
    /// Every exercise must have been closed.
    ~Keeper();
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    /// Names of the exercises that a server kept which was lost.
    std::vector<std::string> kept() const;
    /// Takes up what was kept of the exercise, as keep::take_up.
    std::optional<TakenUp> take_up(const std::string& id, const TakeUp& wanted) const;

    /// Keeps an exercise from now on, until it is closed.
    std::shared_ptr<KeptExercise> keep(const std::string& id, std::uint64_t definition_hash);

    /// From now on exercises end in order: nothing of them is to be taken up again.
    void end_in_order() { in_order_ = true; }
    bool ends_in_order() const { return in_order_; }

private:
    void write();
    void sync();
    std::vector<std::shared_ptr<KeptExercise>> exercises();
    bool wait(std::chrono::milliseconds time);

    const std::filesystem::path folder_;
    const FolderLock lock_;
    std::atomic<bool> in_order_{false};
    std::mutex mutex_;
    std::condition_variable stopped_;
    bool stop_ = false;                                    // guarded by mutex_
    std::vector<std::shared_ptr<KeptExercise>> exercises_; // guarded by mutex_
    std::thread writing_, syncing_;                        // last: they use all of the above
};

} // namespace windlass::keep
