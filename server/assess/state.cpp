#include "server/assess/state.hpp"

#include "server/assess/lever.hpp"

namespace windlass::assess {

using exercise::last_of;

namespace {

constexpr std::size_t kMaxHeard = 10'000; // reports of a pause
constexpr std::size_t kMaxList = 1000;    // more than a lesson may have of anything

/// A list that is as long as the lesson says.
template <class Visitor, class List>
void sized(Visitor& v, const char* name, List& list) {
    const auto wanted = list.size();
    v.length({name}, list, kMaxList);
    v.within({name}, list.size(), wanted, wanted);
}

template <class Visitor, class List>
void visit_came(Visitor& v, const char* name, List& list) {
    sized(v, name, list);
    for (auto& came : list) {
        auto& [first, last, times] = came;
        WINDLASS_STATE(v, first, last, times);
    }
}

template <class Visitor, class Report>
void visit_heard(Visitor& v, Report& report) {
    auto& [came, code, side, value, lead, stay, growing, weight, order_number, proposed] = report;
    WINDLASS_STATE(v, came, side, value, lead, order_number);
    v.whole({"code"}, code);
    v.whole({"stay"}, stay);
    v.whole({"growing"}, growing);
    v.whole({"weight"}, weight);
    v.whole({"proposed"}, proposed);
}

template <class Visitor, class Report>
void visit_judged(Visitor& v, Report& report) {
    auto& [criterion, came, milli, code, so, said, truth, top_angle, missing, stay, growing] = report;
    WINDLASS_STATE(v, criterion, came, milli, so, said, truth, top_angle, missing, stay, growing);
    v.whole({"code"}, code);
}

} // namespace

State fresh(const Lesson& lesson) {
    State state;
    state.events.resize(lesson.events.size());
    state.reports.resize(lesson.reports.size());
    state.moments.resize(lesson.moments.size());
    state.orders.resize(lesson.orders.size());
    state.faults.resize(lesson.faults.size());
    state.fault_since.assign(lesson.faults.size(), -1);
    state.marks.resize(lesson.criteria.size());
    state.questions.resize(lesson.questions.size());
    state.held.assign(static_cast<std::size_t>(lesson.held), -1);
    state.hints.assign(lesson.hints.size(), -1);
    return state;
}

template <class Visitor, physics::StateOf<State> Self>
void visit_state(Visitor& v, Self& self) {
    auto& [begin, tick, ended, ending, aborted_by, last_order, changes, renewing, asked, gave_up, seed,
           own_due, intervened, question, heard_at, spoke_at, misled_at, tried, trouble, told, confirmed,
           events, reports, moments, orders, further, faults, fault_since, marks, held, hints, heard, judged,
           waiting, unasked, growth, questions, aids, ghost_on, hint_asked] = self;
    WINDLASS_STATE(v, begin, tick, ended, ending, aborted_by, last_order, changes, renewing, asked, gave_up,
                   seed, own_due, intervened, question, heard_at, spoke_at, misled_at, confirmed);
    v.whole({"trouble"}, trouble);
    for (auto& shackles : told)
        v.field({"told"}, shackles);
    const auto last_of_orders = static_cast<int>(orders.size()) - 1;
    v.within({"renewing"}, renewing, -1, last_of_orders);
    v.within({"question"}, question, -1, static_cast<int>(last_of(exercise::BridgeOrderCode{})));
    visit_came(v, "events", events);
    visit_came(v, "reports", reports);
    visit_came(v, "moments", moments);
    sized(v, "orders", orders);
    for (auto& order : orders) {
        auto& [asked_for, number, given, repeated, done, each_since, each_done, in_time, misrepeated,
               wrong_now, do_by, answered, short_of, was_so, skipped, unsafe, doubted, proposed,
               proposed_value, challenged, figure, taken_back] = order;
        WINDLASS_STATE(v, asked_for, number, given, repeated, done, in_time, misrepeated, wrong_now, do_by,
                       answered, short_of, was_so, skipped, unsafe, doubted, proposed, proposed_value,
                       challenged, figure, taken_back);
        for (auto* each : {&each_since, &each_done})
            for (auto& tick : *each)
                v.field({"each"}, tick);
    }
    v.length({"further"}, further, kMostOrders);
    for (auto& order : further) {
        auto& [number, code, side, figure, done, each_since, each_done] = order;
        WINDLASS_STATE(v, number, side, figure, done);
        v.whole({"code"}, code);
        v.within({"side"}, side, -1, 1);
        for (auto* each : {&each_since, &each_done})
            for (auto& tick : *each)
                v.field({"each"}, tick);
    }
    sized(v, "faults", faults);
    for (auto& fault : faults)
        v.field({"fault"}, fault);
    sized(v, "fault_since", fault_since);
    for (auto& since : fault_since)
        v.field({"since"}, since);
    sized(v, "marks", marks);
    for (auto& mark : marks) {
        auto& [state, milli, decided, began, outside, since, worst, worst_tick, missing, step, wrong, holds,
               once_held, acted, slots, pending, said, reported, shown, shown_angle, overridden, given_milli,
               note, by] = mark;
        WINDLASS_STATE(v, state, milli, decided, began, outside, since, worst, worst_tick, missing, step,
                       wrong, holds, once_held, acted, slots, pending, said, reported, shown, shown_angle,
                       overridden, given_milli, note, by);
        v.within({"milli"}, milli, 0, 1000);
        v.within({"given_milli"}, given_milli, -1, 1000);
        v.within({"step"}, step, 0, 1'000'000);
    }
    sized(v, "held", held);
    for (auto& since : held)
        v.field({"since"}, since);
    sized(v, "hints", hints);
    for (auto& given : hints)
        v.field({"hint"}, given);
    v.length({"heard"}, heard, kMaxHeard);
    for (auto& report : heard)
        visit_heard(v, report);
    v.length({"tried"}, tried, kMostTried);
    for (auto& report : tried)
        visit_heard(v, report);
    v.length({"judged"}, judged, kMostJudged);
    for (auto& report : judged) {
        visit_judged(v, report);
        v.within({"criterion"}, report.criterion, 0, static_cast<int>(marks.size()) - 1);
    }
    v.length({"waiting"}, waiting, kMostUnasked);
    for (auto& report : waiting)
        visit_judged(v, report);
    v.length({"unasked"}, unasked, kMostUnasked);
    for (auto& report : unasked)
        visit_judged(v, report);
    for (auto& side : growth)
        v.field({"growth"}, side);
    sized(v, "questions", questions);
    for (auto& question : questions) {
        auto& [asked_at, open, truth, right, answer, value, choice] = question;
        WINDLASS_STATE(v, asked_at, open, truth, right, value, choice);
        v.whole({"answer"}, answer);
    }
    v.length({"aids"}, aids, kMostAids);
    for (auto& aid : aids) {
        auto& [taken, kind, forecastle, criterion, lever, side, value] = aid;
        WINDLASS_STATE(v, taken, forecastle, criterion, lever, side, value);
        v.whole({"kind"}, kind);
        v.within({"criterion"}, criterion, -1, static_cast<int>(marks.size()) - 1);
        v.within({"lever"}, lever, -1, static_cast<int>(last_of(LeverKind{})));
        v.within({"side"}, side, 0, 1);
    }
    for (auto& on : ghost_on)
        v.field({"ghost_on"}, on);
    for (auto& asked_at : hint_asked)
        v.field({"hint_asked"}, asked_at);
}
WINDLASS_STATE_LISTED(State);

} // namespace windlass::assess
