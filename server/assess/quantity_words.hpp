#pragma once
// Figures of a lesson as they are said on deck: "brake hard on", and not a wheel above 0.95.

#include "server/assess/lesson.hpp"
#include "server/assess/quantities.hpp"

#include <string>

namespace windlass::assess {

/// A quantity's name without what explains it: "speed lever" of "speed lever (-1 lower, 1 heave)".
std::string short_name(const Quantity& quantity);

/// What is wanted of a figure: "brake hard on", "cable out from the lip below 6 shackles", "stopper closed",
/// "the motor has not tripped".
std::string bounds_words(const Bounds& bounds);

/// What was found of it: "brake was open", "cable out from the lip was 6.97 shackles", "stopper open". value:
/// SI.
std::string found_words(const Quantity& quantity, double value);

} // namespace windlass::assess
