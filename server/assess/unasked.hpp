#pragma once
// Reports that no criterion of a lesson asks for, or none at that time: those that were false are told beside
// the marks, and cost nothing.

#include "server/assess/marks.hpp"

namespace windlass::assess {

/// Lays into the lesson, whose criteria have all been read, what makes each such report true. sides: those
/// that the exercise has a windlass for.
void lay_unasked(Lesson& lesson, const std::vector<int>& sides);

/// Takes a report that came at this tick.
void take_unasked(const Heard& report, const Look& look);

/// Drops those that have come to be so in time, and keeps those that have not.
void watch_unasked(const Look& look);

} // namespace windlass::assess
