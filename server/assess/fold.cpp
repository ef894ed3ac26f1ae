#include "server/assess/fold.hpp"

#include "server/assess/aids.hpp"
#include "server/assess/bridge.hpp"
#include "server/assess/chance.hpp"
#include "server/assess/marks.hpp"
#include "server/assess/order_done.hpp"
#include "server/assess/quantities.hpp"
#include "server/assess/questions.hpp"
#include "server/assess/unasked.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::assess {

using exercise::Snapshot;
using exercise::TackleView;

namespace {

constexpr int kMostTimes = 1'000'000;
constexpr double kSameFigure = 1e-6; // shackles or m, that two ways of writing a figure may differ by

std::int64_t ticks(double seconds, int tick_rate) {
    return std::llround(seconds * tick_rate);
}

/// What else than its hands makes an attempt another one.
bool is_intervention(const exercise::Order& order) {
    return std::holds_alternative<exercise::FaultOrder>(order) ||
           std::holds_alternative<exercise::EnvironmentOrder>(order);
}

void note(Came& came, std::int64_t tick) {
    if (came.first < 0) came.first = tick;
    came.last = tick;
    came.times = std::min(came.times + 1, kMostTimes);
}

void watch_events(const Lesson& lesson, State& state, const Snapshot& seen) {
    for (const exercise::ExerciseEvent& event : seen.events)
        for (std::size_t k = 0; k < lesson.events.size(); ++k) {
            const WatchedEvent& watched = lesson.events[k];
            if (event.code == watched.code && (event.side < 0 || event.side == watched.side))
                note(state.events[k], state.tick);
        }
}

void watch_reports(const Lesson& lesson, State& state) {
    for (const Heard& report : state.heard)
        for (std::size_t k = 0; k < lesson.reports.size(); ++k) {
            const WatchedReport& watched = lesson.reports[k];
            if (report.code == watched.code && (report.side < 0 || report.side == watched.side))
                note(state.reports[k], state.tick);
        }
}

/// How each cable grows.
void watch_cables(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate) {
    for (const TackleView& tackle : seen.tackle) {
        const auto side = static_cast<std::size_t>(tackle.side);
        const double plumb = lesson.gear.at(side).cable_weight * (tackle.hawse.z() + seen.environment.depth);
        state.growth.at(side).observe(tackle.windlass.hawse_tension, plumb, tick_rate);
    }
}

/// any_figure: where the first has none. A bridge that is manned chooses its own.
bool same_order(const exercise::BridgeOrderGiven& one, const exercise::BridgeOrderGiven& other,
                bool any_figure) {
    return one.code == other.code && one.side == other.side &&
           ((any_figure && one.value == 0) || std::abs(one.value - other.value) < kSameFigure);
}

/// The order of the lesson that this is: the one that the bridge gives once more, or else the first that says
/// the same and has not been given yet. -1: none.
int course_of(const Lesson& lesson, const State& state, const exercise::BridgeOrderGiven& given) {
    if (state.renewing >= 0 &&
        same_order(lesson.orders[static_cast<std::size_t>(state.renewing)].given, given, false))
        return state.renewing;
    for (std::size_t k = 0; k < lesson.orders.size(); ++k)
        if (state.orders[k].number == 0 && !state.orders[k].skipped &&
            same_order(lesson.orders[k].given, given, lesson.bridge_manned))
            return static_cast<int>(k);
    return -1;
}

/// Whether what was ordered is so; a question is answered by what is reported after it.
bool is_so(const Condition& done, const Lesson& lesson, State& state, std::size_t k, const Snapshot& seen,
           int tick_rate) {
    return holds(done, lesson, state, seen, tick_rate) &&
           std::all_of(done.signs.begin(), done.signs.end(), [&](const Sign& sign) {
               return sign.kind != SignKind::report || came(sign, state) >= state.orders[k].given;
           });
}

bool stands_at(exercise::BridgeOrderCode code, double figure, int side, const Snapshot& seen) {
    const TackleView* tackle = tackle_of(seen, side);
    return tackle != nullptr && stands_at_figure(code, figure, *tackle);
}

/// Whether one of those that an order is to has carried it out; to a figure that the bridge has chosen he
/// has once the cable stands there, and not once it stands.
bool is_carried_out(const Condition& done, const Lesson& lesson, State& state, std::size_t k,
                    const Snapshot& seen, int tick_rate) {
    const double figure = state.orders[k].figure;
    return figure > 0 ? stands_at(lesson.orders[k].given.code, figure, done.side, seen)
                      : is_so(done, lesson, state, k, seen, tick_rate);
}

/// When one of those that an order is to carried it out: since when it has been so, once that has lasted.
void watch_part(bool so, std::int64_t lasts, std::int64_t& since, std::int64_t& at, std::int64_t tick) {
    if (!so)
        since = -1;
    else if (since < 0)
        since = tick;
    else if (tick - since >= lasts)
        at = since;
}

/// Ticks for which it has been so once it is carried out.
std::int64_t lasts_when_done(exercise::BridgeOrderCode code, double figure, int tick_rate) {
    return ticks(is_to_stand(code, figure) ? kStandsFor : kDoneFor, tick_rate);
}

/// Each of those that an order is to carries it out at his time; it is done when the last has.
void watch_deed(const Lesson& lesson, State& state, std::size_t k, const Snapshot& seen, int tick_rate) {
    const std::vector<Condition>& done = lesson.orders[k].done;
    const exercise::BridgeOrderGiven& given = lesson.orders[k].given;
    OrderCourse& course = state.orders[k];
    const std::int64_t lasts = lasts_when_done(given.code, std::max(given.value, course.figure), tick_rate);
    std::int64_t last = -1;
    bool all = true;
    for (std::size_t i = 0; i < done.size(); ++i) {
        std::int64_t &at = course.each_done.at(i), &since = course.each_since.at(i);
        if (at < 0)
            watch_part(is_carried_out(done[i], lesson, state, k, seen, tick_rate), lasts, since, at,
                       state.tick);
        all = all && at >= 0;
        last = std::max(last, at);
    }
    if (all) course.done = last;
}

/// An order that none of the lesson's stands for, or none any more. What no windlass shows is in no list:
/// nobody can tell whether it was carried out.
void take_further(const Lesson& lesson, State& state, const exercise::BridgeOrderView& order) {
    if (!lesson.bridge_manned || lesson.orders.size() + state.further.size() >= kMostOrders) return;
    const exercise::BridgeOrderGiven& given = order.given;
    const auto code = static_cast<std::size_t>(given.code);
    const bool is_shown = std::ranges::any_of(lesson.usually_done, [code](const auto& of_side) {
        return code < of_side.size() && !(of_side[code].bounds.empty() && of_side[code].signs.empty());
    });
    if (!is_shown && !is_question(given.code)) return;
    state.further.push_back({.number = order.number,
                             .code = given.code,
                             .side = given.side,
                             .figure = is_to_a_figure(given) ? given.value : 0});
}

/// As watch_deed().
void watch_further(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate) {
    for (FurtherOrder& order : state.further) {
        if (order.done >= 0 || is_question(order.code)) continue;
        const auto found =
            std::ranges::find(seen.bridge_orders, order.number, &exercise::BridgeOrderView::number);
        if (found != seen.bridge_orders.end() && found->state == exercise::BridgeOrderState::cancelled)
            continue;
        const std::int64_t lasts = lasts_when_done(order.code, order.figure, tick_rate);
        std::int64_t last = -1;
        bool all = true;
        for (const TackleView& tackle : seen.tackle) {
            const auto side = static_cast<std::size_t>(tackle.side);
            if (order.side >= 0 && order.side != static_cast<int>(side)) continue;
            std::int64_t &at = order.each_done.at(side), &since = order.each_since.at(side);
            const Condition& done = lesson.usually_done.at(side).at(static_cast<std::size_t>(order.code));
            if (at < 0)
                watch_part(order.figure > 0 ? stands_at_figure(order.code, order.figure, tackle)
                                            : holds(done, lesson, state, seen, tick_rate),
                           lasts, since, at, state.tick);
            all = all && at >= 0;
            last = std::max(last, at);
        }
        if (all) order.done = last;
    }
}

/// The bridge's orders as they stand, whoever gave them.
void watch_orders(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate) {
    for (const exercise::BridgeOrderView& order : seen.bridge_orders) {
        if (order.number <= state.last_order) continue;
        state.last_order = order.number;
        const int k = course_of(lesson, state, order.given);
        if (k < 0) {
            take_further(lesson, state, order);
            continue;
        }
        OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
        course.number = order.number;
        course.taken_back = false;
        if (k == state.renewing) {
            state.renewing = -1; // its deadlines stay those of the first time
            continue;
        }
        course.given = state.tick;
        const bool its_own = lesson.orders[static_cast<std::size_t>(k)].given.value > 0;
        if (lesson.bridge_manned && !its_own && is_to_a_figure(order.given))
            course.figure = order.given.value;
        if (order.do_by > 0) course.do_by = state.tick + ticks(order.do_by - order.time, tick_rate);
        const std::vector<Condition>& done = lesson.orders[static_cast<std::size_t>(k)].done;
        course.was_so = !done.empty() && std::all_of(done.begin(), done.end(), [&](const Condition& one) {
            return is_carried_out(one, lesson, state, static_cast<std::size_t>(k), seen, tick_rate);
        });
    }
    watch_further(lesson, state, seen, tick_rate);
    for (std::size_t k = 0; k < state.orders.size(); ++k) {
        OrderCourse& course = state.orders[k];
        if (course.number == 0 || course.challenged >= 0) continue;
        // At every tick, since what makes it unsafe may have to be so for a while.
        const std::optional<Condition>& unsafe = lesson.orders[k].unsafe;
        course.unsafe = unsafe && holds(*unsafe, lesson, state, seen, tick_rate);
        const auto found = std::find_if(seen.bridge_orders.begin(), seen.bridge_orders.end(),
                                        [&](const auto& order) { return order.number == course.number; });
        const bool is_cancelled =
            found != seen.bridge_orders.end() && found->state == exercise::BridgeOrderState::cancelled;
        if (is_cancelled && course.done < 0) course.taken_back = true;
        if (is_cancelled && course.doubted >= 0) { // by a bridge that is manned
            course.doubted = -1;
            course.challenged = state.tick;
            continue;
        }
        if (course.repeated >= 0 && course.done >= 0) continue;
        if (found != seen.bridge_orders.end() && course.repeated < 0) {
            course.wrong_now = found->state == exercise::BridgeOrderState::misrepeated;
            if (course.wrong_now) course.misrepeated = true;
            if (found->state == exercise::BridgeOrderState::repeated) {
                course.repeated = state.tick;
                if (answered_by_repeat(lesson.orders[k].given)) course.answered = state.tick;
                state.asked = 0;
                // From when it was first given, where nobody answered: that it had to be said again makes it
                // no sooner. A wrong repeat was an answer.
                const double since =
                    course.misrepeated ? found->time : static_cast<double>(course.given) / tick_rate;
                const double within = found->repeat_by - found->time;
                course.in_time = found->repeat_by <= 0 || seen.time <= since + within + 1.0 / tick_rate;
            }
        }
        if (course.done < 0) watch_deed(lesson, state, k, seen, tick_rate);
    }
}

void change_weather(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate,
                    std::vector<exercise::Order>& due) {
    while (state.changes < static_cast<int>(lesson.schedule.size())) {
        const WeatherChange& change = lesson.schedule[static_cast<std::size_t>(state.changes)];
        if (state.tick - state.begin < ticks(change.at, tick_rate)) return;
        ++state.changes;
        exercise::EnvironmentOrder order{seen.environment.after, change.over};
        const auto lay = [](const std::optional<double>& from, double& to) { to = from.value_or(to); };
        lay(change.wind_speed, order.weather.wind_speed);
        lay(change.wind_from, order.weather.wind_from);
        lay(change.current_speed, order.weather.current_speed);
        lay(change.current_towards, order.weather.current_towards);
        lay(change.visibility, order.weather.visibility);
        due.emplace_back(order);
    }
}

void bring_faults(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate,
                  std::vector<exercise::Order>& due) {
    for (std::size_t k = 0; k < lesson.faults.size(); ++k) {
        const LessonFault& fault = lesson.faults[k];
        if (state.faults[k] == 0 && comes(lesson, state, k, seen, tick_rate)) {
            state.faults[k] = 1;
            due.emplace_back(drawn_fault(lesson, state, k));
        } else if (state.faults[k] == 1 && fault.clear &&
                   holds(*fault.clear, lesson, state, seen, tick_rate)) {
            state.faults[k] = 2;
            due.emplace_back(exercise::FaultOrder{.code = drawn_fault(lesson, state, k).code,
                                                  .side = fault.order.side,
                                                  .severity = 0,
                                                  .clear = true});
        }
    }
}

/// In practice alone. Each is told once.
void give_hints(const Lesson& lesson, State& state, const Look& look) {
    if (!lesson.practice) return;
    for (std::size_t k = 0; k < lesson.hints.size(); ++k)
        if (state.hints[k] < 0 && look.holds(lesson.hints[k].when)) state.hints[k] = state.tick;
}

void end(const Lesson& lesson, State& state, int tick_rate, Ending ending) {
    if (state.ending != Ending::none) return;
    state.ending = ending;
    state.ended = state.tick;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k)
        close(lesson.criteria[k], state.marks[k], state, lesson, tick_rate);
}

