#pragma once
// What only playing a lesson shows of it.

#include "instructor_console/lesson_files.hpp"

namespace windlass::console {

/// Plays the lesson's model run, and where it has hints its typical errors too, each once more without every
/// fault: when each fault could first be noticed in the model run, and by what; and what may be a mistake: a
/// must that the model run does not meet, an order that it is never given, a fault that never comes or that
/// nobody can notice, a hint that tells of a fault before anybody can. Throws exercise::ConfigError of a
/// script, and as lesson::play does.
std::vector<std::string> played_doubts(const LessonFile& file);

} // namespace windlass::console
