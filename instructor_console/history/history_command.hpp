#pragma once
// The subcommand "history" of the console. It hears no server: it works on a file.

#include "instructor_console/history/next_lesson.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace windlass::history {

/// What stands behind "history".
struct HistoryOptions {
    std::filesystem::path file = "recordings/history.sqlite";
    std::filesystem::path recording;
    std::size_t run = 0;
    std::vector<std::string> trainees; ///< PSEUDONYM or PSEUDONYM=NAME
    std::vector<std::string> seats;    ///< one for each trainee, or none
    bool replace = false;              ///< who has a seat gives way
    std::string group;
    std::string trainee, lesson;                        ///< whose, of which
    std::filesystem::path lessons = "config/exercises"; ///< folder of those that are offered
    std::string attempt, by, note, outcome;
    std::optional<double> score;
    std::filesystem::path output = "-";
    bool csv = true;
    bool with_names = false;
    double days = 0;
    enum class What { add, list, next, confirm, write_csv, erase, keep } what = What::list;
};

/// Adds "history" with its own subcommands; chosen is called when one of them stands on the command line.
void add_history(CLI::App& app, HistoryOptions& options, const std::function<void()>& chosen);

/// Does it; tells on stdout, as_json: one object. offered: the lessons of a folder, in the order in
/// which they are to be done. Throws
/// std::exception, with what is wrong.
void carry_out(const HistoryOptions& options, bool as_json,
               const std::function<std::vector<Offered>(const std::filesystem::path&)>& offered);

} // namespace windlass::history
