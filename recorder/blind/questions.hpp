#pragma once
// What a master is asked of a recording, and how our own marks stand on the scale that he marks on.

#include "server/assess/lesson.hpp"
#include "server/assess/result.hpp"

#include <optional>

namespace windlass::blind {

inline constexpr int kTopMark = 3;

/// Of a criterion: 0 not done, 1 poor, 2 fair, 3 good.
inline constexpr std::array<const char*, kTopMark + 1> kScale{"not done", "poor", "fair", "good"};
/// Of the whole.
inline constexpr std::array<const char*, kTopMark + 1> kWholeScale{"not competent", "not yet competent",
                                                                   "competent", "competent, and well"};

/// The item that is the whole; those of criteria are LESSON/CRITERION.
inline constexpr const char* kOverall = "overall";

struct Question {
    std::string item, words;
    std::optional<int> ours; ///< nothing: it never came into play
};

/// Where a mark of 0..1000 stands on the scale, whose steps are its quarters: from half on it is met, by our
/// mark and by the scale.
int on_scale(int milli);

/// Where the whole stands: competent where it is achieved, and well from 85 points on, which the model hand
/// of every lesson has; else not yet competent from half of the points that the lesson asks for on.
int on_scale(const assess::Result& result);

/// The lesson's criteria, but for those that only an assessor marks, and the whole. A question says what was
/// looked at, and not where our limits are.
std::vector<Question> questions_of(const assess::Lesson& lesson, const assess::Result& computed);

} // namespace windlass::blind
