#pragma once
// From when an attempt that went wrong is done again.

#include "recorder/debrief/judgement.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace windlass::debrief {

inline constexpr double kAgainBefore = 10; ///< s, to have a hand on the lever by then

/// Before what it begins.
enum class AgainBefore {
    levers, ///< a hand took the levers, and what it did lost it
    order,  ///< the bridge gave the order of which it was lost
    due,    ///< the moment from which on it was to come about
    loss    ///< the loss itself: what lost it is not known
};
inline constexpr std::array kAgainBeforeNames{"levers", "order", "due", "loss"};

inline const char* name_of(AgainBefore what) {
    return kAgainBeforeNames.at(static_cast<std::size_t>(what));
}

struct Again {
    double from = 0; ///< s of exercise: ten seconds before that, or where the attempt began
    AgainBefore before = AgainBefore::loss;
    double seconds = 0; ///< from then until that: fewer than ten where the attempt began sooner
    std::string lost;   ///< what the criterion is called
    double lost_at = 0; ///< s of exercise
    /// What else had gone wrong by `from`, by when: it goes on as it stood then, marks and all.
    std::vector<std::string> standing{};
};

/// Of the first must that was missed, without one of the first loss of points (went_wrong()). Nothing:
/// it went wrong at no moment.
std::optional<Again> again_of(const Attempt& attempt);

} // namespace windlass::debrief
