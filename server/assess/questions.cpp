#include "server/assess/questions.hpp"

#include "server/assess/quantities.hpp"

#include <cmath>

namespace windlass::assess {

namespace {

bool allows(const Question& question, const exercise::AnswerGiven& answer) {
    if (answer.kind == exercise::AnswerKind::number) return question.choices.empty();
    if (answer.kind != exercise::AnswerKind::choice) return true;
    return answer.choice >= 0 && answer.choice < static_cast<int>(question.choices.size());
}

int earned_by(const exercise::AnswerGiven& answer, const Question& question, const QuestionCourse& course) {
    if (answer.kind == exercise::AnswerKind::choice)
        return (course.right >> answer.choice & 1) != 0 ? 1000 : 0;
    if (answer.kind != exercise::AnswerKind::number) return 0;
    const double apart = answer.value - course.truth;
    const double off = std::abs(question.period > 0 ? std::remainder(apart, question.period) : apart);
    return off <= question.tolerance ? 1000 : off <= 2 * question.tolerance ? 500 : 0;
}

} // namespace

int open_question(const Lesson& lesson, const State& state, bool of_forecastle) {
    for (std::size_t k = 0; k < lesson.questions.size(); ++k)
        if (state.questions[k].open && lesson.questions[k].forecastle == of_forecastle)
            return static_cast<int>(k);
    return -1;
}

void look_at_question(const Criterion& criterion, Mark& mark, const Look& look) {
    const auto place = static_cast<std::size_t>(criterion.question);
    const Question& question = look.lesson.questions[place];
    QuestionCourse& course = look.state.questions[place];
    if (course.asked >= 0) return;
    std::int64_t right = 0; // looked at at every tick: it may have to be so for a while
    for (std::size_t k = 0; k < question.choices.size(); ++k)
        if (look.holds(question.choices[k].right)) right |= std::int64_t{1} << k;
    if (mark.began < 0 && criterion.from && look.holds(*criterion.from)) {
        mark.began = look.tick();
        mark.state = CriterionState::open;
    }
    if (!look.holds(question.when)) return;
    course = {.asked = look.tick(), .open = true, .right = right};
    if (question.quantity >= 0)
        course.truth =
            figure(question.quantity, look.seen, *tackle_of(look.seen, criterion.side), look.state) /
            question.one;
    mark.began = look.tick();
    mark.state = CriterionState::open;
}

void judge_answer(const Criterion& criterion, Mark& mark, const exercise::AnswerGiven& answer, State& state,
                  const Lesson& lesson) {
    if (criterion.question < 0) return;
    const auto place = static_cast<std::size_t>(criterion.question);
    QuestionCourse& course = state.questions[place];
    const Question& question = lesson.questions[place];
    // What is none of its answers no session lets in, and a damaged recording may have.
    if (!course.open || !allows(question, answer)) return;
    course.open = false;
    course.answer = answer.kind, course.value = answer.value, course.choice = answer.choice;
    if (answer.kind == exercise::AnswerKind::passed_over)
        mark.state = CriterionState::not_in_play; // by an instructor, and nobody's loss
    else
        decide(mark, earned_by(answer, question, course), state.tick);
}

} // namespace windlass::assess
