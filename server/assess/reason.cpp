// Reasons in words, made of the figures that the fold has kept: what was wanted, what was so, and when.

#include "common/figure_text.hpp"
#include "common/text.hpp"
#include "server/assess/marks.hpp"
#include "server/assess/order_done.hpp"
#include "server/assess/quantities.hpp"
#include "server/assess/quantity_words.hpp"
#include "server/assess/result.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace windlass::assess {

namespace {

constexpr std::size_t kMostBytes = 200; // so that the points lost stand within the wire's bound
constexpr std::size_t kOnWire = 256;    // bytes of Criterion.reason
constexpr const char* kCut = " ...";

std::string clock(std::int64_t ticks, int tick_rate) {
    const std::int64_t seconds = ticks / tick_rate;
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%lld:%02lld", static_cast<long long>(seconds / 60),
                  static_cast<long long>(seconds % 60));
    return text.data();
}

/// "12.3", "150".
std::string tenths(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.1f", value);
    const std::string_view all = text.data();
    return std::string(all.ends_with(".0") ? all.substr(0, all.size() - 2) : all);
}

std::string seconds(std::int64_t ticks, int tick_rate) {
    return tenths(static_cast<double>(ticks) / tick_rate) + " s";
}

/// Of what came too late: rounded up, so that it never reads as if it had been in time.
std::string late_seconds(std::int64_t ticks, int tick_rate) {
    return tenths(std::ceil(10.0 * static_cast<double>(ticks) / tick_rate - 1e-6) / 10) + " s";
}

std::string number(double value) {
    return figure_text(value, "");
}

void join(std::string& text, const char* between, const std::string& more) {
    if (more.empty()) return;
    text += (text.empty() ? "" : between) + more;
}

/// The clauses that stand whole within the first so many bytes.
std::string whole_clauses(std::string_view text, std::size_t bytes) {
    const std::string_view first = clipped(text, bytes);
    const std::size_t end =
        std::max(first.rfind(", ") + 1, std::max(first.rfind(". ") + 1, first.rfind("; ") + 1));
    return std::string(end == 0 ? first : first.substr(0, end - 1));
}

std::string spaced(std::string_view code) {
    std::string text(code);
    std::ranges::replace_if(
        text, [](char c) { return c == '_' || c == '.' || c == '-'; }, ' ');
    return text;
}

std::string phases_words(unsigned phases) {
    std::string text;
    for (std::size_t k = 0; k < words::kAnchorPhaseNames.size(); ++k)
        if ((phases >> k & 1U) != 0) join(text, " or ", spaced(words::kAnchorPhaseNames.at(k)));
    return "anchor " + text;
}

std::string order_of(const Lesson& lesson, std::size_t order) {
    const exercise::BridgeOrderGiven& given = lesson.orders[order].given;
    const std::string words = exercise::order_words(given.code, given.side, given.value);
    return '"' + (words.empty() ? given.text : words) + '"';
}

/// " (port)", where there are two windlasses that it could be about.
std::string of_side(const Lesson& lesson, int side) {
    if (!lesson.two_sides) return "";
    return side == 1 ? " (starboard)" : " (port)";
}

std::string sign_words(const Lesson& lesson, const Sign& sign) {
    const auto k = static_cast<std::size_t>(sign.index);
    switch (sign.kind) {
    case SignKind::event:
        return spaced(lesson.events[k].code) + of_side(lesson, lesson.events[k].side);
    case SignKind::report:
        return "reported: " +
               spaced(words::kReportNames.at(static_cast<std::size_t>(lesson.reports[k].code))) +
               of_side(lesson, lesson.reports[k].side);
    case SignKind::moment:
        return '"' + spaced(lesson.moments[k].id) + '"';
    case SignKind::order_given:
        return order_of(lesson, k) + " given";
    case SignKind::order_repeated:
        return order_of(lesson, k) + " repeated back";
    case SignKind::order_answered:
        return order_of(lesson, k) + " reported carried out";
    case SignKind::order_done:
        return order_of(lesson, k) + " carried out";
    case SignKind::order_challenged:
        return order_of(lesson, k) + " called unsafe, and taken back";
    }
    return "";
}

