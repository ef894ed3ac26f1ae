#include "server/assess/marks.hpp"

#include "server/assess/quantities.hpp"
#include "server/assess/questions.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/physics/base/units.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::assess {

namespace {

std::int64_t ticks(double seconds, const Look& look) {
    return std::llround(seconds * look.tick_rate);
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
    const double now =
        figure(criterion.quantity, look.seen, *tackle_of(look.seen, criterion.side), look.state);
    const bool upwards = criterion.max < kNoLimit;
    const double beyond = std::max(now - criterion.max, criterion.min - now);
    const double worst_beyond = std::max(mark.worst - criterion.max, criterion.min - mark.worst);
    if (mark.worst_tick < 0 || beyond > worst_beyond ||
        (!upwards && now < mark.worst && beyond >= worst_beyond))
        mark.worst = now, mark.worst_tick = look.tick();
    mark.holds = beyond <= 0;
    if (mark.holds) return;
    if (mark.since < 0) mark.since = look.tick();
    ++mark.outside;
    if (now < criterion.fail_below || now > criterion.fail_above) mark.wrong = 1;
    mark.milli = mark.wrong > 0
                     ? 0
                     : share_left(mark.outside, ticks(criterion.grace, look), ticks(criterion.zero, look));
}

/// Whether the lesson's end finds beyond its limit what is to be put right: for longer than is forgiven, or
/// for as long as there was, where an accident ended it. That it ended sooner makes it no less.
bool was_left_so(const Criterion& criterion, const Mark& mark, Ending ending, int tick_rate) {
    if (!criterion.put_right || mark.began < 0 || mark.holds || ending == Ending::instructor) return false;
    return ending == Ending::abort || mark.outside > std::llround(criterion.grace * tick_rate);
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

/// Why a condition does not hold, for the reason.
void keep_missing(Mark& mark, const MissingPart& missing) {
    mark.missing = missing.place;
    mark.worst = missing.value;
}

void look_at_state(const Criterion& criterion, Mark& mark, const Look& look) {
    const bool so = look.holds(criterion.that); // at every tick: it may have to hold for a while
    mark.acted = mark.acted || !so;
    const std::int64_t moment = look.state.moments[static_cast<std::size_t>(criterion.at)].first;
    if (moment < 0) return;
    if (mark.began < 0) mark.began = moment, mark.state = CriterionState::open, mark.milli = 1000;
    const std::int64_t since = look.tick() - moment, after = ticks(criterion.after, look);
    if (criterion.graded) { // the sooner, the more
        const std::int64_t zero = ticks(criterion.zero, look);
        mark.milli = share_left(since, after, zero);
        keep_missing(mark, so ? MissingPart{} : look.missing(criterion.that));
        if (!so && since < zero) return;
        return decide(mark, so ? mark.milli : 0, look.tick());
    }
    if (since < after) return;
    if (!so) keep_missing(mark, look.missing(criterion.that));
    decide(mark, so ? 1000 : 0, look.tick());
}

/// What an order has earned; open: what may still be earned counts as earned.
int order_milli(const LessonOrder& order, const OrderCourse& course, std::int64_t tick, bool open) {
    const int repeat_worth = repeat_within(order.given) > 0 ? 400 : 0;
    int repeated = 0, done = 0;
    if (course.repeated >= 0)
        repeated = !course.in_time ? 0 : course.misrepeated ? repeat_worth / 2 : repeat_worth;
    else if (open)
        repeated = repeat_worth;
    const int worth = 1000 - repeat_worth;
    if (course.done >= 0 || open) {
        const std::int64_t at = course.done >= 0 ? course.done : tick;
        const std::int64_t time =
            course.do_by - course.given; // that he has; nothing is left at twice as much more
        done = course.do_by < 0 ? worth : worth * share_left(at - course.given, time, 3 * time) / 1000;
    }
    // What was so already is done by whoever says that he has heard it.
    if (course.was_so && course.repeated < 0 && course.answered < 0 && !open) done = 0;
    return repeated + done;
}

void look_at_orders(const Criterion& criterion, Mark& mark, std::int64_t tick, bool open, const State& state,
                    const Lesson& lesson) {
    int sum = 0, given = 0;
    for (const int order : criterion.orders) {
        const OrderCourse& course = state.orders[static_cast<std::size_t>(order)];
        // What the bridge did not order any more, or took back, is nobody's to carry out; what it left out
        // because of a report that was not so, he has not carried out.
        if (left_out_falsely(course)) {
            ++given;
            if (mark.began < 0) mark.began = course.done;
            if (mark.worst_tick < 0) mark.worst_tick = tick, mark.wrong = order + 1;
        }
        if (course.given < 0 || course.challenged >= 0) continue;
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

/// A false call costs what silence costs, put right or not, but for those that are forgiven: half.
int after_wrong_ones(int milli, const Criterion& criterion, const Mark& mark) {
    return mark.wrong == 0 ? milli : mark.wrong <= criterion.false_calls ? milli / 2 : 0;
}

/// Keeps what was made of a report, and what was so.
void keep(const Criterion& criterion, State& state, const Lesson& lesson, JudgedReport report) {
    if (state.judged.size() >= kMostJudged) return;
    report.criterion = static_cast<int>(&criterion - lesson.criteria.data());
    state.judged.push_back(report);
}

/// The report that came last, which never came true.
JudgedReport as_never_true(const Mark& mark) {
    return {.tick = mark.reported, .milli = 0, .truth = mark.shown, .top_angle = mark.shown_angle};
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

/// A report of how the cable grows is right when it was so within ten seconds of it, before or after; the
/// word next to it is worth half.
void look_at_growth(const Criterion& criterion, Mark& mark, const Look& look) {
    using exercise::Growing;
    if (mark.said == Growing::not_given) return;
    const Growth& growth = look.state.growth.at(static_cast<std::size_t>(criterion.side));
    const bool so = growth.lately(mark.said);
    if (!so && look.tick() - mark.since < ticks(kGrowthAround, look)) return;
    const bool near = mark.said == Growing::growing
                          ? growth.lately(Growing::slack) || growth.lately(Growing::tight)
                          : growth.lately(Growing::growing);
    const int earned = so ? 1000 : near ? 500 : 0;
    keep(criterion, look.state, look.lesson, {.tick = mark.reported, .milli = earned, .growing = mark.said});
    mark.said = Growing::not_given;
    count(criterion, mark, earned, look.tick());
}

/// A report of a state that was not so yet: right when it comes to be so as soon as eye and ear could tell.
void look_at_pending(const Criterion& criterion, Mark& mark, const Look& look) {
    if (mark.pending < 0) return;
    const bool so = look.holds(criterion.that);
    if (!so && look.tick() - mark.pending < ticks(criterion.early, look)) return;
    const MissingPart missing = so ? MissingPart{} : look.missing(criterion.that);
    keep(criterion, look.state, look.lesson,
         {.tick = mark.pending, .milli = so ? 1000 : 0, .truth = missing.value, .missing = missing.place});
    mark.pending = -1;
    if (so) return decide(mark, after_wrong_ones(1000, criterion, mark), look.tick());
    ++mark.wrong;
    mark.worst_tick = look.tick();
}

/// Whether a report is as true or false before it is asked for as it is then: who hears that an anchor is
/// secured relies on it. What is stood by for hangs on the order.
bool counts_unasked(const Criterion& criterion) {
    return criterion.kind == CriterionKind::report && criterion.truth == ReportTruth::state &&
           criterion.report == exercise::ReportCode::secured;
}

/// One that was made before it was asked for, or after it had been judged: a false call once it was neither
/// made so nor taken back at once.
void look_at_unasked(const Criterion& criterion, Mark& mark, const Look& look) {
    if (!counts_unasked(criterion) || mark.reported < 0) return;
    if (look.holds(criterion.that)) {
        mark.reported = -1;
        return;
    }
    if (look.tick() - mark.reported < ticks(kRightAtOnce, look)) return;
    const MissingPart missing = look.missing(criterion.that);
    keep(criterion, look.state, look.lesson,
         {.tick = mark.reported, .milli = 0, .truth = missing.value, .missing = missing.place});
    mark.reported = -1;
    ++mark.wrong;
    mark.worst_tick = look.tick();
    if (mark.decided < 0) return;
    const int left = mark.milli > 0 ? after_wrong_ones(1000, criterion, mark) : 0;
    if (left < mark.milli) decide(mark, left, look.tick());
}

/// Place in the criterion's orders of the one that was given last, which a report belongs to; -1: none.
int slot_of(const Criterion& criterion, const State& state) {
    int slot = -1;
    for (std::size_t k = 0; k < criterion.orders.size(); ++k)
        if (state.orders[static_cast<std::size_t>(criterion.orders[k])].given >= 0)
            slot = static_cast<int>(k);
    return slot;
}

enum class Slot { answered, half, wrong };
std::int64_t slot_bit(int slot, Slot what) {
    return std::int64_t{1} << (slot + kSlots * static_cast<int>(what));
}

/// What reports that belong to orders have earned, of those orders that were given, or left out because of
/// a report that was not so.
void sum_slots(const Criterion& criterion, Mark& mark, const State& state) {
    int given = 0, sum = 0;
    for (std::size_t k = 0; k < criterion.orders.size(); ++k) {
        const OrderCourse& course = state.orders[static_cast<std::size_t>(criterion.orders[k])];
        if (left_out_falsely(course)) ++given;
        if (course.given < 0) continue;
        ++given;
        if (mark.since >= 0) mark.slots |= slot_bit(static_cast<int>(k), Slot::wrong);
        mark.since = -1;
        const auto is = [&](Slot what) { return (mark.slots & slot_bit(static_cast<int>(k), what)) != 0; };
        if (is(Slot::answered) && !is(Slot::wrong)) sum += is(Slot::half) ? 500 : 1000;
    }
    if (given == 0) return;
    if (mark.began < 0) mark.began = state.tick;
    mark.state = CriterionState::open;
    mark.step = given;
    mark.milli = sum / given;
}

/// Place in the criterion's orders of the newest whose figure was wrong; -1: none.
int slot_gone_wrong(const Criterion& criterion, const Mark& mark) {
    int slot = static_cast<int>(criterion.orders.size()) - 1;
    while (slot >= 0 && (mark.slots & slot_bit(slot, Slot::wrong)) == 0)
        --slot;
    return slot;
}

/// A figure that belongs to the order that was given last: right where and when that was carried out.
/// Another one that is wrong takes it away again, however often it is made; a wrong one before the first of
/// these orders takes that of the first. The first word on an order, where it is wrong, may be put right once
/// and at once, which leaves half of it: who says a third tries figures.
void take_for_order(const Criterion& criterion, Mark& mark, int earned, double reached, const Look& look) {
    const State& state = look.state;
    const bool in_time = mark.reported >= 0 && state.tick - mark.reported <= ticks(kRightAtOnce, look);
    const int put_right = earned > 0 && in_time ? slot_gone_wrong(criterion, mark) : -1;
    // The bridge may have gone on by what was wrong.
    const int slot = put_right >= 0 ? put_right : slot_of(criterion, state);
    if (earned == 0) ++mark.wrong;
    if (slot < 0) {
        mark.reported = earned == 0 && mark.since < 0 ? state.tick : -1;
        if (earned == 0)
            mark.since = state.tick;
        else if (in_time)
            mark.since = -1;
        return;
    }
    const std::int64_t answered = slot_bit(slot, Slot::answered), half = slot_bit(slot, Slot::half),
                       wrong = slot_bit(slot, Slot::wrong);
    const auto& given =
        look.lesson.orders[static_cast<std::size_t>(criterion.orders[static_cast<std::size_t>(slot)])].given;
    const bool there = given.value <= 0 || given.code == exercise::BridgeOrderCode::heave_to
                           ? given.value <= 0 || reached <= given.value + kThereShort
                           : reached >= given.value - kThereShort;
    if (earned == 0) {
        mark.reported = (mark.slots & (answered | half | wrong)) == 0 ? state.tick : -1;
        mark.slots |= wrong;
    } else {
        if (put_right >= 0) {
            mark.slots = (mark.slots & ~wrong) | half;
            mark.reported = -1;
        }
        if (there && (mark.slots & answered) == 0) mark.slots |= answered | (earned < 1000 ? half : 0);
    }
    sum_slots(criterion, mark, state);
}

void look_at_report(const Criterion& criterion, Mark& mark, const Look& look) {
    if (criterion.truth == ReportTruth::growth) look_at_growth(criterion, mark, look);
    if (criterion.truth == ReportTruth::state) look_at_pending(criterion, mark, look);
    if (criterion.truth == ReportTruth::figure && !criterion.orders.empty())
        return sum_slots(criterion, mark, look.state);
    if (mark.decided >= 0) return;
    if (criterion.truth != ReportTruth::moment) {
        if (mark.began < 0 && (!criterion.from || look.holds(*criterion.from)))
            mark.began = look.tick(), mark.state = CriterionState::open;
        const bool waits = criterion.truth == ReportTruth::state && mark.began >= 0 && mark.since < 0;
        if (waits && look.holds(criterion.that))
            mark.since = look.tick(); // he might have said it from now on
        return;
    }
    const std::int64_t truth = look.state.moments[static_cast<std::size_t>(criterion.truth_moment)].first;
    if (truth < 0) return;
    if (mark.began < 0) mark.began = truth, mark.state = CriterionState::open, mark.milli = 1000;
    if (mark.since >= 0 && mark.since < truth) { // said before it was so
        const std::int64_t early = truth - mark.since;
        mark.outside = -early;
        const bool right = early <= ticks(criterion.early, look);
        keep(criterion, look.state, look.lesson,
             {.tick = mark.reported, .milli = right ? 1000 : 0, .so = truth});
        if (right) return decide(mark, after_wrong_ones(1000, criterion, mark), truth);
        ++mark.wrong;
        mark.since = -1;
    } else if (mark.since >= 0) {
        mark.outside = mark.since - truth;
        const int milli = mark.outside <= ticks(criterion.full, look)   ? 1000
                          : mark.outside <= ticks(criterion.half, look) ? 500
                                                                        : 0;
        keep(criterion, look.state, look.lesson, {.tick = mark.reported, .milli = milli, .so = truth});
        return decide(mark, after_wrong_ones(milli, criterion, mark), look.tick());
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
    constexpr double kNear = 5; // deg, in which either class is right
    const int said = static_cast<int>(given) - 1;
    int least = 3;
    for (const double shift : {-kNear, 0.0, kNear})
        least = std::min(least, std::abs(static_cast<int>(words::stay_at(top_angle_deg + shift)) - said));
    return least;
}

/// By the pull that the motor bears for half an hour: 0 none, moderate, much, too much weight on the
/// windlass.
int weight_class(double pull, double duty_pull) {
    constexpr double kBorders[] = {0.3, 1, 1.5}; // of the duty pull; UR A3 allows 1.5 for two minutes
    int is = 0;
    for (const double border : kBorders)
        if (pull >= border * duty_pull) ++is;
    return is;
}

static_assert(words::units::shackle == physics::kShackleLength);

/// m, by which a mark at that place lies inboard of the lip.
double inboard_of_lip(words::MarkAt at, const exercise::TackleView& tackle) {
    if (at == words::MarkAt::deck) return words::limits::mark_on_deck;
    if (at == words::MarkAt::pipe) return words::limits::mark_in_pipe;
    return -tackle.hawse.z();
}

/// What was so of a figure, and by how much the report of it is wrong; both in its own unit.
struct FigureTruth {
    double said = 0, truth = 0, off = 0;
};
FigureTruth truth_of(const Heard& report, const exercise::TackleView& tackle, const Lesson& lesson) {
    double truth = 0;
    const double angle = physics::degrees_from_radians(tackle.chain.top_angle);
    if (const words::MarkAt at = words::row_of(report.code).mark_at; at != words::MarkAt::none) {
        truth = physics::shackles_from_metres(tackle.chain.cable_out + inboard_of_lip(at, tackle));
        return {report.value, truth, std::abs(report.value - truth)};
    }
    switch (report.code) {
    case exercise::ReportCode::turns:
        truth = std::abs(tackle.chain.turns);
        break;
    case exercise::ReportCode::weight: {
        // The cable's pull at the gypsy, whatever holds it, motor, brake or stopper.
        const int is = weight_class(tackle.windlass.gypsy_load,
                                    lesson.gear.at(static_cast<std::size_t>(tackle.side)).duty_pull);
        const int said = static_cast<int>(report.weight) - static_cast<int>(exercise::CableWeight::none);
        return {static_cast<double>(said), static_cast<double>(is), said < 0 ? 3.0 : std::abs(is - said)};
    }
    case exercise::ReportCode::lead: {
        truth = tackle.chain.lead_clock;
        const double lead =
            report.lead == 0 || angle > words::limits::stay_up_and_down ? 0 : hours_apart(report.lead, truth);
        // The next class of stay is worth what two hours are.
        return {static_cast<double>(report.lead), truth, std::max(lead, 2.0 * stay_off(report.stay, angle))};
    }
    default:
        return {};
    }
    return {report.value, truth, std::abs(report.value - truth)};
}

JudgedReport judged_figure(const Criterion& criterion, const Heard& report, const FigureTruth& figure,
                           const exercise::TackleView& tackle) {
    return {.tick = report.tick,
            .milli = figure.off <= criterion.full_off   ? 1000
                     : figure.off <= criterion.half_off ? 500
                                                        : 0,
            .code = report.code,
            .said = figure.said,
            .truth = figure.truth,
            .top_angle = physics::degrees_from_radians(tackle.chain.top_angle),
            .stay = report.stay};
}

/// What the tackle shows of that which a report of something that happens is about.
double shown_of(exercise::ReportCode code, const exercise::TackleView& tackle) {
    switch (code) {
    case exercise::ReportCode::short_stay:
    case exercise::ReportCode::up_and_down:
        return tackle.chain.lead_clock;
    case exercise::ReportCode::no_power:
        return tackle.windlass.power && !tackle.windlass.tripped ? 1 : 0;
    case exercise::ReportCode::does_not_run:
        return tackle.windlass.cable_speed;
    default:
        return static_cast<double>(tackle.anchor.phase);
    }
}

} // namespace

JudgedReport as_judged(const Criterion& criterion, const Heard& report, const exercise::TackleView& tackle,
                       const Lesson& lesson) {
    if (criterion.truth == ReportTruth::figure)
        return judged_figure(criterion, report, truth_of(report, tackle, lesson), tackle);
    return {.tick = report.tick,
            .truth = shown_of(report.code, tackle),
            .top_angle = physics::degrees_from_radians(tackle.chain.top_angle),
            .growing = report.growing};
}

void decide(Mark& mark, int milli, std::int64_t tick) {
    mark.milli = milli;
    mark.state = is_met(milli) ? CriterionState::met : CriterionState::not_met;
    mark.decided = tick;
}

bool is_report(const Criterion& criterion, exercise::ReportCode code) {
    const auto of_shackles = [](exercise::ReportCode one) {
        return words::row_of(one).mark_at != words::MarkAt::none;
    };
    return code == criterion.report || (of_shackles(code) && of_shackles(criterion.report));
}

std::optional<exercise::ReportMade> true_report(const Criterion& criterion, const Look& look) {
    using exercise::Growing;
    const exercise::TackleView* tackle = tackle_of(look.seen, criterion.side);
    if (criterion.kind != CriterionKind::report || tackle == nullptr) return std::nullopt;
    exercise::ReportMade report{.code = criterion.report, .side = criterion.side};
    if (criterion.truth == ReportTruth::growth) {
        const Growth& growth = look.state.growth.at(static_cast<std::size_t>(criterion.side));
        for (const Growing one : {Growing::growing, Growing::tight, Growing::slack})
            if (report.growing == Growing::not_given && growth.lately(one)) report.growing = one;
        if (report.growing == Growing::not_given) return std::nullopt;
    }
    if (criterion.truth != ReportTruth::figure) return report;
    const double truth = truth_of({.code = report.code, .side = report.side}, *tackle, look.lesson).truth;
    const double angle = physics::degrees_from_radians(tackle->chain.top_angle);
    switch (criterion.report) {
    case exercise::ReportCode::weight:
        report.weight = static_cast<exercise::CableWeight>(static_cast<int>(truth) + 1); // behind "not given"
        break;
    case exercise::ReportCode::lead:
        report.lead = static_cast<int>(std::lround(truth) + 11) % 12 + 1;
        report.stay = static_cast<exercise::StayGiven>(words::stay_at(angle) + 1); // behind "not given"
        break;
    default:
        report.value = 0.1 * std::round(10 * truth); // as it is said
    }
    return report;
}

double repeat_within(const exercise::BridgeOrderGiven& order) {
    return order.repeat_within > 0 ? order.repeat_within : words::row_of(order.code).repeat;
}

void look_at(const Criterion& criterion, Mark& mark, const Look& look) {
    look_at_unasked(criterion, mark, look);
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
    case CriterionKind::final: {
        const bool so = look.holds(criterion.that);
        if (mark.began < 0 && criterion.from && !look.holds(*criterion.from)) return;
        mark.acted = mark.acted || !so;
        if (mark.began < 0 || so != mark.holds) mark.since = look.tick();
        mark.began = look.state.begin;
        mark.state = CriterionState::open;
        mark.holds = so;
        mark.held = mark.held || so;
        keep_missing(mark, so ? MissingPart{} : look.missing(criterion.that));
        mark.milli = mark.holds ? 1000 : 0;
        return;
    }
    case CriterionKind::question:
        return look_at_question(criterion, mark, look);
    case CriterionKind::rubric:
        return;
    }
}

namespace {

/// Who says that the cable is up and down, or at short stay, says how she leads.
Heard as_lead(Heard report) {
    using exercise::ReportCode;
    const bool up_and_down = report.code == ReportCode::up_and_down;
    if (!up_and_down && report.code != ReportCode::short_stay) return report;
    report.code = ReportCode::lead;
    report.stay = up_and_down ? exercise::StayGiven::up_and_down : exercise::StayGiven::short_stay;
    return report;
}

/// A report as a criterion takes it.
Heard as_asked(const Criterion& criterion, const Heard& report) {
    const bool is_of_lead =
        criterion.kind == CriterionKind::report && criterion.report == exercise::ReportCode::lead;
    return is_of_lead ? as_lead(report) : report;
}

} // namespace

bool gives_a_figure(exercise::ReportCode code) {
    return code == exercise::ReportCode::growing || words::row_of(as_lead({.code = code}).code).half_off > 0;
}

bool is_false(const Heard& heard, const Look& look) {
    if (heard.side < 0 && look.lesson.two_sides) return false; // of which of the two he speaks nobody knows
    const int side = heard.side < 0 ? look.lesson.side : heard.side;
    const exercise::TackleView* tackle = tackle_of(look.seen, side);
    if (tackle == nullptr) return false;
    if (heard.code == exercise::ReportCode::growing)
        return !look.state.growth.at(static_cast<std::size_t>(side)).nearly(heard.growing);
    const Heard report = as_lead(heard);
    const double half_off = words::row_of(report.code).half_off;
    return half_off > 0 && truth_of(report, *tackle, look.lesson).off > half_off;
}

void take_report(const Criterion& criterion, Mark& mark, const Heard& heard, const Look& look) {
    const Heard report = as_asked(criterion, heard);
    if (report.side >= 0 && report.side != criterion.side) return;
    const bool takes_back =
        report.code == exercise::ReportCode::standing_by || report.code == exercise::ReportCode::anchor_ready;
    if (takes_back && counts_unasked(criterion)) mark.reported = -1;
    if (criterion.kind != CriterionKind::report || !is_report(criterion, report.code)) return;
    const bool before = criterion.from && mark.began < 0 && !look.holds(*criterion.from);
    if (before && criterion.truth == ReportTruth::state) mark.outside = report.tick; // worth telling
    if (counts_unasked(criterion) && (before || mark.decided >= 0)) {
        const bool of_which = report.side >= 0 || !look.lesson.two_sides; // else nobody knows
        if (of_which && mark.reported < 0) mark.reported = report.tick;
        return;
    }
    const auto judged = [&](JudgedReport one) { keep(criterion, look.state, look.lesson, one); };
    if (mark.decided >= 0) { // too late for a mark, and still worth telling
        if (criterion.truth == ReportTruth::moment && mark.since < 0)
            judged({.tick = report.tick, .milli = 0, .so = mark.began});
        return;
    }
    switch (criterion.truth) {
    case ReportTruth::moment:
        // Said again, to a question say, before the first could come true: that one stands.
        if (mark.since >= 0 && mark.began < 0 && look.tick() - mark.since <= ticks(criterion.early, look))
            return;
        if (mark.since >= 0) { // the one before did not come true
            ++mark.wrong;
            judged(as_never_true(mark));
        }
        mark.since = look.tick();
        mark.reported = report.tick;
        if (const exercise::TackleView* tackle = tackle_of(look.seen, criterion.side)) {
            const JudgedReport said = as_judged(criterion, report, *tackle, look.lesson);
            mark.shown = said.truth, mark.shown_angle = said.top_angle;
        }
        return;
    case ReportTruth::state: {
        if (before) return;                               // of something else
        if (mark.pending < 0) mark.pending = report.tick; // looked at from this tick on
        return;
    }
    case ReportTruth::growth:
        if (before) return;
        if (mark.said != exercise::Growing::not_given) { // another before it could be looked at
            judged({.tick = mark.reported, .milli = 0, .growing = mark.said});
            count(criterion, mark, 0, look.tick());
        }
        mark.said = report.growing;
        mark.since = look.tick();
        mark.reported = report.tick;
        if (mark.said == exercise::Growing::not_given) {
            judged({.tick = report.tick, .milli = 0});
            count(criterion, mark, 0, look.tick());
        }
        return; // looked at from this tick on
    case ReportTruth::figure: {
        const exercise::TackleView& tackle = *tackle_of(look.seen, criterion.side);
        const FigureTruth figure = truth_of(report, tackle, look.lesson);
        if (before) return; // of something else
        if (mark.worst_tick < 0 || figure.off > mark.worst)
            mark.worst = figure.off, mark.worst_tick = look.tick();
        JudgedReport one = judged_figure(criterion, report, figure, tackle);
        one.code = heard.code; // by which the debriefing finds it
        judged(one);
        if (!criterion.orders.empty())
            return take_for_order(criterion, mark, one.milli,
                                  tackle.chain.cable_out / physics::kShackleLength, look);
        return count(criterion, mark, one.milli, look.tick());
    }
    }
}

void close(const Criterion& criterion, Mark& mark, State& state, const Lesson& lesson, int tick_rate) {
    if (mark.decided >= 0 || criterion.kind == CriterionKind::rubric) return;
    if (criterion.kind == CriterionKind::order)
        look_at_orders(criterion, mark, state.tick, false, state, lesson);
    if (criterion.kind == CriterionKind::limit && was_left_so(criterion, mark, state.ending, tick_rate))
        mark.milli = 0;
    if (criterion.kind == CriterionKind::report && criterion.truth == ReportTruth::moment) {
        const bool false_call = mark.began < 0 && (mark.since >= 0 || mark.wrong > 0);
        const bool no_time =
            mark.began >= 0 && state.tick - mark.began < std::llround(criterion.full * tick_rate);
        if (mark.began < 0 && mark.since >= 0) keep(criterion, state, lesson, as_never_true(mark));
        if (false_call) return decide(mark, 0, state.tick);
        mark.milli = 0;
        if (mark.wrong == 0 && no_time) mark.state = CriterionState::not_in_play;
    }
    if (mark.pending >= 0) ++mark.wrong; // cut off before it was so
    if (counts_unasked(criterion) && mark.began < 0 && mark.wrong > 0) return decide(mark, 0, state.tick);
    if (criterion.question >= 0) state.questions[static_cast<std::size_t>(criterion.question)].open = false;
    if (criterion.kind == CriterionKind::question) {
        // The lesson was over at the very tick of the freeze: nobody could answer. What was never asked since
        // its cue never came to be so is lost, but where an instructor ended what could still have come.
        const bool asked = state.questions[static_cast<std::size_t>(criterion.question)].asked >= 0;
        if (asked == (state.ending != Ending::instructor)) mark.state = CriterionState::not_in_play;
    }

    // Cut off between a moment and the look at it: nobody knows how it would have been.
    if (criterion.kind == CriterionKind::state_at && mark.state == CriterionState::open) {
        const bool late = state.tick - mark.began > std::llround(criterion.after * tick_rate);
        if (criterion.graded && late)
            mark.milli = 0; // there was time for it
        else
            mark.state = CriterionState::not_in_play;
    }
    if (mark.state == CriterionState::open) decide(mark, mark.milli, state.tick);
}

} // namespace windlass::assess
