#pragma once
// What an assessment comes to: points lost, objectives, strongest marks. Made of topic Assessment, whose
// points and marks the server has given; nothing is judged anew here.

#include "recorder/debrief/attempt.hpp"

namespace windlass::debrief {

/// A criterion with what it weighs.
struct Mark {
    const Criterion* criterion = nullptr;
    double points = 0;       ///< of 100, that it can give; 0: it was not in play
    double lost = 0;         ///< of them
    double time = 0;         ///< s of exercise at which it was decided; 0: not yet, or at the beginning
    std::uint32_t milli = 0; ///< that counts, 0..1000: the assessor's where he has spoken
    const AssessorWord* word = nullptr; ///< his last on this criterion; nullptr: the computed mark stands

    bool in_play() const;
};

/// Competence in one of the lesson's objectives.
struct Achievement {
    std::string id, text, stcw; ///< text and stcw as the lesson has them, empty where it is not attached
    std::string outcome;        ///< achieved, not_yet, not_shown; empty: not finished
    double score = 0;           ///< of 100, of its criteria in play
    double pass = 0;            ///< of 100
};

struct Judgement {
    std::vector<Mark> marks; ///< as the topic has them; criteria are the attempt's

    std::vector<Mark> deductions() const;        ///< points were lost, by time
    std::vector<Mark> strongest(int most) const; ///< full marks, the heaviest first
};

/// Empty where nothing was assessed. The attempt must outlive it.
Judgement judgement_of(const Attempt& attempt);

/// One for each objective that a criterion or the lesson names: achieved when every `must` in play is met and
/// the score reaches the lesson's `pass`; not shown when none of its criteria, or a `must`, came into play.
std::vector<Achievement> achievements_of(const Attempt& attempt);

/// What a criterion is called, and why it matters where that is said: "pay out: cable that runs lies in a
/// heap".
std::string title_of(const Criterion& criterion);

/// "achieved", "not yet", "not shown"; "not finished" where the assessment was still open.
std::string outcome_words(const std::string& outcome);

/// What kind of criterion, and how it stands, for people.
std::string_view words(CriterionKind kind);
std::string_view words(CriterionState state);
/// For machines: "limit", "not_met".
std::string_view name(CriterionKind kind);
std::string_view name(CriterionState state);

} // namespace windlass::debrief
