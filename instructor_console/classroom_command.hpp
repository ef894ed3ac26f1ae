#pragma once
// The subcommand "classroom" of the console.

#include "instructor_console/classroom.hpp"
#include "station/options.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::console {

/// What stands behind "classroom".
struct ClassroomOptions {
    NewExercise exercise;
    std::filesystem::path definition; ///< a file of the console's own machine
    enum class What { list, create, remove } what = What::list;
};

/// Adds "classroom" with its own subcommands; chosen is called when one of them stands on the command line.
void add_classroom(CLI::App& app, ClassroomOptions& options, const std::function<void()>& chosen);

/// Servers and exercises, with the fields' names as in the IDL.
nlohmann::json to_json(const std::vector<ClassroomStatus>& servers);

/// Carries out create or remove. Throws std::runtime_error when the definition's file cannot be read or DDS
/// cannot start.
Answer carry_out(const ClassroomOptions& options, const wire::JoinOptions& session, double timeout);

} // namespace windlass::console
