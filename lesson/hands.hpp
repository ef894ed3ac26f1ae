#pragma once
// Hands that the author of a lesson did not write: the same generic conduct for any lesson, some of it as a
// captain would have it and some not, made of the lesson's own model run or of nothing.

#include "lesson/play.hpp"

#include "server/assess/lesson.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windlass::lesson {

/// What a lesson should make of a hand.
enum class Should {
    fail, ///< not achieved, and at most kWrongMost points
    pass, ///< achieved: what he did was right
    end   ///< right or wrong by the lesson; what counts is that it does not go silent on him
};

/// "fail", "pass", "end", as a lesson says it.
const char* should_name(Should should);

/// Points of 100 that wrong conduct gets at most, and that nothing done gets at most.
inline constexpr int kWrongMost = 50, kIdleMost = 5;

/// Of one generic hand.
struct HandRow {
    const char* name;  ///< as a lesson names it
    const char* about; ///< in words
    Should should;     ///< where the lesson says nothing else
};

/// Every generic hand, those first that take the least time to play.
std::span<const HandRow> hand_rows();

/// A hand at one lesson: parts are played side by side.
struct Hand {
    std::string name, about;
    Should should = Should::fail;
    std::vector<Part> parts;
};

/// Every generic hand that differs from the model run at this lesson: one that goes a shackle too far does
/// not where none is counted. They are hands on a forecastle: a lesson of the bridge, which is manned, has
/// the idle one alone. model: the scripts of its model run. A lesson may say itself what it should make of
/// one.
std::vector<Hand> hands(const assess::Lesson& lesson, const std::vector<trainee::Script>& model);

/// What is wrong with what a lesson made of a hand; empty: it is as it should be.
std::string fault_of(const Hand& hand, const Played& played);

} // namespace windlass::lesson
