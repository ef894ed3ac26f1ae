// What Checks asks of what is told: questions, events and alerts, each once and as it is.

#include "sim/checks.hpp"

#include "server/run/questions.hpp"
#include "words/words.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::sim {

namespace {

using exercise::RunState;
using run::AlertCondition;

constexpr std::array<const char*, 2> kSeats{"forecastle", "bridge"};

} // namespace

/// What a seat's question gets is an answer that it sent, or an instructor's start.
void Checks::look_at_answers(const run::Session& session, const run::Inbox& inbox) {
    for (const run::OrderView& order : session.orders()) {
        const auto* const given = std::get_if<exercise::AnswerGiven>(&order.command);
        if (given == nullptr) continue;
        const bool passed_over = given->kind == exercise::AnswerKind::passed_over;
        const bool sent = std::ranges::any_of(inbox.orders, [&](const run::ReceivedOrder& one) {
            if (passed_over) {
                const auto* const about_run = std::get_if<run::RunOrder>(&one.what);
                return about_run != nullptr && about_run->action == run::RunAction::start;
            }
            const auto* const answer = std::get_if<run::AnswerOrder>(&one.what);
            return answer != nullptr && one.source == order.source &&
                   answer->answer.question == given->question;
        });
        if (!sent)
            fail("questions",
                 passed_over ? "passed over as an instructor starts the exercise" : "an answer that was sent",
                 fmt::format("{} of {}", given->question, order.source));
        ++(passed_over ? counts_.passed_over : counts_.answered);
    }
}

/// What is asked is told once, as long as it is asked; the exercise holds for it, and goes on when it is
/// answered.
void Checks::look_at_questions(const run::Session& session, const run::Inbox& inbox) {
    std::ptrdiff_t told = 0;
    for (const run::QuestionView& question : session.questions()) {
        if (!question.id.empty() && std::exchange(sabotage_question, false)) continue;
        Asked& asked = asked_.at(question.forecastle ? 0 : 1);
        if (question.id == asked.id && (question.id.empty() || question.run == asked.run))
            fail("questions", fmt::format("\"{}\" is told once", question.id), "told again");
        asked = {question.id, question.run, question.tick};
        told += question.id.empty() ? 0 : 1;
    }
    counts_.questions += static_cast<std::uint64_t>(told);
    const auto logged =
        std::ranges::count(session.events(), std::string("question.asked"), &exercise::ExerciseEvent::code);
    if (logged != told) fail("questions", fmt::format("{} in the log", told), std::to_string(logged));
    bool asks = false;
    for (std::size_t seat = 0; seat < asked_.size(); ++seat) {
        const Asked& asked = asked_[seat];
        const std::string open = run::question_to(seat == 0, session.assessor()).id;
        if (open != asked.id || session.status().asked.at(seat) == open.empty())
            fail("questions", fmt::format("the {} is told that it is asked \"{}\"", kSeats[seat], open),
                 fmt::format("\"{}\"", asked.id));
        asks = asks || !open.empty();
        if (!open.empty() && (session.running() || tick_ != asked.tick))
            fail("questions", fmt::format("the exercise holds at tick {} for \"{}\"", asked.tick, open),
                 fmt::format("{} at tick {}", session.running() ? "runs" : "stands", tick_));
    }
    const bool others = std::ranges::any_of(inbox.orders, [](const run::ReceivedOrder& order) {
        return std::holds_alternative<run::RunOrder>(order.what) ||
               std::holds_alternative<run::StateOrder>(order.what);
    });
    if (!others && was_running_ && asks && !session.held())
        fail("questions", "the exercise goes on with the answer", "it stands until somebody starts it");
    if (!others && was_held_ && !asks && session.status().state == RunState::paused)
        fail("questions", "the exercise goes on, as it is answered", "it stands");
    was_running_ = session.running(), was_held_ = session.held();
}

