#include "recorder/debrief/again.hpp"

#include "station/names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::debrief {

using nlohmann::json;

namespace {

constexpr double kDeedWithin = 120; // s before the loss: what was done earlier is not what lost it
constexpr double kRest = 2;         // s: a hand that goes on sooner is still at it

/// The lesson, as the recording has it attached; empty: it has none.
json lesson_of(const Attempt& attempt) {
    const json file = json::parse(attempt.lesson.json, nullptr, false);
    return file.is_object() ? file.value("lesson", json::object()) : json::object();
}

/// What the lesson says of one of its criteria or orders; an empty object: nothing.
json entry(const json& lesson, const char* list, const std::string& id) {
    const json all = lesson.value(list, json::array());
    for (const json& each : all)
        if (each.value("id", "") == id) return each;
    return json::object();
}

/// s from its moment until a state was looked at, or had come about too late; 0: it was looked at at once.
double time_for(const json& lesson, const Criterion& lost) {
    const json its = entry(lesson, "criteria", lost.code().to_string());
    const double after = its.value("after", 0.0), zero = its.value("zero", after);
    return after + (1 - lost.milli() / 1000.0) * (zero - after); // evenly down, as lessons are marked
}

/// The code of the order from which on a criterion is looked at, the last of several; empty: the lesson names
/// none.
std::string order_of(const json& lesson, const Criterion& lost) {
    const json from = entry(lesson, "criteria", lost.code().to_string()).value("from", json::object());
    json given = from.value("given", json());
    if (given.is_array() && !given.empty()) given = json(given.back());
    return given.is_string() ? entry(lesson, "orders", given.get<std::string>()).value("code", "") : "";
}

/// s within which steps are to be taken from a moment on that is no order; 0: the lesson says no such time.
double time_for_steps(const json& lesson, const Criterion& lost) {
    if (!order_of(lesson, lost).empty()) return 0;
    return entry(lesson, "criteria", lost.code().to_string()).value("within", 0.0);
}

/// When a hand began to move levers for the last time before the loss; nothing: none did shortly before.
std::optional<double> hand_before(const Attempt& attempt, double loss) {
    std::optional<double> began;
    const auto& moves = attempt.lever_moves;
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
        if (move->time > loss) continue;
        if (loss - move->time > kDeedWithin || (began && *began - move->time > kRest)) break;
        began = move->time;
    }
    return began;
}

/// When the bridge gave the order that was its last before the loss, for the first time; nothing: it gave
/// none. What is asked, said or taken back is none. code: of that order alone; empty: of any.
std::optional<double> order_before(const Attempt& attempt, double loss, const std::string& code = {}) {
    const BridgeOrder* last = nullptr;
    for (auto each = attempt.orders.rbegin(); each != attempt.orders.rend(); ++each) {
        const BridgeOrder& order = each->order;
        const bool to_do = order.repeat_by() > order.time() && order.code() != BRIDGE_ORDER_TEXT &&
                           order.code() != BRIDGE_ORDER_CANCEL && order.state() != ORDER_CANCELLED;
        if (!to_do || order.time() > loss || (!code.empty() && station::name(order.code()) != code)) continue;
        if (last != nullptr &&
            (order.code() != last->code() || order.side() != last->side() || order.value() != last->value()))
            break;
        last = &order;
    }
    return last == nullptr ? std::nullopt : std::optional(last->time());
}

/// Whether a report of that criterion came, and was not right.
bool was_said_wrongly(const Attempt& attempt, const Criterion& lost) {
    return std::ranges::any_of(attempt.assessment->reports(), [&](const JudgedReport& report) {
        return report.criterion() == lost.code() && report.milli() < 1000;
    });
}

struct Before {
    AgainBefore what;
    double time; ///< s of exercise
};

Before or_loss(AgainBefore what, std::optional<double> time, double loss) {
    return time ? Before{what, *time} : Before{AgainBefore::loss, loss};
}

Before before_what(const Attempt& attempt, const Mark& mark) {
    const Criterion& lost = *mark.criterion;
    const json lesson = lesson_of(attempt);
    const auto order = [&] {
        auto given = order_before(attempt, mark.time, order_of(lesson, lost));
        if (!given) given = order_before(attempt, mark.time); // that which it waits for never came
        return or_loss(AgainBefore::order, given, mark.time);
    };
    if (lost.lost_tick() == 0) return order(); // a must that the lesson never came to
    const bool never_so = lost.lost_tick() == lost.tick();
    switch (lost.kind()) {
    case CRITERION_ORDER: // it counts from when it was given
        return {AgainBefore::order, mark.time};
    case CRITERION_SEQUENCE:
        if (const double time = time_for_steps(lesson, lost); time > 0)
            return {AgainBefore::due, mark.time - time};
        return order();
    case CRITERION_REPORT: // from when it could have been made, or was made wrongly; else from the end
        if (never_so && !was_said_wrongly(attempt, lost)) return order();
        return {AgainBefore::loss, mark.time};
    case CRITERION_QUESTION:
        return {AgainBefore::loss, mark.time};
    case CRITERION_FINAL:
        if (never_so) return order();
        break;
    case CRITERION_STATE_AT:
        if (const double time = time_for(lesson, lost); time > 0) return {AgainBefore::due, mark.time - time};
        break;
    default:
        break;
    }
    // Something was done. Where the bridge is judged, that is what it ordered.
    if (lesson.value("bridge", "") == "manned")
        if (const auto given = order_before(attempt, mark.time); given && mark.time - *given <= kDeedWithin)
            return {AgainBefore::order, *given};
    return or_loss(AgainBefore::levers, hand_before(attempt, mark.time), mark.time);
}

} // namespace

std::optional<Again> again_of(const Attempt& attempt) {
    const Judgement judgement = judgement_of(attempt);
    const auto lost = went_wrong(attempt, judgement);
    if (!lost || lost->time <= attempt.began) return std::nullopt;
    const Before before = before_what(attempt, *lost);
    const double from = std::max(attempt.began, before.time - kAgainBefore);
    Again again{.from = from,
                .before = before.what,
                .seconds = std::max(0.0, before.time - from),
                .lost = name_of(*lost->criterion),
                .lost_at = lost->time};
    for (const Mark& mark : judgement.deductions())
        if (mark.criterion != lost->criterion && mark.time > attempt.began && mark.time <= again.from)
            again.standing.push_back(name_of(*mark.criterion));
    return again;
}

} // namespace windlass::debrief