/// Whether an end waits for what it hangs on, that something is secured, to be so as it was said: for as long
/// as a word of it may be put right.
bool may_be_made_so(const Condition& good, const Lesson& lesson, const State& state, int tick_rate) {
    const auto just_said = [&](const Sign& sign) {
        if (sign.kind != SignKind::order_answered) return false;
        const auto k = static_cast<std::size_t>(sign.index);
        const OrderCourse& course = state.orders[k];
        return lesson.orders[k].given.code == exercise::BridgeOrderCode::secure && course.answered >= 0 &&
               course.done < 0 && state.tick - course.answered < ticks(kRightAtOnce, tick_rate);
    };
    return std::ranges::any_of(good.signs, just_said) ||
           std::ranges::any_of(good.either, [&](const Condition& one) {
               return may_be_made_so(one, lesson, state, tick_rate);
           });
}

void look_for_the_end(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate) {
    for (std::size_t k = 0; k < lesson.abort.size(); ++k) {
        const Accident& one = lesson.abort[k];
        const bool has_come = one.when
                                  ? holds(*one.when, lesson, state, seen, tick_rate)
                                  : std::ranges::find(seen.events, one.what,
                                                      &exercise::ExerciseEvent::code) != seen.events.end();
        if (!has_come || state.ending != Ending::none) continue;
        state.aborted_by = static_cast<int>(k);
        end(lesson, state, tick_rate, Ending::abort);
    }
    if (lesson.good && holds(*lesson.good, lesson, state, seen, tick_rate) &&
        !may_be_made_so(*lesson.good, lesson, state, tick_rate))
        end(lesson, state, tick_rate, Ending::good);
    if (lesson.time_limit > 0 && state.tick - state.begin >= ticks(lesson.time_limit, tick_rate))
        end(lesson, state, tick_rate, Ending::time);
}

