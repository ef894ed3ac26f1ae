#include "server/assess/marks.hpp"

#include "server/assess/quantities.hpp"
#include "server/exercise/bridge_orders.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::assess {

namespace {

std::int64_t ticks(double seconds, const Look& look) {
    return std::llround(seconds * look.tick_rate);
}

void decide(Mark& mark, int milli, std::int64_t tick) {
    mark.milli = milli;
    mark.state = milli >= kMet ? CriterionState::met : CriterionState::not_met;
    mark.decided = tick;
}

/// In play from `from` on, or from the lesson's beginning; over once `to` holds. False: not now.
bool in_play(const Criterion& criterion, Mark& mark, const Look& look) {
    if (mark.began < 0 && (!criterion.from || look.holds(*criterion.from))) {
        mark.began = look.tick();
        mark.state = CriterionState::open;
        mark.milli = 1000;
    }
    if (mark.began >= 0 && criterion.to && look.holds(*criterion.to)) {
        decide(mark, mark.milli, look.tick());
        return false;
    }
    return mark.began >= 0;
}

/// Full up to grace, then straight to nothing at zero.
int share_left(std::int64_t outside, std::int64_t grace, std::int64_t zero) {
    if (outside <= grace) return 1000;
    if (outside >= zero) return 0;
    const std::int64_t lost = (2000 * (outside - grace) + (zero - grace)) / (2 * (zero - grace));
    return static_cast<int>(1000 - lost);
}

void look_at_limit(const Criterion& criterion, Mark& mark, const Look& look) {
    if (!in_play(criterion, mark, look)) return;
    const auto& quantity = quantities()[static_cast<std::size_t>(criterion.quantity)];
    const double now = quantity.read(look.seen, *tackle_of(look.seen, criterion.side));
    const bool upwards = criterion.max < kNoLimit;
    const double beyond = std::max(now - criterion.max, criterion.min - now);
    const double worst_beyond = std::max(mark.worst - criterion.max, criterion.min - mark.worst);
    if (mark.worst_tick < 0 || beyond > worst_beyond ||
        (!upwards && now < mark.worst && beyond >= worst_beyond))
        mark.worst = now, mark.worst_tick = look.tick();
    if (beyond <= 0) return;
    if (mark.since < 0) mark.since = look.tick();
    ++mark.outside;
    if (now < criterion.fail_below || now > criterion.fail_above) mark.wrong = 1;
    mark.milli = mark.wrong > 0
                     ? 0
                     : share_left(mark.outside, ticks(criterion.grace, look), ticks(criterion.zero, look));
}

/// Steps taken of all, in thousandths; half of that once the order was broken.
int share_taken(const Criterion& criterion, const Mark& mark) {
    const int all = static_cast<int>(criterion.steps.size());
    return mark.step * (mark.wrong > 0 ? 499 : 1000) / all;
}

void look_at_sequence(const Criterion& criterion, Mark& mark, const Look& look) {
    if (mark.began < 0) {
        if (criterion.from ? !look.holds(*criterion.from) : !look.holds(criterion.steps.front())) return;
        mark.began = look.tick();
        mark.state = CriterionState::open;
        for (std::size_t k = 0; k < criterion.steps.size(); ++k) // what is so already is not a step too early
            if (look.holds(criterion.steps[k])) mark.outside |= std::int64_t{1} << k;
    }
    const auto count = criterion.steps.size();
    while (mark.step < static_cast<int>(count) &&
           look.holds(criterion.steps[static_cast<std::size_t>(mark.step)]))
        ++mark.step;
    for (std::size_t k = static_cast<std::size_t>(mark.step) + 1; k < count; ++k) {
        const bool now = look.holds(criterion.steps[k]);
        if (now && (mark.outside >> k & 1) == 0 && mark.wrong == 0)
            mark.wrong = static_cast<int>(k) + 1, mark.worst_tick = look.tick();
        if (!now) mark.outside &= ~(std::int64_t{1} << k); // done again, it counts
    }
    mark.milli = share_taken(criterion, mark);
    const bool late = criterion.within < kNoLimit && look.tick() - mark.began > ticks(criterion.within, look);
    if (mark.step == static_cast<int>(count) || mark.wrong > 0 || late) decide(mark, mark.milli, look.tick());
}

void look_at_state(const Criterion& criterion, Mark& mark, const Look& look) {
    const std::int64_t moment = look.state.moments[static_cast<std::size_t>(criterion.at)].first;
    if (moment < 0) return;
    if (mark.began < 0) mark.began = moment, mark.state = CriterionState::open, mark.milli = 1000;
    if (look.tick() < moment + ticks(criterion.after, look)) return;
    if (!criterion.that.bounds.empty()) {
        const auto& quantity = quantities()[static_cast<std::size_t>(criterion.that.bounds.front().quantity)];
        mark.worst = quantity.read(look.seen, *tackle_of(look.seen, criterion.that.side));
        mark.worst_tick = look.tick();
    }
    decide(mark, look.holds(criterion.that) ? 1000 : 0, look.tick());
}

bool repeat_asked_for(const exercise::BridgeOrderGiven& order) {
    return order.repeat_within > 0 || exercise::usual_deadlines(order.code).repeat > 0;
}

/// What an order has earned; open: what may still be earned counts as earned.
int order_milli(const LessonOrder& order, const OrderCourse& course, std::int64_t tick, bool open) {
    const int repeat_worth = repeat_asked_for(order.given) ? 400 : 0;
    int repeated = 0, done = 0;
    if (course.repeated >= 0)
        repeated = !course.in_time ? 0 : course.misrepeated ? repeat_worth / 2 : repeat_worth;
    else if (open)
        repeated = repeat_worth;
    const int worth = 1000 - repeat_worth;
    const bool late = course.do_by >= 0 && (course.done >= 0 ? course.done : tick) > course.do_by;
    if (course.done >= 0 || open) done = late ? worth / 2 : worth;
    return repeated + done;
}

void look_at_orders(const Criterion& criterion, Mark& mark, std::int64_t tick, bool open, const State& state,
                    const Lesson& lesson) {
    int sum = 0, given = 0;
    for (const int order : criterion.orders) {
        const OrderCourse& course = state.orders[static_cast<std::size_t>(order)];
        if (course.given < 0) continue;
        ++given;
        if (mark.began < 0) mark.began = course.given;
        const int milli = order_milli(lesson.orders[static_cast<std::size_t>(order)], course, tick, open);
        if (milli < 1000 && mark.worst_tick < 0) mark.worst_tick = tick, mark.wrong = order + 1;
        sum += milli;
    }
    if (given == 0) return;
    mark.step = given;
    mark.milli = (2 * sum + given) / (2 * given);
    mark.state = CriterionState::open;
}

/// A report that came too early was wrong, and costs half of the right one's.
int after_wrong_ones(int milli, const Mark& mark) {
    return mark.wrong > 0 ? milli / 2 : milli;
}

/// One of several reports that are asked for. earned: thousandths.
void count(const Criterion& criterion, Mark& mark, int earned, std::int64_t tick) {
    if (earned == 0) ++mark.wrong;
    mark.outside += earned; // of all reports together
    ++mark.step;
    mark.state = CriterionState::open;
    mark.milli = static_cast<int>(mark.outside / criterion.count);
    if (mark.step >= criterion.count) decide(mark, mark.milli, tick);
}

/// A report of how the cable grows is right when it was so within ten seconds of it, before or after.
void look_at_growth(const Criterion& criterion, Mark& mark, const Look& look) {
    if (mark.said == exercise::Growing::not_given) return;
    const bool so = look.state.growth.at(static_cast<std::size_t>(criterion.side)).lately(mark.said);
    if (!so && look.tick() - mark.since < ticks(kGrowthAround, look)) return;
    mark.said = exercise::Growing::not_given;
    count(criterion, mark, so ? 1000 : 0, look.tick());
}

void look_at_report(const Criterion& criterion, Mark& mark, const Look& look) {
    if (criterion.truth == ReportTruth::growth) look_at_growth(criterion, mark, look);
    if (criterion.truth != ReportTruth::moment) {
        if (mark.began < 0 && (!criterion.from || look.holds(*criterion.from)))
            mark.began = look.tick(), mark.state = CriterionState::open;
        return;
    }
    const std::int64_t truth = look.state.moments[static_cast<std::size_t>(criterion.truth_moment)].first;
    if (truth < 0) return;
    if (mark.began < 0) mark.began = truth, mark.state = CriterionState::open, mark.milli = 1000;
    if (mark.since >= 0 && mark.since < truth) { // said before it was so
        const std::int64_t early = truth - mark.since;
        mark.outside = -early;
        if (early <= ticks(criterion.early, look)) return decide(mark, after_wrong_ones(1000, mark), truth);
        ++mark.wrong;
        mark.since = -1;
    } else if (mark.since >= 0) {
        mark.outside = mark.since - truth;
        const int milli = mark.outside <= ticks(criterion.full, look)   ? 1000
                          : mark.outside <= ticks(criterion.half, look) ? 500
                                                                        : 0;
        return decide(mark, after_wrong_ones(milli, mark), look.tick());
    }
    if (look.tick() - truth > ticks(criterion.half, look)) decide(mark, 0, look.tick());
}

double hours_apart(double a, double b) {
    const double apart = std::fmod(std::abs(a - b), 12.0);
    return std::min(apart, 12 - apart);
}

/// 0 up and down .. 3 long, and how near (deg) the next class is.
int stay_off(exercise::StayGiven given, double top_angle_deg) {
    if (given == exercise::StayGiven::not_given) return 0;
    constexpr double kBorders[] = {75, 50, 25};
    constexpr double kNear = 5; // deg, in which either class is right
    const int said = static_cast<int>(given) - 1;
    int least = 3;
    for (const double shift : {-kNear, 0.0, kNear}) {
        int is = 0;
        for (const double border : kBorders)
            if (top_angle_deg + shift <= border) ++is;
        least = std::min(least, std::abs(is - said));
    }
    return least;
}

/// By how many classes: none, moderate, much, too much weight on the windlass. It is the cable's pull at the
/// gypsy, whatever holds it, motor, brake or stopper, by the pull that the motor bears for half an hour.
int weight_off(exercise::CableWeight given, double pull, double duty_pull) {
    if (given == exercise::CableWeight::not_given) return 3;
    constexpr double kBorders[] = {0.3, 1, 1.5}; // of the duty pull; UR A3 allows 1.5 for two minutes
    int is = 0;
    for (const double border : kBorders)
        if (pull >= border * duty_pull) ++is;
    return std::abs(is - (static_cast<int>(given) - static_cast<int>(exercise::CableWeight::none)));
}

/// By how much a figure is wrong, in its own unit.
double figure_off(const Heard& report, const exercise::TackleView& tackle, const Lesson& lesson) {
    double truth = 0;
    constexpr double kShackle = 27.5, kDeck = 4,
                     kPipe = 1.5; // m; a mark on deck lies so far inboard of the lip
    const double out = tackle.chain.cable_out;
    const double angle = tackle.chain.top_angle * 180 / 3.14159265358979323846;
    switch (report.code) {
    case exercise::ReportCode::shackles_on_deck:
        truth = (out + kDeck) / kShackle;
        break;
    case exercise::ReportCode::shackles_in_pipe:
        truth = (out + kPipe) / kShackle;
        break;
    case exercise::ReportCode::shackles_in_water:
        truth = (out - tackle.hawse.z()) / kShackle;
        break;
    case exercise::ReportCode::turns:
        truth = std::abs(tackle.chain.turns);
        break;
    case exercise::ReportCode::weight:
        return weight_off(report.weight, tackle.windlass.gypsy_load,
                          lesson.gear.at(static_cast<std::size_t>(tackle.side)).duty_pull);
    case exercise::ReportCode::lead: {
        truth = tackle.chain.lead_clock;
        const double lead = report.lead == 0 || angle > 75 ? 0 : hours_apart(report.lead, truth);
        return std::max(lead,
                        2.0 * stay_off(report.stay, angle)); // the next class is worth what two hours are
    }
    default:
        return 0;
    }
    return std::abs(report.value - truth);
}

} // namespace