/// A condition as it is wanted.
std::string condition_words(const Lesson& lesson, const Condition& condition) {
    std::string text;
    for (const Bounds& bounds : condition.bounds)
        join(text, ", ", bounds_words(bounds));
    if (condition.phases != 0) join(text, ", ", phases_words(condition.phases));
    for (const Sign& sign : condition.signs)
        join(text, ", ", sign_words(lesson, sign));
    std::string any;
    for (const Condition& one : condition.either)
        join(any, " or ", condition_words(lesson, one));
    join(text, ", ", any);
    for (const Condition& one : condition.neither)
        join(text, ", ", "not " + condition_words(lesson, one));
    if (condition.hold > 0) join(text, ", ", "for " + number(condition.hold) + " s");
    return text;
}

/// What the part of a condition was that did not hold (missing_part()), by its name: "cable out from
/// the lip was 3.6 shackles", "stopper open".
std::string found_words(const Lesson& lesson, const Condition& condition, int part, double value) {
    const auto place = static_cast<std::size_t>(std::max(part, 0)), bounded = condition.bounds.size();
    if (place < bounded) return found_words(quantity_at(condition.bounds[place].quantity), value);
    if (place == bounded) {
        const auto phase =
            static_cast<std::size_t>(std::clamp(value, 0.0, words::kAnchorPhaseNames.size() - 1.0));
        return "anchor was " + spaced(words::kAnchorPhaseNames.at(phase));
    }
    const std::size_t signs = bounded + 1 + condition.signs.size();
    if (place < signs) return "not yet " + sign_words(lesson, condition.signs[place - bounded - 1]);
    if (place == signs + kEitherMissing) return "none of them was so";
    if (place == signs + kNeitherHolds) return "one was so of what must not be";
    return "not for long enough";
}

/// Of a condition that did not hold first what was not so, and then what was wanted: a list of wants may be
/// cut. part: -1: nobody looked, since the lesson was over.
std::string missed_words(const Lesson& lesson, const Condition& condition, int part, double value) {
    const std::string wanted = condition_words(lesson, condition);
    if (part < 0) return "it was not so; wanted: " + wanted;
    const std::size_t others = condition.bounds.size() + (condition.phases != 0 ? 1 : 0) +
                               condition.either.size() + condition.neither.size();
    const bool is_one_sign = condition.signs.size() == 1 && others == 0 && condition.hold <= 0;
    const std::string found = found_words(lesson, condition, part, value);
    return is_one_sign ? found : found + "; wanted: " + wanted; // the sign is all that was wanted
}

/// What is lost for good: of one that is open only what no hand can make good any more. As a share: what its
/// points are of 100 is told beside it, and depends on what else came into play.
std::string lost(const Criterion& criterion, const Mark& mark, bool over) {
    const bool falls = criterion.kind == CriterionKind::limit || criterion.kind == CriterionKind::state_at;
    if (mark.milli == 1000 || (mark.decided < 0 && !over && !falls)) return "";
    if (mark.milli == 0) return "all of its points lost";
    return tenths((1000 - mark.milli) / 10.0) + " % of its points lost";
}

