#pragma once
// What an assessment comes to: points lost, objectives, strongest marks. Made of topic Assessment, whose
// points and marks the server has given; nothing is judged anew here.

#include "recorder/debrief/attempt.hpp"

#include <optional>

namespace windlass::debrief {

/// A criterion with what it weighs.
struct Mark {
    const Criterion* criterion = nullptr;
    double points = 0; ///< of 100, that it can give; 0: it was not in play
    double lost = 0;   ///< of them
    double time = 0;   ///< s of exercise at which it first went wrong, else was decided; 0: neither
    const AssessorWord* word = nullptr; ///< the assessor's last on this criterion; nullptr: he has said none
};

/// Competence in one of the lesson's objectives.
struct Achievement {
    std::string id, text, stcw;
    std::string outcome; ///< achieved, not_yet, not_shown; empty: not finished
    double score = 0;    ///< of 100, of its criteria in play
    double pass = 0;     ///< of 100
};

struct Judgement {
    std::vector<Mark> marks; ///< as the topic has them; criteria are the attempt's

    std::vector<Mark> deductions() const;        ///< points were lost, by time
    std::vector<Mark> strongest(int most) const; ///< deeds with full marks, the heaviest first
};

/// How the score comes of what each criterion lost, by the rule of server/assess/result.cpp.
struct Reckoning {
    double lost = 0;     ///< of 100 points, by the criteria
    double done = 1;     ///< 0..1, of what was to be done: in that measure what only guards counts
    double unearned = 0; ///< of 100 points, lost by that
    bool halved = false; ///< what is left is halved
};
/// Nothing where it does not come to the score that the server has given.
std::optional<Reckoning> reckoning_of(const Attempt& attempt, const Judgement& judgement);
/// What of it halved the points: "a criterion marked (must) was missed", "the bridge was told what is not so
/// when it asked ...".
std::vector<std::string> why_halved(const Attempt& attempt);

/// Empty where nothing was assessed. The attempt must outlive it.
Judgement judgement_of(const Attempt& attempt);

/// Where it went wrong, to go back to: the first must that was missed, without one the first loss of points.
/// What is decided only because the time was up, or the exercise was ended, went wrong at no moment. Nothing:
/// no moment is.
std::optional<Mark> went_wrong(const Attempt& attempt, const Judgement& judgement);

/// The lesson's objectives, as the server has judged them.
std::vector<Achievement> achievements_of(const Attempt& attempt);

/// "for practice, 2 hints"; empty: it was a test, or nothing was assessed.
std::string practice_words(const Attempt& attempt);

/// Whether a hint was given on that criterion.
bool was_hinted(const Attempt& attempt, const Criterion& criterion);

/// Whether a limit ever came into play: what was never looked at has no worst.
bool was_looked_at(const Criterion& limit);

/// What a criterion is called: "pay out".
std::string name_of(const Criterion& criterion);

/// The same, and why it matters where that is said: "pay out: cable that runs lies in a heap".
std::string title_of(const Criterion& criterion);

/// "achieved", "not yet", "not shown"; "not finished" where the assessment was still open.
std::string outcome_words(const std::string& outcome);

} // namespace windlass::debrief
