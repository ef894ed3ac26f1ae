#pragma once
// What if: for each point that an attempt at a lesson lost, the smallest change that would have kept it, and
// how sure that is. docs/whatif.md says what is searched and what is not.

#include "lesson/whatif/trials.hpp"

namespace windlass::whatif {

enum class ChangeKind {
    report_given,    ///< one that was not made
    report_moved,    ///< one that was made at another time, or with other figures
    report_left_out, ///< one that was not so
    order_repeated,  ///< back to the bridge, at once and as it was given
    sooner,          ///< a lever's move
    later,
    more, ///< a lever's move goes to a greater value
    less,
    left_out, ///< a lever's move is not made: it stays where it was until its next one
    one_more  ///< a move that was not made: the lever stays there until its next one
};

/// Changes are counted in steps of a tenth of a second, or of a hundredth of a lever's way.
inline constexpr double kStep = 0.1;   // s
inline constexpr double kShare = 0.01; // of a lever's way, from nothing to full

/// One change to what one hand did.
struct Change {
    ChangeKind kind = ChangeKind::sooner;
    int steps = 0;                           ///< its size; 0 where it has none
    std::uint64_t tick = 0;                  ///< at which it now is
    std::optional<std::uint64_t> was_tick{}; ///< at which it was; nothing: it was not
    Lever lever{};                           ///< of a move
    double value = 0;                        ///< to which the lever goes now; left out: where it stays
    double was_value = 0;                    ///< to which it went; one more: where it stood
    exercise::ReportMade report{};           ///< of a report
};

/// Whether an answer stands with the lever (or word) a little sooner and later, with the lever a little more
/// and less, a millimetre more water, and other gusts. Nothing: it was not tried, since it makes no
/// difference there.
struct Sure {
    std::optional<bool> sooner{}, later{}, more{}, less{}, water{}, gusts{};
    bool stands() const {
        return sooner.value_or(true) && later.value_or(true) && more.value_or(true) && less.value_or(true) &&
               water.value_or(true) && gusts.value_or(true);
    }
};

/// A change that keeps what was lost, all other hands as recorded.
struct Kept {
    Change change;
    int least_steps = 0; ///< the smallest of this kind that kept it, sure or not
    Sure sure;           ///< where it does not stand, chance decides
    assess::Result result;
};

/// The last moment from which the lesson's model hands keep it; behind it, it is past mending.
struct TakenOver {
    double time = 0;               ///< s of exercise, to half a second
    std::optional<Change> first{}; ///< the first thing that they do otherwise
    Sure sure;
    assess::Result result;
};

/// What was lost, and what would have kept it.
struct Answer {
    std::size_t criterion = 0;             ///< place in the lesson's
    assess::CriterionResult lost{};        ///< as it was
    double lost_time = 0;                  ///< s of exercise, at which it went wrong
    std::optional<Kept> kept{};            ///< nothing: no single change keeps it
    std::optional<TakenOver> taken_over{}; ///< where no single change keeps it
    std::size_t tried = 0;                 ///< branches
    double gone_through = 0;               ///< s of exercise, of all of them
};

/// Ids of the criteria that lack any of their mark, in the order in which they were lost.
std::vector<std::string> lost_criteria(const Trials& trials);

/// What would have kept a criterion that was lost. Throws std::invalid_argument when it was not.
Answer what_if(Trials& trials, const std::string& criterion);

/// The last moment from which the lesson's model hands keep it: behind it, it is past mending. Nothing: they
/// never do. Throws std::invalid_argument when it was not lost.
std::optional<TakenOver> last_moment(Trials& trials, const std::string& criterion);

/// The orders of all hands with that change made to them, as what_if() tries it. nudge: the change is made so
/// many steps later, or earlier below 0. Nothing: the lever's moves before and behind leave no room for it.
std::optional<Variation> varied(const Trials& trials, const Change& change, int nudge = 0);

} // namespace windlass::whatif