std::string limit_words(const Criterion& criterion, const Mark& mark, int rate) {
    const Quantity& quantity = quantity_at(criterion.quantity);
    const std::string unit = quantity.unit;
    if (mark.worst_tick < 0) return "";
    std::string text =
        clock(mark.worst_tick, rate) + " " + short_name(quantity) + " " + figure_text(mark.worst, unit);
    if (criterion.min > -kNoLimit) text += ", at least " + figure_text(criterion.min, unit);
    if (criterion.max < kNoLimit) text += ", at most " + figure_text(criterion.max, unit);
    if (mark.outside > 0) {
        text += "; beyond it for " + seconds(mark.outside, rate) + " in all, from " + clock(mark.since, rate);
        if (criterion.grace > 0) text += ", " + number(criterion.grace) + " s are allowed";
    }
    if (mark.wrong > 0) {
        const bool above = mark.worst > criterion.fail_above;
        // Named again: pages show a speed in the unit of whose it is, and look for that in the same clause.
        text += "; " + short_name(quantity) + (above ? " above " : " below ") +
                figure_text(above ? criterion.fail_above : criterion.fail_below, unit) + " leaves nothing";
    } else if (mark.milli == 0 && mark.outside < std::llround(criterion.zero * rate)) {
        text += "; still so at the end leaves nothing"; // its seconds alone would have left some
    }
    return text;
}

std::string sequence_words(const Lesson& lesson, const Criterion& criterion, const Mark& mark, int rate) {
    if (mark.began < 0) return "";
    const std::size_t all = criterion.steps.size();
    const std::string steps = std::to_string(mark.step) + " of " + std::to_string(all) + " steps";
    const auto step = [&](int k) {
        const auto place = static_cast<std::size_t>(k);
        return place < all ? condition_words(lesson, criterion.steps[place]) : "";
    };
    if (mark.wrong > 0)
        return clock(mark.worst_tick, rate) + " step " + std::to_string(mark.wrong) + " (" +
               step(mark.wrong - 1) + ") before step " + std::to_string(mark.step + 1) + " (" +
               step(mark.step) + ")";
    if (mark.decided < 0) return steps;
    const std::int64_t took = mark.decided - mark.began;
    std::string text = clock(mark.decided, rate) + " " +
                       (all > 1          ? steps // one step has no course that could be told
                        : mark.step == 1 ? "it was so: " + step(0)
                                         : "it was not so");
    if (took > 0) text += " in " + seconds(took, rate);
    if (const std::string next = step(mark.step); !next.empty()) {
        text += "; wanted: " + next;
        if (criterion.within < kNoLimit)
            text += (all > 1 ? ", all within " : ", within ") + number(criterion.within) + " s";
    }
    return text;
}

/// How late a state came to be so that was wanted sooner, which is why points are lost.
std::string how_late(const Lesson& lesson, const Criterion& criterion, const Mark& mark, int rate) {
    const std::string moment = spaced(lesson.moments[static_cast<std::size_t>(criterion.at)].id);
    return " " + late_seconds(mark.decided - mark.began, rate) + " after \"" + moment + "\", wanted " +
           (criterion.after > 0 ? "within " + number(criterion.after) + " s" : "at once");
}

std::string state_words(const Lesson& lesson, const Criterion& criterion, const Mark& mark, int rate) {
    if (mark.decided < 0) return "";
    const std::string at = clock(mark.decided, rate) + " ";
    const bool too_late =
        criterion.graded && mark.milli == 0 && mark.missing < 0; // so, when nothing was left
    if (mark.milli == 0 && !too_late)
        return at + missed_words(lesson, criterion.that, mark.missing, mark.worst);
    return at + "wanted: " + condition_words(lesson, criterion.that) + "; it was so" +
           (criterion.graded && mark.milli < 1000 ? how_late(lesson, criterion, mark, rate) : "");
}

/// Until when an order was not carried out: for as long as he had, where so much had passed before the bridge
/// ordered the next thing, or the lesson was over.
std::string not_done_until(const Lesson& lesson, const State& state, std::size_t k, int rate) {
    const OrderCourse& course = state.orders[k];
    if (course.do_by < 0) return "";
    for (std::size_t next = k + 1; next < state.orders.size(); ++next) {
        const OrderCourse& other = state.orders[next];
        const exercise::BridgeOrderGiven& given = lesson.orders[next].given;
        const bool is_next = other.given > course.given && !is_question(given.code) &&
                             given.code != exercise::BridgeOrderCode::text &&
                             given.side == lesson.orders[k].given.side;
        if (is_next && other.given < course.do_by)
            return " before the bridge ordered " + order_of(lesson, next) + " at " + clock(other.given, rate);
    }
    if (state.ended < course.do_by) return " before the lesson ended at " + clock(state.ended, rate);
    return " within " + seconds(course.do_by - course.given, rate);
}