/// Whether what comes again and again has come as often as it is asked for.
bool often_enough(const Condition& condition, const Sign& sign, const State& state) {
    const auto k = static_cast<std::size_t>(sign.index);
    if (sign.kind == SignKind::event) return state.events[k].times >= condition.times;
    if (sign.kind == SignKind::report) return state.reports[k].times >= condition.times;
    return true;
}

} // namespace

std::int64_t came(const Sign& sign, const State& state) {
    const auto k = static_cast<std::size_t>(sign.index);
    switch (sign.kind) {
    case SignKind::event:
        return state.events[k].first;
    case SignKind::report:
        return state.reports[k].last;
    case SignKind::moment:
        return state.moments[k].first;
    case SignKind::order_given:
        return state.orders[k].skipped ? state.orders[k].done : state.orders[k].given;
    case SignKind::order_repeated:
        return state.orders[k].repeated;
    case SignKind::order_answered:
        return state.orders[k].answered;
    case SignKind::order_done:
        return state.orders[k].done;
    case SignKind::order_challenged:
        return state.orders[k].challenged;
    }
    return -1;
}

bool holds(const Condition& condition, const Lesson& lesson, State& state, const Snapshot& seen,
           int tick_rate) {
    const TackleView* tackle = tackle_of(seen, condition.side);
    bool all = tackle != nullptr && state.tick - state.begin >= ticks(condition.time, tick_rate);
    for (std::size_t k = 0; all && k < condition.bounds.size(); ++k) {
        const Bounds& bounds = condition.bounds[k];
        all = bounds.hold(figure(bounds.quantity, seen, *tackle, state));
    }
    if (all && condition.phases != 0)
        all = (condition.phases >> static_cast<unsigned>(tackle->anchor.phase) & 1U) != 0;
    std::int64_t last = state.begin;
    for (std::size_t k = 0; all && k < condition.signs.size(); ++k) {
        const std::int64_t at = came(condition.signs[k], state);
        all = at >= 0 && often_enough(condition, condition.signs[k], state);
        last = std::max(last, at);
    }
    // Each is asked at every tick, since some of them must hold for a while.
    const auto so = [&](const Condition& one) { return holds(one, lesson, state, seen, tick_rate); };
    if (!condition.either.empty() && std::ranges::count_if(condition.either, so) == 0) all = false;
    if (std::ranges::count_if(condition.neither, so) > 0) all = false;
    if (all && condition.since > 0) all = state.tick - last >= ticks(condition.since, tick_rate);
    if (condition.memory < 0) return all;
    std::int64_t& since = state.held[static_cast<std::size_t>(condition.memory)];
    if (!all) {
        since = -1;
        return false;
    }
    if (since < 0) since = state.tick;
    return state.tick - since >= ticks(condition.hold, tick_rate);
}

