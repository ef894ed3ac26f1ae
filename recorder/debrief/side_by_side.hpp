#pragma once
// A class at one lesson: what came of each of its exercises, beside each other.

#include "recorder/debrief/page.hpp"

namespace windlass::debrief {

/// One exercise of a class.
struct Beside {
    std::string who = {};               ///< "Anna, forecastle; Ben, bridge"
    std::string link = {};              ///< address of its debriefing; empty: none
    const Attempt* attempt = nullptr;   ///< nullptr: there is none
    std::string missing = {};           ///< why there is none: "was not recorded"
    std::optional<LaterWord> word = {}; ///< nothing: no assessor has said anything since
};

/// From when each is told: letting go where one let go, else the first fault where one had one, else the
/// beginning of the exercise. Who never did is told from when the middle one of the others did. Each has an
/// attempt.
struct Zero {
    std::vector<double> times; ///< s of exercise, of each
    std::string words;         ///< "letting go"
};
Zero zero_of(const std::vector<Beside>& all);

/// One HTML document, like a debriefing: the marks of each; each criterion over all of them, those that lost
/// most points first; who did what when; brakes and cable over one time. Those without an attempt and those
/// of another lesson than the first are left out, and it says so.
std::string side_by_side_page(const std::string& title, const std::vector<Beside>& all);

} // namespace windlass::debrief
