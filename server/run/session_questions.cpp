// Session: what a lesson asks a seat while the exercise holds.
//
// The exercise holds at the tick at which a question's cue comes true, with the levers and everything else as
// they are, until the seat has answered or an instructor goes on without. Where it was paused besides, by an
// instructor or a restore, it stays so: his start makes it wait for the answer again.

#include "common/figure_text.hpp"
#include "server/run/questions.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace windlass::run {

using exercise::AnswerKind;
using exercise::RunState;

namespace {

constexpr std::array<const char*, 2> kSeats{"forecastle", "bridge"};
constexpr std::array<const char*, 2> kTopics{"ForecastleAnswer", "BridgeAnswer"};

std::string answer_words(const exercise::AnswerGiven& answer, const assess::Question& question) {
    if (answer.kind == AnswerKind::number) return figure_text(answer.value, question.unit);
    if (answer.kind == AnswerKind::choice)
        return question.choices.at(static_cast<std::size_t>(answer.choice)).text;
    return "cannot tell";
}

} // namespace

QuestionView question_to(bool forecastle, const assess::Assessor& assessor) {
    QuestionView view{.forecastle = forecastle};
    const int open = assessor.open_question(forecastle);
    if (open < 0) return view;
    const assess::Lesson& lesson = *assessor.lesson();
    const assess::Question& question = lesson.questions[static_cast<std::size_t>(open)];
    view.id = lesson.criteria[static_cast<std::size_t>(question.criterion)].id;
    view.text = question.ask;
    view.unit = question.unit;
    view.step = question.step;
    for (const assess::Choice& choice : question.choices)
        view.choices.push_back({choice.text});
    view.meant_for = question.meant_for;
    return view;
}

bool Session::asks() const {
    return assessor_.open_question(true) >= 0 || assessor_.open_question(false) >= 0;
}

/// What each seat is asked now, where that has changed or the run has; for the publisher, and for the log of
/// those who have the truth.
void Session::tell_questions() {
    for (std::size_t seat = 0; seat < kSeats.size(); ++seat) {
        const bool forecastle = seat == 0;
        const int open = assessor_.open_question(forecastle);
        Asked& told = asked_.at(seat);
        if (open == told.question && (open < 0 || told.run == status_.run)) continue;
        told = {open, status_.run};
        status_.asked.at(seat) = open >= 0;
        QuestionView view = question_to(forecastle, assessor_);
        view.run = status_.run, view.tick = tick_, view.time = time_;
        if (open >= 0)
            log("question.asked", fmt::format("{} is asked ({}): {}", kSeats.at(seat), view.id, view.text));
        questions_.push_back(std::move(view));
    }
}

/// A question that has come up holds the exercise at this very tick.
void Session::hold_for_questions() {
    tell_questions();
    if (!running() || !asks()) return;
    status_.state = RunState::paused;
    held_ = true;
    log("exercise.held", "exercise holds for a question");
}

/// Once nobody is asked any more, what held for that goes on.
void Session::go_on_when_answered() {
    tell_questions();
    if (!held_ || asks()) return;
    held_ = false;
    if (status_.state != RunState::paused) return;
    status_.state = RunState::running;
    watch_for_a_hand();
    log("exercise.resumed", "exercise goes on");
}

/// The instructor goes on without an answer. It is an order, so that a recording has it.
void Session::pass_over_questions(const std::string& source) {
    for (const bool forecastle : {true, false})
        for (int open = assessor_.open_question(forecastle); open >= 0;
             open = assessor_.open_question(forecastle)) {
            const assess::Lesson& lesson = *assessor_.lesson();
            const int criterion = lesson.questions[static_cast<std::size_t>(open)].criterion;
            const std::string& id = lesson.criteria[static_cast<std::size_t>(criterion)].id;
            apply(exercise::AnswerGiven{.question = id, .kind = AnswerKind::passed_over}, kServerName);
            log("question.passed_over", fmt::format("{}: {} goes on without an answer", id, source));
        }
    new_assessment_ = assessor_.result();
    go_on_when_answered();
}

void Session::carry_out(const AnswerOrder& order, const ReceivedOrder& from) {
    const exercise::AnswerGiven& answer = order.answer;
    if (assess::is_aid(answer.question)) return carry_out_aid(order, from);
    const std::size_t seat = order.of_forecastle ? 0 : 1;
    const auto refused = [&](const char* field, std::string value, std::string allowed) {
        refuse(kTopics.at(seat), from.source, field, std::move(value), std::move(allowed));
    };
    const int open = assessor_.open_question(order.of_forecastle);
    if (open < 0)
        return refused("question", '"' + answer.question + '"',
                       fmt::format("none: the {} is not asked anything now", kSeats.at(seat)));
    const assess::Lesson& lesson = *assessor_.lesson();
    const assess::Question& question = lesson.questions[static_cast<std::size_t>(open)];
    const std::string& id = lesson.criteria[static_cast<std::size_t>(question.criterion)].id;
    if (answer.question != id)
        return refused("question", '"' + answer.question + '"', '"' + id + "\", which is asked now");
    const int choices = static_cast<int>(question.choices.size());
    if (answer.kind == AnswerKind::number && choices > 0)
        return refused("kind", "ANSWER_NUMBER",
                       "ANSWER_CHOICE or ANSWER_NOT_KNOWN: the question has choices");
    if (answer.kind == AnswerKind::choice && choices == 0)
        return refused("kind", "ANSWER_CHOICE",
                       "ANSWER_NUMBER or ANSWER_NOT_KNOWN: the question wants a number");
    if (answer.kind == AnswerKind::choice && answer.choice >= choices)
        return refused("choice", fmt::format("{}", answer.choice), fmt::format("0..{}", choices - 1));
    const std::string words = answer_words(answer, question);
    apply(answer, from.source);
    log("question.answered", fmt::format("{} answers ({}): {}", kSeats.at(seat), id, words), -1,
        answer.value);
    new_assessment_ = assessor_.result();
    go_on_when_answered();
}

} // namespace windlass::run