/// What was wrong with how one order went; empty: nothing.
std::string order_faults(const Lesson& lesson, const State& state, std::size_t k, int rate) {
    const LessonOrder& order = lesson.orders[k];
    const OrderCourse& course = state.orders[k];
    const bool over = state.ending != Ending::none;
    std::string text;
    const double repeat = repeat_within(order.given);
    if (course.misrepeated) text = "repeated back wrongly";
    if (repeat > 0 && course.repeated < 0 && over)
        join(text, ", and then ",
             "not repeated back " + (state.ended - course.given < std::llround(repeat * rate)
                                         ? "before the lesson ended at " + clock(state.ended, rate)
                                         : "within " + number(repeat) + " s"));
    if (course.repeated >= 0 && !course.in_time)
        join(text, ", and then ",
             "repeated back after " + late_seconds(course.repeated - course.given, rate) +
                 ", wanted within " + number(repeat) + " s");
    const std::string within =
        course.do_by < 0 ? "" : " within " + seconds(course.do_by - course.given, rate);
    if (course.done >= 0) {
        const bool late = course.do_by >= 0 && course.done > course.do_by;
        if (course.was_so && course.repeated < 0 && course.answered < 0)
            join(text, "; ", "it was so already when it was given, and nothing was said to it");
        else if (late || !text.empty())
            join(text, ", ",
                 course.done <= course.given
                     ? "it was so already"
                     : "carried out after " + late_seconds(course.done - course.given, rate) +
                           (late ? ", wanted" + within : ""));
    } else if (over) {
        join(text, ", ", "not carried out");
        const std::array sides{"port", "starboard"};
        std::string by; // whom, where each of two was to do it
        for (std::size_t one = 0; order.done.size() > 1 && one < order.done.size(); ++one)
            if (course.each_done.at(one) < 0)
                join(by, " or ", sides.at(static_cast<std::size_t>(order.done[one].side)));
        if (!by.empty()) text += " by " + by;
        text += not_done_until(lesson, state, k, rate);
    }
    return text;
}

std::string order_words(const Lesson& lesson, const State& state, const Criterion& criterion, int rate) {
    std::string text;
    int given = 0;
    const bool over = state.ending != Ending::none;
    for (const int order : criterion.orders) {
        const auto k = static_cast<std::size_t>(order);
        const OrderCourse& course = state.orders[k];
        if (left_out_falsely(course))
            join(text, ". ",
                 clock(course.done, rate) + " " + order_of(lesson, k) +
                     " not given, since more cable was reported than was out");
        if (course.given < 0 || course.challenged >= 0) continue;
        ++given;
        const std::string faults = order_faults(lesson, state, k, rate);
        if (!faults.empty())
            join(text, ". ", clock(course.given, rate) + " " + order_of(lesson, k) + " " + faults);
    }
    if (text.empty() && given > 0 && over)
        text = given == 1 ? "the order was carried out in time"
                          : "each of " + std::to_string(given) + " orders was carried out in time";
    return text;
}

/// How the cable leads, in the hours of the clock and by its stay.
std::string lead_words(double clock_hour, double top_angle) {
    return "it led " + figure_text(clock_hour, "h") + ", " +
           std::string(words::kStay.at(words::stay_at(top_angle)).said);
}

