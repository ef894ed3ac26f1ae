#pragma once
// What a seat is asked at a freeze, and what its answer earns.

#include "server/assess/marks.hpp"

namespace windlass::assess {

/// Place of the question that waits for an answer of that seat, the first one; -1: none does.
int open_question(const Lesson& lesson, const State& state, bool of_forecastle);

/// Takes a tick. A question is asked once, and then the exercise holds: what is so now will judge the answer.
void look_at_question(const Criterion& criterion, Mark& mark, const Look& look);

/// Takes the answer to an open question.
void judge_answer(const Criterion& criterion, Mark& mark, const exercise::AnswerGiven& answer, State& state,
                  const Lesson& lesson);

} // namespace windlass::assess
