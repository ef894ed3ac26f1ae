#pragma once

#include "station/picture.hpp"

#include <string>

namespace windlass::console {

/// The exercise's status in some lines for people.
std::string status_text(const ExerciseStatus& status);

/// Every fault code, a line each: name, what it does, and which ones this version models.
std::string fault_list();

} // namespace windlass::console