/// How the tackle was, where that is the whole of what a report of something that happens tells.
std::string shown_words(exercise::ReportCode code, const JudgedReport& report) {
    using exercise::ReportCode;
    switch (code) {
    case ReportCode::let_go:
    case ReportCode::on_the_bottom:
    case ReportCode::brought_up:
    case ReportCode::anchor_aweigh:
    case ReportCode::clear_anchor:
    case ReportCode::foul_anchor:
    case ReportCode::anchor_home:
    case ReportCode::dragging: {
        const double last = words::kAnchorPhase.size() - 1.0;
        const auto phase = static_cast<std::size_t>(std::clamp(report.truth, 0.0, last));
        return "anchor " + std::string(words::kAnchorPhase.at(phase).said);
    }
    case ReportCode::short_stay:
    case ReportCode::up_and_down:
        return lead_words(report.truth, report.top_angle);
    case ReportCode::no_power:
        return report.truth > 0 ? "motor had power" : "motor had none";
    case ReportCode::does_not_run:
        return "cable " + figure_text(report.truth, "m/s");
    default:
        return "";
    }
}

/// What was reported.
std::string said_words(const Criterion& criterion, const JudgedReport& report) {
    const bool other = report.code != exercise::ReportCode::text; // shackles, and in another place
    words::ReportSaid said{.code = static_cast<std::size_t>(other ? report.code : criterion.report),
                           .side = criterion.side};
    if (criterion.truth == ReportTruth::growth) said.growing = static_cast<std::size_t>(report.growing);
    if (criterion.truth != ReportTruth::figure) return words::report_text(said);
    if (criterion.report == exercise::ReportCode::lead) {
        said.lead = static_cast<int>(report.said);
        said.stay = static_cast<std::size_t>(report.stay);
    } else if (criterion.report == exercise::ReportCode::weight) {
        said.weight = static_cast<std::size_t>(report.said + 1); // -1: not given
    } else {
        said.value = report.said;
    }
    return words::report_text(said);
}

/// From where shackles are counted: what is a figure on deck is another in the water, and on the counter.
std::string where_counted(const Criterion& criterion, const JudgedReport& report) {
    const bool other = report.code != exercise::ReportCode::text;
    switch (words::row_of(other ? report.code : criterion.report).mark_at) {
    case words::MarkAt::deck:
        return " on deck";
    case words::MarkAt::pipe:
        return " in the pipe";
    case words::MarkAt::water:
        return " in the water";
    case words::MarkAt::none:
        break;
    }
    return "";
}

/// The reports of a criterion as they were judged, each as `words` has it.
template <class Words>
std::string each_report(const State& state, std::size_t criterion, int rate, const Words& words) {
    std::string text;
    for (const JudgedReport& report : state.judged)
        if (report.criterion == static_cast<int>(criterion))
            join(text, ". ", clock(report.tick, rate) + " " + words(report));
    return text;
}

/// What was so when a report came, with what came to be so after it.
std::string truth_by_now(const Lesson& lesson, const State& state, const JudgedReport& report, int rate) {
    const Criterion& criterion = lesson.criteria[static_cast<std::size_t>(report.criterion)];
    if (criterion.truth != ReportTruth::moment || report.so >= 0)
        return truth_words(lesson, criterion, report, rate);
    const std::int64_t so = state.moments[static_cast<std::size_t>(criterion.truth_moment)].first;
    if (so > report.tick) return "and it was not so until " + clock(so, rate);
    return state.ending != Ending::none && so < 0 ? "and it never was so"
                                                  : truth_words(lesson, criterion, report, rate);
}