double figure(int quantity, const Snapshot& seen, const TackleView& tackle, const State& state) {
    const Quantity& one = quantity_at(quantity);
    return one.read != nullptr ? one.read(seen, tackle)
                               : state.growth.at(static_cast<std::size_t>(tackle.side)).rise();
}

MissingPart missing_part(const Condition& condition, const Lesson& lesson, State& state, const Snapshot& seen,
                         int tick_rate) {
    const auto bounded = static_cast<int>(condition.bounds.size());
    const auto all = bounded + 1 + static_cast<int>(condition.signs.size());
    const TackleView* tackle = tackle_of(seen, condition.side);
    if (tackle == nullptr) return {.place = all};
    for (int k = 0; k < bounded; ++k) {
        const Bounds& bounds = condition.bounds[static_cast<std::size_t>(k)];
        const double now = figure(bounds.quantity, seen, *tackle, state);
        if (!bounds.hold(now)) return {k, now};
    }
    const auto phase = static_cast<unsigned>(tackle->anchor.phase);
    if (condition.phases != 0 && (condition.phases >> phase & 1U) == 0)
        return {bounded, static_cast<double>(phase)};
    std::int64_t last = state.begin;
    for (int k = bounded + 1; k < all; ++k) {
        const Sign& sign = condition.signs[static_cast<std::size_t>(k - bounded - 1)];
        const std::int64_t at = came(sign, state);
        if (at < 0 || !often_enough(condition, sign, state)) return {.place = k};
        last = std::max(last, at);
    }
    // Asked again in one tick, what must hold for a while gives the same answer.
    const auto so = [&](const Condition& one) { return holds(one, lesson, state, seen, tick_rate); };
    if (!condition.either.empty() && std::ranges::count_if(condition.either, so) == 0)
        return {.place = all + kEitherMissing};
    if (std::ranges::count_if(condition.neither, so) > 0) return {.place = all + kNeitherHolds};
    const bool in_time = state.tick - state.begin >= ticks(condition.time, tick_rate) &&
                         state.tick - last >= ticks(condition.since, tick_rate);
    return {.place = in_time ? -1 : all};
}

