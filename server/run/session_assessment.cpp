// Session: the lesson as it goes on, and what is made of it.

#include "server/assess/bridge.hpp"
#include "server/run/briefing.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace windlass::run {

/// Takes the tick into the assessment, and gives what the lesson orders now.
void Session::assess() {
    if (!assessor_.assesses()) return;
    const bool was_over = assessor_.ended();
    const int asked = assessor_.state().asked;
    const bool misled = assessor_.state().misled_at >= 0;
    due_.clear();
    assessor_.fold(snapshot_, due_);
    for (const exercise::Order& order : due_)
        apply(order, kServerName);
    tell_hints();
    tell_unanswered(asked, misled);
    if (!due_.empty()) look(); // before a checkpoint is taken, which has these orders in it
    const auto second = static_cast<std::uint64_t>(def().tick_rate_hz);
    const bool just_over = assessor_.ended() && !was_over;
    if (just_over || (!was_over && snapshot_.tick % second == 0) || asks())
        new_assessment_ = assessor_.result();
    if (just_over)
        log("assessment.finished",
            fmt::format("lesson {} is over: {:.1f} points, {}", assessor_.lesson()->id,
                        0.1 * new_assessment_->tenths, assess::outcome_name(new_assessment_->outcome)),
            -1, 0.1 * new_assessment_->tenths);
    tell_when_the_lesson_is_over();
    hold_for_questions();
}

/// Those that were given at this tick, each to its seat.
void Session::tell_hints() {
    const assess::Lesson& lesson = *assessor_.lesson();
    for (std::size_t k = 0; k < lesson.hints.size(); ++k) {
        if (assessor_.state().hints[k] != static_cast<std::int64_t>(tick_)) continue;
        const assess::Hint& hint = lesson.hints[k];
        instructed_.at(hint.forecastle ? 0 : 1) = true;
        log(hint.forecastle ? words::EventCode("hint.forecastle") : words::EventCode("hint.bridge"), hint.say,
            hint.side);
    }
}

/// To those who have the truth: the bridge has asked, or was told what is not so, and how long it goes on; it
/// has heard what it wanted. Before: at the tick before.
void Session::tell_unanswered(int asked_before, bool misled_before) {
    const auto& now = assessor_.state();
    if (now.asked == 0 && asked_before > 0) log("assessment.answered", "the bridge has its answer");
    if (now.asked > asked_before || (now.misled_at >= 0 && !misled_before)) tell_when_the_bridge_gives_up();
}

/// Nothing where it has not had to ask.
void Session::tell_when_the_bridge_gives_up() {
    const int rate = def().tick_rate_hz;
    const std::int64_t at = assess::gives_up_at(*assessor_.lesson(), assessor_.state(), rate);
    if (at < 0) return;
    const double until = static_cast<double>(at) / rate;
    const bool misled = assessor_.state().misled_at >= 0;
    log(misled ? words::EventCode("assessment.misled") : words::EventCode("assessment.unanswered"),
        fmt::format("the bridge {}: if it hears nothing{} it gives up at {}, and the lesson ends",
                    misled ? "was told what is not so" : "asks again", misled ? " else" : "",
                    clock_text(until)),
        -1, until);
}

/// Once in a run, to the seats: its marks go out on topics of their own.
void Session::tell_when_the_lesson_is_over() {
    if (!assessor_.ended() || lesson_over_told_) return;
    lesson_over_told_ = true;
    log("lesson.over", lesson_over_text(*assessor_.lesson(), assessor_.state()));
    tell_aids();
}

bool Session::marks_are_told() const {
    return assessor_.assesses() && assessor_.ended() &&
           (!assessor_.lesson()->marks_when_confirmed || assessor_.state().confirmed);
}

/// An exercise that is ended ends its lesson. It is an order, so that a recording has it.
void Session::close_assessment(const std::string& reason) {
    if (!assessor_.assesses() || assessor_.ended()) return;
    apply(exercise::AssessorsWord{.criterion = {},
                                  .verdict = exercise::AssessorVerdict::ended,
                                  .milli = 0,
                                  .note = "exercise ended: " + reason,
                                  .by = kServerName},
          kServerName);
    new_assessment_ = assessor_.result();
    tell_when_the_lesson_is_over();
    tell_questions();
}

/// Whether there is something of that name to judge. The whole is, once the lesson is over: who has a word on
/// the marks ends nobody's lesson.
bool Session::judged(const exercise::AssessorsWord& word, const std::string& source) {
    if (!assessor_.assesses()) {
        refuse("AssessmentCommand", source, "criterion", '"' + word.criterion + '"',
               "none: this exercise has no lesson");
        return false;
    }
    if (word.criterion.empty()) {
        if (assessor_.ended() || over()) return true; // one that a fault has stopped never ends by itself
        refuse("AssessmentCommand", source, "criterion", "\"\"",
               "the code of a criterion: the whole is confirmed once the lesson is over");
        return false;
    }
    std::string known;
    for (const auto& criterion : assessor_.lesson()->criteria) {
        if (criterion.id == word.criterion) return true;
        known += (known.empty() ? "" : ", ") + criterion.id;
    }
    refuse("AssessmentCommand", source, "criterion", '"' + word.criterion + '"', "one of: " + known);
    return false;
}

} // namespace windlass::run
