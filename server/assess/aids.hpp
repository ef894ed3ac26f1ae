#pragma once
// What a seat may ask for in an attempt for practice, and what it is told then: the model's hands shown over
// its own levers, and a hint that was searched for.
//
// Each goes into the exercise as an answer (exercise::AnswerGiven) to a question that is open in practice all
// the while. So it has its tick, the rights of the seat that gives it, and its place in every recording.

#include "server/assess/lesson.hpp"
#include "server/assess/lever.hpp"
#include "server/assess/state.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace windlass::assess {

/// As in such questions: the forecastle's place is 0.
inline constexpr std::array<std::string_view, 2> kSeatNames{"forecastle", "bridge"};

/// What such an answer says. Its question is "practice/ghost/SEAT" (a choice: 1 on, 0 off),
/// "practice/hint/SEAT" (a choice), or of the server "practice/told/SEAT/..." and the lever's name (a number:
/// where it is to go; the choice: place of the criterion that it keeps), "nothing-lost", "none-known" (the
/// choice: of what is being lost) or "not-found".
struct AidWord {
    AidKind kind = AidKind::hint;
    bool forecastle = true;       ///< whose it is; false: the bridge's
    bool on = false;              ///< ghost
    std::optional<Lever> lever{}; ///< told: that is to be moved; nothing: there is none to be told
    double value = 0;             ///< told: where it is to go
    int criterion = -1;           ///< told: place in the lesson's; -1: none is lost
    bool found = true;            ///< told: false: there was no time to find out what is being lost
};

/// Whether an answer is none to a lesson's question, but to one of these.
bool is_aid(std::string_view question);
/// Nothing: it is no such answer, or one that says nothing that there is.
std::optional<AidWord> read_aid(const exercise::AnswerGiven& answer);
exercise::AnswerGiven write_aid(const AidWord& word);

/// Takes it into the attempt's record.
void take_aid(const Lesson& lesson, State& state, const AidWord& word);

/// Whether the trainee may have the model's hands shown beside his own.
bool may_have_ghost(const Lesson& lesson);

/// What the seat reads: "The port wheel hard on now."
std::string told_words(const AidWord& word, const Lesson& lesson);
/// The same of what the record has; of the ghost that it was shown.
std::string told_words(const AidTaken& aid, const Lesson& lesson);

/// Whether it helped: one that knows of no lever is no hint to be counted.
bool helps(const AidTaken& aid);

} // namespace windlass::assess