std::string report_words(const Lesson& lesson, const State& state, std::size_t k, int rate) {
    const Criterion& criterion = lesson.criteria[k];
    const Mark& mark = state.marks[k];
    const std::string code = spaced(words::kReportNames.at(static_cast<std::size_t>(criterion.report)));
    const std::string reports = each_report(state, k, rate, [&](const JudgedReport& report) {
        return "\"" + said_words(criterion, report) + "\" reported, " +
               truth_by_now(lesson, state, report, rate);
    });
    if (criterion.truth == ReportTruth::moment) {
        if (mark.began < 0) return reports;
        const auto& moment = lesson.moments[static_cast<std::size_t>(criterion.truth_moment)];
        std::string wanted = clock(mark.began, rate) + " " + condition_words(lesson, moment.when) + ": \"" +
                             code + "\" wanted within " + number(criterion.full) + " s";
        if (mark.decided < 0 || !reports.empty()) {
            join(wanted, ". ", reports);
            return wanted;
        }
        return wanted + ", not reported";
    }
    std::string text = reports;
    if (!criterion.orders.empty()) {
        // First, since a long list of reports is cut.
        const int wanted = std::max(mark.step, 1);
        const auto made = std::ranges::count(state.judged, static_cast<int>(k), &JudgedReport::criterion);
        if (made < wanted) {
            text = "One wanted to " +
                   (wanted > 1 ? "each of " + std::to_string(wanted) + " orders" : "the order") + ", " +
                   (made == 0 ? "none" : std::to_string(wanted - made) + " not") + " made";
            join(text, ". ", reports);
        }
    } else if (criterion.count > 1) {
        join(text, ". ",
             (reports.empty() ? '"' + code + "\": " : "") + std::to_string(mark.step) + " of " +
                 std::to_string(criterion.count) + " reports made");
    } else if (reports.empty() && mark.state != CriterionState::not_in_play) {
        text = (criterion.truth == ReportTruth::state && mark.since >= 0
                    ? clock(mark.since, rate) + " it was so: "
                    : "") +
               "\"" + code + "\" wanted, not reported" + (mark.decided < 0 ? " yet" : "");
        if (criterion.truth == ReportTruth::state && mark.outside > 0)
            text += " then; said at " + clock(mark.outside, rate) + ", before it was asked for";
    }
    return text;
}

std::string final_words(const Lesson& lesson, const Criterion& criterion, const Mark& mark, int rate) {
    if (mark.decided < 0) return "";
    const std::string at = clock(mark.decided, rate) + " ", since = " since " + clock(mark.since, rate);
    if (mark.milli > 0)
        return at + "wanted at the end: " + condition_words(lesson, criterion.that) + "; it was so," + since;
    return at + "at the end " + (mark.held ? "not so" + since + ": " : "") +
           missed_words(lesson, criterion.that, mark.missing, mark.worst);
}

std::string prohibited_words(const Lesson& lesson, const Criterion& criterion, const Mark& mark, int rate) {
    if (mark.began < 0) return "";
    const std::string never = condition_words(lesson, criterion.that);
    if (mark.state == CriterionState::not_met)
        return clock(mark.decided, rate) + " it was so, and must not be: " + never;
    return mark.decided < 0 ? "" : "it never was so, and must not be: " + never;
}

/// What was asked, what was answered and what was so.
std::string question_words(const Lesson& lesson, const State& state, const Criterion& criterion,
                           const Mark& mark, int rate) {
    const auto place = static_cast<std::size_t>(criterion.question);
    const Question& question = lesson.questions[place];
    const QuestionCourse& course = state.questions[place];
    if (course.asked < 0) {
        if (mark.state == CriterionState::not_in_play) return "";
        Condition cue = question.when; // what he was to bring about; that its signs came is known
        cue.signs.clear();
        return clock(mark.began, rate) + (mark.decided < 0 ? " not asked yet" : " never asked") +
               ", since it was not so: " + condition_words(lesson, cue);
    }
    const auto said = [&](int choice) {
        return '"' + question.choices[static_cast<std::size_t>(choice)].text + '"';
    };
    const auto figure = [&](double value) { return figure_text(value, question.unit); };
    std::string so;
    for (std::size_t k = 0; k < question.choices.size(); ++k)
        if ((course.right >> k & 1) != 0) join(so, " or ", said(static_cast<int>(k)));
    if (question.quantity >= 0)
        so = figure(course.truth);
    else if (so.empty())
        so = "none of the answers";
    std::string text = clock(course.asked, rate) + " asked at a freeze: ";
    if (course.open) return text + "not answered yet; right: " + so;
    switch (course.answer) {
    case exercise::AnswerKind::number:
        text += figure(course.value);
        break;
    case exercise::AnswerKind::choice:
        text += said(course.choice);
        break;
    case exercise::AnswerKind::not_known:
        text += "he could not tell";
        break;
    case exercise::AnswerKind::passed_over:
        text += "not answered";
        break;
    }
    text += "; right: " + so;
    // Of the clock it is a span of hours, and no hour.
    if (question.quantity >= 0)
        text += ", within " +
                (question.unit == "h" ? number(question.tolerance) + " h" : figure(question.tolerance));
    return text;
}

} // namespace

