#pragma once
// What a lesson that runs has come to.

#include "idl/types.hpp"

#include <optional>

namespace windlass::door {

struct MarksSoFar {
    double points = 0, lost = 0; ///< 0..100
};

/// Whether what an open criterion has lost is lost for good: its mark only falls.
inline bool only_falls(const Criterion& one) {
    return one.state() == CRITERION_OPEN && one.counts() &&
           (one.kind() == CRITERION_LIMIT || one.kind() == CRITERION_STATE_AT);
}

/// What is kept of what is decided, and what is lost for good, in points of 100 that the whole lesson has, as
/// the desk tells it (kit/points_said.ts). In the score of a lesson that runs, what nobody has offended
/// against yet counts as kept: a third of the points for a hand that has not moved. Nothing: there is nothing
/// to mark.
inline std::optional<MarksSoFar> marks_so_far(const Assessment& marks) {
    double kept = 0, lost = 0, whole = 0;
    for (const Criterion& one : marks.criteria()) {
        const bool set = one.state() == CRITERION_OVERRIDDEN;
        if (set ? !one.counts() : one.kind() == CRITERION_RUBRIC) continue; // not applicable; an assessor's
        whole += one.weight();
        const bool decided = set || (one.tick() != 0 && one.counts());
        if (decided) kept += one.weight() * one.counted() / 1000.0;
        if (decided || only_falls(one)) lost += one.weight() * (1000 - one.counted()) / 1000.0;
    }
    if (whole <= 0) return std::nullopt;
    return MarksSoFar{.points = 100 * kept / whole, .lost = 100 * lost / whole};
}

} // namespace windlass::door
