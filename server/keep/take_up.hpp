#pragma once
// What was kept of an exercise when its server was lost, worked again up to the tick at which it stopped.

#include "common/disk.hpp"
#include "server/exercise/definition/exercise_def.hpp"
#include "server/run/resumption.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace windlass::keep {

/// What is to come of a kept exercise.
struct TakeUp {
    /// Hash of the definition that the exercise is opened with; nothing: by no file, as instructors create
    /// them.
    std::optional<std::uint64_t> definition_hash;
    /// Throws std::exception when the definition that was kept is not one that a file could give.
    std::function<void(const exercise::ExerciseDef&)> check;
    bool running = false; ///< what ran runs on, or holds for its question again, and does not stand paused
};

struct TakenUp {
    run::Resumption how;
    std::optional<exercise::ExerciseDef> def; ///< that was kept; nothing: it begins from its file
};

/// States that lie below `aside` at most, the newest: whoever looks into a fault has time, and no disk fills.
inline constexpr std::size_t kMaxAside = 50;

/// Takes up what is kept in the folder of that exercise. What cannot be gone on from is moved below `aside`,
/// and the exercise begins anew: then what is wrong stands in Resumption::refused, with the file's name.
/// Counts as an attempt, until KeptExercise has written the next checkpoint: after two the state that was
/// kept last goes aside, and the checkpoint before it in its course is gone on from. Nothing: nothing is
/// kept.
std::optional<TakenUp> take_up(const std::filesystem::path& folder, const std::string& id,
                               const std::filesystem::path& aside, const TakeUp& wanted,
                               files::Disk& disk = files::system_disk());

} // namespace windlass::keep
