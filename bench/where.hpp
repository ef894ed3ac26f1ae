#pragma once
// What a second of one exercise costs, part by part.

#include <filesystem>

namespace windlass::bench {

/// Plays the exercise of that file alone, as fast as it goes, with nobody listening, and prints as a Markdown
/// table what each part of it takes of a second: processor time of its thread. Measured over so many seconds
/// of exercise time from the seventh on, when rows of bench_classroom begin. Throws std::runtime_error.
void tell_where(const std::filesystem::path& exercise, double seconds, int domain);

} // namespace windlass::bench
