#pragma once
// What the file of a lesson says for a debriefing, where a recording has it attached.

#include "recorder/debrief/attempt.hpp"
#include "recorder/recording/recording.hpp"

#include <map>
#include <string>

namespace windlass::debrief {

/// The first attached file with a lesson in it, or else the first exercise. Empty when none is attached, or
/// none can be read.
LessonText lesson_text(recording::Recording& recording);

/// The same of a file's text; name: of the attachment. The lesson is its member "lesson"; what is not as a
/// lesson has it is left out.
LessonText lesson_text(const std::string& name, const std::string& json);

/// What each limit of the lesson is of, by its criterion: "cable_speed". Empty where the lesson is not
/// attached.
std::map<std::string, std::string> limited_by(const LessonText& lesson);

} // namespace windlass::debrief