std::string truth_words(const Lesson& lesson, const Criterion& criterion, const JudgedReport& report,
                        int tick_rate) {
    switch (criterion.truth) {
    case ReportTruth::moment: {
        if (report.so < 0) { // it may have come to be so since
            const std::string shown = shown_words(criterion.report, report);
            return "and it was not so then" + (shown.empty() ? "" : ": " + shown);
        }
        const std::int64_t after = report.tick - report.so;
        return seconds(std::abs(after), tick_rate) + (after < 0 ? " before" : " after") + " it was so, at " +
               clock(report.so, tick_rate);
    }
    case ReportTruth::state:
        return report.milli > 0 ? "and it was so"
                                : "but " + found_words(lesson, criterion.that, report.missing, report.truth);
    case ReportTruth::growth:
        return report.milli > 0 ? "and it was so" : "and it was not so";
    case ReportTruth::figure:
        break;
    }
    switch (criterion.report) {
    case exercise::ReportCode::lead:
        return lead_words(report.truth, report.top_angle);
    case exercise::ReportCode::weight:
        return std::string(
                   words::kCableWeight.at(static_cast<std::size_t>(std::clamp(report.truth, 0.0, 3.0)) + 1)
                       .said) +
               " was on it";
    default:
        if (report.truth < 0) // the anchor shackle itself has not come to where they are counted
            return where_counted(criterion, report) == " in the water" ? "the anchor was above the water"
                                                                       : "the anchor was home";
        return shackles_figure(report.truth) + where_counted(criterion, report) + " were so";
    }
}

std::string reason(const Lesson& lesson, const State& state, std::size_t k, int tick_rate) {
    const Criterion& criterion = lesson.criteria[k];
    const Mark& mark = state.marks[k];
    std::string text;
    switch (criterion.kind) {
    case CriterionKind::limit:
        text = limit_words(criterion, mark, tick_rate);
        break;
    case CriterionKind::sequence:
        text = sequence_words(lesson, criterion, mark, tick_rate);
        break;
    case CriterionKind::state_at:
        text = state_words(lesson, criterion, mark, tick_rate);
        break;
    case CriterionKind::order:
        text = order_words(lesson, state, criterion, tick_rate);
        break;
    case CriterionKind::report:
        text = report_words(lesson, state, k, tick_rate);
        break;
    case CriterionKind::prohibited:
        text = prohibited_words(lesson, criterion, mark, tick_rate);
        break;
    case CriterionKind::final:
        text = final_words(lesson, criterion, mark, tick_rate);
        break;
    case CriterionKind::question:
        text = question_words(lesson, state, criterion, mark, tick_rate);
        break;
    case CriterionKind::rubric:
        break;
    }
    if (text.size() > kMostBytes) text = whole_clauses(text, kMostBytes) + kCut;
    const bool left_out = was_left_out(lesson, state, k);
    if (left_out) text = "it never came to that";
    const bool judged = left_out || mark.state != CriterionState::not_in_play;
    const std::string points = judged ? lost(criterion, mark, state.ending != Ending::none) : "";
    text += (text.empty() || points.empty() ? "" : ": ") + points;
    const bool missed = judged && !is_met(mark.milli);
    if (criterion.must && missed && state.ending != Ending::none) text += "; a must";
    if (mark.overridden) text += (text.empty() ? "" : "; ") + mark.by + ": " + mark.note;
    // A long note does not stand here whole, and says so; its AssessmentCommand has all of it.
    if (text.size() > kOnWire)
        text = std::string(clipped(text, kOnWire - std::string_view(kCut).size())) + kCut;
    return text;
}

} // namespace windlass::assess