void look_at(const Criterion& criterion, Mark& mark, const Look& look) {
    if (mark.decided >= 0) return;
    switch (criterion.kind) {
    case CriterionKind::limit:
        return look_at_limit(criterion, mark, look);
    case CriterionKind::sequence:
        return look_at_sequence(criterion, mark, look);
    case CriterionKind::state_at:
        return look_at_state(criterion, mark, look);
    case CriterionKind::order:
        return look_at_orders(criterion, mark, look.tick(), true, look.state, look.lesson);
    case CriterionKind::report:
        return look_at_report(criterion, mark, look);
    case CriterionKind::prohibited:
        if (in_play(criterion, mark, look) && look.holds(criterion.that)) decide(mark, 0, look.tick());
        return;
    case CriterionKind::final:
        mark.began = look.state.begin;
        mark.state = CriterionState::open;
        mark.holds = look.holds(criterion.that);
        mark.milli = mark.holds ? 1000 : 0;
        return;
    case CriterionKind::rubric:
        return;
    }
}

void take_report(const Criterion& criterion, Mark& mark, const Heard& report, const Look& look) {
    if (criterion.kind != CriterionKind::report || report.code != criterion.report || mark.decided >= 0)
        return;
    if (report.side >= 0 && report.side != criterion.side) return;
    switch (criterion.truth) {
    case ReportTruth::moment:
        if (mark.since >= 0) ++mark.wrong; // the one before did not come true
        mark.since = look.tick();
        return;
    case ReportTruth::state:
        if (look.holds(criterion.that)) return decide(mark, after_wrong_ones(1000, mark), look.tick());
        ++mark.wrong;
        mark.worst_tick = look.tick();
        return;
    case ReportTruth::growth:
        if (mark.said != exercise::Growing::not_given) count(criterion, mark, 0, look.tick());
        mark.said = report.growing;
        mark.since = look.tick();
        if (mark.said == exercise::Growing::not_given) count(criterion, mark, 0, look.tick());
        return; // looked at from this tick on
    case ReportTruth::figure: {
        const double off = figure_off(report, *tackle_of(look.seen, criterion.side), look.lesson);
        if (mark.worst_tick < 0 || off > mark.worst) mark.worst = off, mark.worst_tick = look.tick();
        const int earned = off <= criterion.full_off ? 1000 : off <= criterion.half_off ? 500 : 0;
        return count(criterion, mark, earned, look.tick());
    }
    }
}

void close(const Criterion& criterion, Mark& mark, const State& state, const Lesson& lesson, int tick_rate) {
    if (mark.decided >= 0 || criterion.kind == CriterionKind::rubric) return;
    if (criterion.kind == CriterionKind::order)
        look_at_orders(criterion, mark, state.tick, false, state, lesson);
    if (criterion.kind == CriterionKind::report && criterion.truth == ReportTruth::moment) {
        const bool false_call = mark.began < 0 && (mark.since >= 0 || mark.wrong > 0);
        const bool no_time =
            mark.began >= 0 && state.tick - mark.began < std::llround(criterion.full * tick_rate);
        if (false_call) return decide(mark, 0, state.tick);
        mark.milli = 0;
        if (no_time) mark.state = CriterionState::not_in_play;
    }
    // Cut off between a moment and the look at it: nobody knows how it would have been.
    if (criterion.kind == CriterionKind::state_at && mark.state == CriterionState::open)
        mark.state = CriterionState::not_in_play;
    if (mark.state == CriterionState::open) decide(mark, mark.milli, state.tick);
}

} // namespace windlass::assess
