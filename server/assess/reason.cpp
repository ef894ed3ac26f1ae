// Reasons in words, made of the figures that the fold has kept.

#include "server/assess/quantities.hpp"
#include "server/assess/result.hpp"

#include <array>
#include <cstdio>

namespace windlass::assess {

namespace {

std::string clock(std::int64_t ticks, int tick_rate) {
    const std::int64_t seconds = ticks / tick_rate;
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%lld:%02lld", static_cast<long long>(seconds / 60),
                  static_cast<long long>(seconds % 60));
    return text.data();
}

std::string seconds(std::int64_t ticks, int tick_rate) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.1f s", static_cast<double>(ticks) / tick_rate);
    return text.data();
}

std::string lost(const Criterion& criterion, const Mark& mark) {
    const int tenths = (criterion.weight * (1000 - mark.milli) + 50) / 100;
    if (tenths == 0) return "";
    std::array<char, 60> text{};
    std::snprintf(text.data(), text.size(), ": %d.%d of %d points lost", tenths / 10, tenths % 10,
                  criterion.weight);
    return text.data();
}

std::string limit_words(const Criterion& criterion, const Mark& mark, int rate) {
    const Quantity& quantity = quantities()[static_cast<std::size_t>(criterion.quantity)];
    const std::string unit = quantity.unit;
    if (mark.worst_tick < 0) return "";
    std::string text =
        clock(mark.worst_tick, rate) + " " + quantity.text + " " + figure_text(mark.worst, unit);
    if (criterion.min > -kNoLimit) text += ", at least " + figure_text(criterion.min, unit);
    if (criterion.max < kNoLimit) text += ", at most " + figure_text(criterion.max, unit);
    if (mark.outside > 0)
        text += "; from " + clock(mark.since, rate) + " " + seconds(mark.outside, rate) + " beyond";
    return text;
}

std::string sequence_words(const Criterion& criterion, const Mark& mark, int rate) {
    if (mark.began < 0) return "";
    const std::string steps =
        std::to_string(mark.step) + " of " + std::to_string(criterion.steps.size()) + " steps";
    if (mark.wrong > 0)
        return clock(mark.worst_tick, rate) + " step " + std::to_string(mark.wrong) + " before step " +
               std::to_string(mark.step + 1);
    if (mark.decided < 0) return steps;
    return clock(mark.decided, rate) + " " + steps + " in " + seconds(mark.decided - mark.began, rate);
}

std::string state_words(const Criterion& criterion, const Mark& mark, int rate) {
    if (mark.decided < 0) return "";
    std::string text = clock(mark.decided, rate) + (mark.milli > 0 ? " it was so" : " it was not so");
    if (mark.worst_tick >= 0 && !criterion.that.bounds.empty()) {
        const Quantity& quantity =
            quantities()[static_cast<std::size_t>(criterion.that.bounds.front().quantity)];
        text += std::string(": ") + quantity.text + " " + figure_text(mark.worst, quantity.unit);
    }
    return text;
}

std::string order_words(const Lesson& lesson, const State& state, const Criterion& criterion, int rate) {
    std::string text;
    for (const int order : criterion.orders) {
        const OrderCourse& course = state.orders[static_cast<std::size_t>(order)];
        if (course.given < 0) continue;
        std::string fault;
        if (course.misrepeated)
            fault = "repeated wrongly";
        else if (course.repeated >= 0 && !course.in_time)
            fault = "repeated late";
        const bool late = course.do_by >= 0 && course.done > course.do_by;
        if (late)
            fault += (fault.empty() ? "" : ", ") +
                     ("done late, after " + seconds(course.done - course.given, rate));
        if (state.ending != Ending::none && course.done < 0)
            fault += fault.empty() ? "not done" : ", not done";
        if (fault.empty()) continue;
        text += (text.empty() ? "" : "; ") + clock(course.given, rate) + " " +
                lesson.orders[static_cast<std::size_t>(order)].id + ": " + fault;
    }
    return text;
}

std::string report_words(const Criterion& criterion, const Mark& mark, int rate) {
    if (criterion.truth == ReportTruth::moment) {
        if (mark.began < 0) return mark.decided >= 0 ? "said, and it never was so" : "";
        const std::string so = clock(mark.began, rate) + " it was so";
        if (mark.decided < 0) return so;
        if (mark.since < 0) return so + ", not reported in time";
        return so + ", reported " + seconds(mark.outside < 0 ? -mark.outside : mark.outside, rate) +
               (mark.outside < 0 ? " before" : " after") +
               (mark.wrong > 0 ? ", and once when it was not" : "");
    }
    if (criterion.truth == ReportTruth::figure) {
        std::array<char, 100> text{};
        std::snprintf(text.data(), text.size(), "%d of %d reports, farthest off by %.2f", mark.step,
                      criterion.count, mark.worst);
        return text.data();
    }
    if (criterion.truth == ReportTruth::growth)
        return std::to_string(mark.step - mark.wrong) + " of " + std::to_string(criterion.count) +
               " reports as it was";
    if (mark.milli > 0) return clock(mark.decided, rate) + " reported, and it was so";
    return mark.wrong > 0 ? clock(mark.worst_tick, rate) + " reported, and it was not so" : "not reported";
}

} // namespace

std::string reason(const Lesson& lesson, const State& state, std::size_t k, int tick_rate) {
    const Criterion& criterion = lesson.criteria[k];
    const Mark& mark = state.marks[k];
    std::string text;
    switch (criterion.kind) {
    case CriterionKind::limit:
        text = limit_words(criterion, mark, tick_rate);
        break;
    case CriterionKind::sequence:
        text = sequence_words(criterion, mark, tick_rate);
        break;
    case CriterionKind::state_at:
        text = state_words(criterion, mark, tick_rate);
        break;
    case CriterionKind::order:
        text = order_words(lesson, state, criterion, tick_rate);
        break;
    case CriterionKind::report:
        text = report_words(criterion, mark, tick_rate);
        break;
    case CriterionKind::prohibited:
        text = mark.state == CriterionState::not_met ? clock(mark.decided, tick_rate) + " it happened" : "";
        break;
    case CriterionKind::final:
        if (mark.decided >= 0) text = mark.milli > 0 ? "so at the end" : "not so at the end";
        break;
    case CriterionKind::rubric:
        break;
    }
    if (mark.state != CriterionState::not_in_play) text += lost(criterion, mark);
    if (mark.overridden) text += (text.empty() ? "" : "; ") + mark.by + ": " + mark.note;
    return text;
}

} // namespace windlass::assess
