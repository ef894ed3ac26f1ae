#pragma once
// What a fault of a lesson gives away of itself: a hand can only act on what a seat could notice.

#include "lesson/play.hpp"

#include <string>
#include <vector>

namespace windlass::lesson {

/// Of one fault in one run. s of exercise; below 0: never in this run.
struct Cue {
    std::string fault;              ///< its code
    double raised = -1;             ///< it is there
    double noticed = -1;            ///< the first sign of it, on deck or on the bridge
    std::string sign;               ///< by what
    std::vector<std::string> hints; ///< ids of those that it brought before anybody could have noticed it
};

/// Plays a lesson as it is, for practice if its text says so, and once more without each of its faults: what
/// the seats then see, hear and feel otherwise, by more than eye and ear can tell, is the sign of that fault,
/// and a hint that does not come then was brought by it. One line for each fault of the lesson and of the
/// exercise, in their order; the same fault twice at once counts from its first change. To a tenth of a
/// second. Throws as play does.
std::vector<Cue> cues(const exercise::ExerciseDef& def, const std::vector<trainee::Script>& scripts);

} // namespace windlass::lesson
