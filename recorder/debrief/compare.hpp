#pragma once
// Attempts laid over each other.

#include "recorder/debrief/attempt.hpp"

namespace windlass::debrief {

/// How far another attempt's times are put off so that both begin at the same thing.
struct Alignment {
    double shift = 0;   ///< s, to be added to the other's times
    std::string reason; ///< "aligned at letting go"
};

/// At letting go where both let go, else at the first fault where both had one, else at their beginnings.
Alignment align(const Attempt& attempt, const Attempt& other);

/// Why another attempt is not one at the same lesson, in words; empty: it is. Of an exercise without a
/// lesson: at the same exercise.
std::string unlike(const Attempt& attempt, const Attempt& other);

/// One figure of an attempt, in words and as a number.
struct Figure {
    std::string id;   ///< for machines: "largest_tension_port"
    std::string name; ///< for people
    double value = 0;
    std::string unit; ///< of the value, SI or points
    std::string words;
};

/// Duration, score, and of each side worked the largest tension, the fastest cable, the cable out and the
/// heat of the brake: of what counts (Attempt::counted_until()).
std::vector<Figure> figures_of(const Attempt& attempt);

} // namespace windlass::debrief