/// A question that stood when the server was lost is asked again by the next one.
void Checks::hold_questions_again(const run::Session& session) {
    if (!line().assessor) return; // it was not seen as it began
    for (const bool forecastle : {true, false}) {
        const std::string open = run::question_to(forecastle, undisturbed_->course.assessor()).id;
        std::string told;
        for (const run::QuestionView& question : session.questions())
            if (question.forecastle == forecastle) told = question.id;
        if (told != open)
            fail("questions",
                 fmt::format("the {} is asked \"{}\" again", kSeats.at(forecastle ? 0 : 1), open),
                 fmt::format("\"{}\"", told));
        counts_.stood_again += open.empty() ? 0 : 1;
    }
}

void Checks::look_at_events(const run::Session& session) {
    for (const auto& event : session.events()) {
        const bool anew = event.number == 1 && event.tick == 0; // set up
        if (event.number != event_ + 1 && !anew)
            fail("events", fmt::format("event {} once, behind event {}", event_ + 1, event_),
                 fmt::format("event {}, {}", event.number, event.code));
        event_ = event.number;
        add(event.tick), add(event.code), add(event.text);
        if (event.code != "levers.lost") continue;
        const int group = event.side < 0 ? static_cast<int>(run::LeverGroup::helm) : event.side;
        const Levers& levers = levers_.at(static_cast<std::size_t>(group));
        if (!has_left(levers) && listened_ - levers.heard < kHandSilent)
            fail("levers", "a hand that is heard has what it holds", event.text);
    }
}

void Checks::look_at_alerts(const run::Session& session, const std::string& trouble) {
    using enum AlertCondition;
    const auto condition = [&](const std::string& code, int side) {
        const auto known = alerts_.find({code, side});
        return known == alerts_.end() ? normal : known->second;
    };
    const auto active = [&](const std::string& code, int side) {
        const auto now = condition(code, side);
        return now == active_unacknowledged || now == active_silenced || now == active_acknowledged;
    };
    for (const run::AlertView& alert : session.alerts()) {
        const AlertCondition was = condition(alert.code, alert.side);
        const auto from = [&](std::initializer_list<AlertCondition> allowed) {
            return std::ranges::find(allowed, was) != allowed.end();
        };
        const bool may = alert.condition == active_unacknowledged
                             ? from({normal, rectified_unacknowledged, active_silenced})
                         : alert.condition == active_silenced ? from({active_unacknowledged})
                         : alert.condition == active_acknowledged
                             ? from({active_unacknowledged, active_silenced})
                         : alert.condition == rectified_unacknowledged
                             ? from({active_unacknowledged, active_silenced})
                             : from({active_acknowledged, rectified_unacknowledged});
        double& raised = raised_[{alert.code, alert.side}];
        // One that was raised later is of a course that was gone back before, and is told anew.
        const bool anew = alert.condition == active_unacknowledged && raised > alert.time;
        raised = alert.raised_time;
        if (!may && !anew)
            fail("alerts", fmt::format("{} of side {} is told once", alert.code, alert.side),
                 fmt::format("condition {} again, after {}", static_cast<int>(alert.condition),
                             static_cast<int>(was)));
        alerts_[{alert.code, alert.side}] = alert.condition;
        add(alert.tick), add(alert.code), add(static_cast<std::uint64_t>(alert.condition));
    }
    const auto must = [&](const char* code, int side, bool there) {
        if (active(code, side) != there)
            fail("alerts", fmt::format("{} of side {}: {}", code, side, there ? "active" : "not active"),
                 fmt::format("condition {}", static_cast<int>(condition(code, side))));
    };
    must("exercise.not_kept", -1, !trouble.empty());
    if (!session.running() || !session.seen()) return;
    const exercise::Snapshot& seen = session.snapshot();
    must("watch.circle", -1, seen.outside_watch_circle);
    must("model.in_doubt", -1, seen.model_in_doubt);
    for (const auto& tackle : seen.tackle) {
        const int side = static_cast<int>(tackle.side);
        if (!tackle.windlass.tripped) must("motor.trip", side, false);
        if (tackle.windlass.cable_speed > words::limits::cable_runaway ||
            tackle.windlass.cable_speed < words::limits::cable_fast)
            must("cable.runaway", side, tackle.windlass.cable_speed > words::limits::cable_runaway);
    }
}

} // namespace windlass::sim
