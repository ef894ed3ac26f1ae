#pragma once
// The assessment as a pure fold: state and picture of a tick in, state out. No clock, file, topic or chance;
// limits are compared and not summed, times are counted in ticks, marks are thousandths.

#include "server/assess/state.hpp"
#include "server/exercise/picture/snapshot.hpp"

namespace windlass::assess {

/// Begins the lesson at this picture.
void begin(const Lesson& lesson, State& state, const exercise::Snapshot& seen);

/// Takes the next tick. tick_rate: Hz. What the lesson orders now is put behind `due`: whoever goes through a
/// recording has it there already, and leaves it.
void fold(const Lesson& lesson, State& state, const exercise::Snapshot& seen, int tick_rate,
          std::vector<exercise::Order>& due);

/// Takes an order as it goes into the exercise, for the ticks that follow: reports, answers, and an
/// assessor's word.
void hear(const Lesson& lesson, State& state, const exercise::Order& order, int tick_rate);

/// Whether a condition holds at this tick. Conditions that must hold for a while are to be asked every tick.
bool holds(const Condition& condition, const Lesson& lesson, State& state, const exercise::Snapshot& seen,
           int tick_rate);

/// The first part of a condition that does not hold at this picture. Says nothing of how long it is to hold.
struct MissingPart {
    /// Place in its bounds; behind them the anchor's phase, then the signs, then its time, `either` and
    /// `neither`; -1: all hold.
    int place = -1;
    double value = 0; ///< of the bounded quantity, or the phase
};
inline constexpr int kEitherMissing = 1, kNeitherHolds = 2; ///< behind the place of its time
MissingPart missing_part(const Condition& condition, const Lesson& lesson, State& state,
                         const exercise::Snapshot& seen, int tick_rate);

/// A quantity at this tick; of what rises, over the last second.
double figure(int quantity, const exercise::Snapshot& seen, const exercise::TackleView& tackle,
              const State& state);

/// Tick at which a sign came; -1: it has not.
std::int64_t came(const Sign& sign, const State& state);

} // namespace windlass::assess
