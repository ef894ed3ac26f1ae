#pragma once
// What each kind of criterion makes of a tick.

#include "server/assess/fold.hpp"

namespace windlass::assess {

/// What a criterion is looked at with.
struct Look {
    const Lesson& lesson;
    State& state;
    const exercise::Snapshot& seen;
    int tick_rate;
    std::int64_t tick() const { return static_cast<std::int64_t>(seen.tick); }
    bool holds(const Condition& condition) const {
        return assess::holds(condition, lesson, state, seen, tick_rate);
    }
};

/// Takes a tick, before the lesson has ended.
void look_at(const Criterion& criterion, Mark& mark, const Look& look);

/// Takes a report that came at this tick.
void take_report(const Criterion& criterion, Mark& mark, const Heard& report, const Look& look);

/// The lesson has ended: what was open is decided.
void close(const Criterion& criterion, Mark& mark, const State& state, const Lesson& lesson, int tick_rate);

/// A mark from which on a criterion is met.
inline constexpr int kMet = 500;

} // namespace windlass::assess