void begin(const Lesson& lesson, State& state, const Snapshot& seen) {
    state = fresh(lesson);
    state.begin = state.tick = static_cast<std::int64_t>(seen.tick);
}

void fold(const Lesson& lesson, State& state, const Snapshot& seen, int tick_rate,
          std::vector<exercise::Order>& due) {
    if (state.ending != Ending::none) return; // it stands as it was then
    state.tick = static_cast<std::int64_t>(seen.tick);
    const Look look{lesson, state, seen, tick_rate};
    watch_events(lesson, state, seen);
    watch_cables(lesson, state, seen, tick_rate);
    watch_reports(lesson, state);
    watch_orders(lesson, state, seen, tick_rate);
    for (const Heard& report : state.heard)
        take_answer(report, look);
    for (std::size_t k = 0; k < lesson.moments.size(); ++k)
        if (state.moments[k].first < 0 && look.holds(lesson.moments[k].when))
            note(state.moments[k], state.tick);
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        for (const Heard& report : state.heard)
            take_report(lesson.criteria[k], state.marks[k], report, look);
        look_at(lesson.criteria[k], state.marks[k], look);
    }
    for (const Heard& report : state.heard)
        take_unasked(report, look);
    watch_unasked(look);
    state.heard.clear();
    look_for_the_end(lesson, state, seen, tick_rate);
    if (state.ending != Ending::none) return;
    give_hints(lesson, state, look);
    if (!speak(lesson, state, seen, tick_rate, due)) return end(lesson, state, tick_rate, Ending::time);
    const auto spoken = static_cast<std::ptrdiff_t>(due.size());
    bring_faults(lesson, state, seen, tick_rate, due);
    change_weather(lesson, state, seen, tick_rate, due);
    state.own_due = static_cast<int>(std::ranges::count_if(due.begin() + spoken, due.end(), is_intervention));
}

