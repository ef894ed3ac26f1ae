#pragma once
// An answer as curves: what was lost as it was, and as it would have been by the one change.

#include "lesson/whatif/search.hpp"

#include <optional>
#include <vector>

namespace windlass::whatif {

/// A figure at a time.
struct Point {
    double time = 0; ///< s of exercise
    double value = 0;
    bool operator==(const Point&) const = default;
};

/// One quantity over the window, SI.
struct TwoCurves {
    int quantity = 0;                                          ///< place in assess::quantities()
    double least = -assess::kNoLimit, most = assess::kNoLimit; ///< that the criterion allows
    std::vector<Point> was, would;
};

/// Both ways through.
struct TwoCourses {
    double changed = 0, lost = 0;  ///< s of exercise: the first thing that is otherwise; when it was lost
    std::vector<TwoCurves> curves; ///< empty: nothing moves otherwise than it did
    /// Both at the last moment to which both go.
    std::optional<exercise::Snapshot> was, would;
};

inline constexpr double kWindowBefore = 20, kWindowBehind = 30; ///< s, of the change; of the loss

/// From kWindowBefore before the change until kWindowBehind behind the loss: the quantity that the criterion
/// looks at; cable, speed and load where it looks at none, or none that the change moves; the lever alone
/// where they stay as they were. Nothing: no change helps.
std::optional<TwoCourses> two_courses(Trials& trials, const Answer& answer);

} // namespace windlass::whatif
