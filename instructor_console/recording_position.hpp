#pragma once
// A moment of a recording, to go on from in a live exercise.

#include "instructor_console/orders.hpp"

#include <filesystem>

namespace windlass::console {

/// What is written FILE@TIME: a recording (folder or MCAP file), and s of exercise, or M:SS.
struct RecordingPosition {
    std::filesystem::path recording;
    double time = 0;
};

/// Nothing when the text is of no such form.
std::optional<RecordingPosition> moment_in(const std::string& text);

/// The order to go on from there, a lesson for practice, in the run of the recording that is meant (1: the
/// first; 0: the last that has that time). Reads the recording and goes through its orders from the
/// checkpoint before. Throws std::exception, with what is wrong, when the file cannot be read, has no such
/// moment, or does not agree with itself.
ServerOrder<RestoreCommand> restore_order(const RecordingPosition& moment, std::size_t run);

/// The same for what a replay shows at a position: s from the recording's beginning.
ServerOrder<RestoreCommand> restore_order_at(const std::filesystem::path& recording, double position);

} // namespace windlass::console
