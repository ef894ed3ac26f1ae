#pragma once
// The subcommand "lesson" of the console: lesson files on this computer. Needs no server.

#include "station/options.hpp"

#include <functional>

namespace windlass::console {

/// Adds "lesson" with its own subcommands; chosen is given the one on the command line. It returns an exit
/// code, and throws std::exception with a text for people.
void add_lesson(CLI::App& app, const std::function<void(std::function<int()>)>& chosen);

} // namespace windlass::console