void hear(const Lesson& lesson, State& state, const exercise::Order& order, int tick_rate) {
    if (const auto* report = std::get_if<exercise::ReportMade>(&order)) {
        if (state.ending == Ending::none)
            state.heard.push_back({state.tick, report->code, report->side, report->value, report->lead,
                                   report->stay, report->growing, report->weight, report->order_number,
                                   report->order_code});
        return;
    }
    if (is_intervention(order)) {
        if (state.own_due > 0)
            --state.own_due;
        else
            state.intervened = true;
        return;
    }
    if (const auto* answer = std::get_if<exercise::AnswerGiven>(&order)) {
        if (const auto aid = read_aid(*answer)) return take_aid(lesson, state, *aid);
        for (std::size_t k = 0; k < lesson.criteria.size(); ++k)
            if (lesson.criteria[k].id == answer->question)
                judge_answer(lesson.criteria[k], state.marks[k], *answer, state, lesson);
        return;
    }
    if (const auto* drawn = std::get_if<exercise::ChanceDrawn>(&order)) return draw(lesson, state, *drawn);
    const auto* word = std::get_if<exercise::AssessorsWord>(&order);
    if (word == nullptr) return;
    if (word->criterion.empty()) {
        end(lesson, state, tick_rate, Ending::instructor);
        state.confirmed = state.confirmed || word->verdict == exercise::AssessorVerdict::confirmed;
        return;
    }
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        if (lesson.criteria[k].id != word->criterion) continue;
        Mark& mark = state.marks[k];
        switch (word->verdict) {
        case exercise::AssessorVerdict::met:
            mark.given_milli = 1000;
            break;
        case exercise::AssessorVerdict::confirmed: // what stands, by his own word or as it is computed
            if (!mark.overridden && mark.state == CriterionState::not_in_play) continue; // nothing does
            if (!mark.overridden) mark.given_milli = mark.milli;
            break;
        case exercise::AssessorVerdict::not_met:
            mark.given_milli = 0;
            break;
        case exercise::AssessorVerdict::not_applicable:
            mark.given_milli = -1;
            break;
        case exercise::AssessorVerdict::points:
            mark.given_milli = word->milli;
            break;
        case exercise::AssessorVerdict::ended: // of the whole alone
            break;
        }
        mark.overridden = true;
        mark.note = word->note;
        mark.by = word->by;
    }
}

} // namespace windlass::assess
