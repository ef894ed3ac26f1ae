#include "lesson/whatif/candidates.hpp"

#include "server/assess/marks.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::whatif {

using assess::CriterionKind;
using assess::ReportTruth;
using exercise::ReportCode;
using exercise::ReportMade;

namespace {

constexpr std::size_t kMostMoves = 8; // looked at for one criterion
constexpr double kBehind = 2;         // s behind the loss in which a move is still looked at
constexpr double kSlow = 0.3;         // of the engine, slow ahead or astern

std::uint64_t tick_of(std::int64_t tick) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(tick, 0));
}

/// When it was lost: from then on, and until then a lever may still have made it better.
struct Lost {
    std::uint64_t from = 0, until = 0;
};
Lost lost_of(const Trials& trials, std::size_t criterion) {
    const assess::Mark& mark = trials.state().marks[criterion];
    const assess::Criterion& asked = trials.lesson().criteria[criterion];
    const std::uint64_t lost = trials.recorded().criteria[criterion].lost_tick;
    if (asked.kind == CriterionKind::limit) return {lost, std::max(lost, tick_of(mark.worst_tick))};
    if (asked.kind != CriterionKind::order) return {lost, lost};
    std::uint64_t until = 0; // the last of what was carried out late, or not at all
    for (const int order : asked.orders) {
        const assess::OrderCourse& course = trials.state().orders[static_cast<std::size_t>(order)];
        if (course.given < 0) continue;
        const bool late = course.done < 0 || (course.do_by >= 0 && course.done > course.do_by);
        if (late)
            until = tick_of(course.done >= 0 ? course.done : std::min(course.do_by, trials.state().ended));
    }
    return {std::max(lost, until), std::max(lost, until)};
}

Track track_of(const Trials& trials, const Lever& lever) {
    return track_of(lever, trials.orders(), trials.levers(), trials.first_tick());
}

/// Every move up to some time behind the loss, the last first, and no more than are looked at.
std::vector<Change> moves_before(const Trials& trials, std::uint64_t lost) {
    std::vector<Change> found;
    for (const Lever& lever : levers_of(trials)) {
        const Track track = track_of(trials, lever);
        for (const Move& move : moves_of(track, trials.tick_rate()))
            if (track[move.first].tick <= lost + trials.ticks(kBehind))
                found.push_back({.tick = track[move.first].tick,
                                 .was_tick = track[move.first].tick,
                                 .lever = lever,
                                 .value = track[move.last].value,
                                 .was_value = track[move.last].value});
    }
    std::ranges::stable_sort(found, std::greater{}, &Change::tick);
    if (found.size() > kMostMoves) found.resize(kMostMoves);
    return found;
}

/// The range of a lever that goes less or more.
std::pair<double, double> range_of(const Lever& lever) {
    return {lever.kind == LeverKind::brake ? 0 : -1, 1};
}

/// Places of reports of a criterion that were judged and not right, among the orders of all hands.
std::vector<std::size_t> wrong_reports(const Trials& trials, std::size_t criterion) {
    std::vector<std::size_t> found;
    const assess::Criterion& asked = trials.lesson().criteria[criterion];
    for (const assess::JudgedReport& judged : trials.state().judged) {
        if (judged.criterion != static_cast<int>(criterion) || judged.milli == 1000) continue;
        for (std::size_t k = 0; k < trials.orders().size(); ++k) {
            const auto* report = std::get_if<ReportMade>(&trials.orders()[k].command);
            if (report != nullptr && trials.orders()[k].tick == tick_of(judged.tick) &&
                assess::is_report(asked, report->code) && std::ranges::find(found, k) == found.end()) {
                found.push_back(k);
                break;
            }
        }
    }
    return found;
}

/// Ticks from which on a report might have been made and been right.
std::vector<std::uint64_t> when_true(const Trials& trials, std::size_t criterion) {
    const assess::State& state = trials.state();
    const assess::Criterion& asked = trials.lesson().criteria[criterion];
    const assess::Mark& mark = state.marks[criterion];
    std::vector<std::uint64_t> ticks;
    const auto add = [&](std::int64_t tick) {
        if (tick >= 0) ticks.push_back(tick_of(tick));
    };
    if (asked.truth == ReportTruth::moment)
        add(state.moments[static_cast<std::size_t>(asked.truth_moment)].first);
    else if (asked.truth == ReportTruth::state)
        add(mark.since);
    else if (asked.orders.empty())
        add(mark.began);
    for (const int order : asked.orders)
        add(state.orders[static_cast<std::size_t>(order)].done);
    return ticks;
}

/// A report with the figures that were true at that tick.
std::optional<ReportMade> true_at(Trials& trials, std::size_t criterion, std::uint64_t tick) {
    std::optional<ReportMade> report;
    trials.look_at(tick, [&](run::Course& course) {
        assess::State state = course.assessor().state();
        exercise::Snapshot seen;
        course.exercise().view_unhashed(seen);
        report = assess::true_report(trials.lesson().criteria[criterion],
                                     {trials.lesson(), state, seen, trials.tick_rate()});
    });
    return report;
}

void add_reports(Trials& trials, std::size_t criterion, std::vector<Candidate>& found) {
    constexpr double kAfter[] = {1, 3, 10}; // s behind the truth, in which it is said
    const assess::Criterion& asked = trials.lesson().criteria[criterion];
    const std::vector<std::size_t> wrong = wrong_reports(trials, criterion);
    const auto was = [&](std::size_t k) { return trials.orders()[k].tick; };
    const auto add = [&](std::uint64_t tick, std::optional<std::size_t> instead) {
        const auto report = true_at(trials, criterion, tick);
        if (!report) return;
        Candidate one{.change = {.kind = instead ? ChangeKind::report_moved : ChangeKind::report_given,
                                 .tick = tick,
                                 .report = *report},
                      .base = tick};
        if (instead) one.change.was_tick = was(*instead);
        found.push_back(std::move(one));
    };
    if (asked.truth == ReportTruth::figure || asked.truth == ReportTruth::growth)
        for (const std::size_t k : wrong)
            add(was(k), k); // in time, and with the right figure
    for (const double after : kAfter)
        for (const std::uint64_t tick : when_true(trials, criterion)) {
            const std::uint64_t then = tick + trials.ticks(after);
            if (then >= tick_of(trials.state().ended)) continue;
            for (const std::size_t k : wrong)
                add(then, k);
            add(then, std::nullopt);
        }
    for (const std::size_t k : wrong)
        found.push_back({.change = {.kind = ChangeKind::report_left_out,
                                    .tick = was(k),
                                    .was_tick = was(k),
                                    .report = std::get<ReportMade>(trials.orders()[k].command)},
                         .base = was(k)});
}

/// Orders that were not repeated back in time, or wrongly.
void add_repeats(const Trials& trials, std::size_t criterion, std::vector<Candidate>& found) {
    constexpr double kAfter = 1; // s
    for (const int place : trials.lesson().criteria[criterion].orders) {
        const assess::OrderCourse& course = trials.state().orders[static_cast<std::size_t>(place)];
        const exercise::BridgeOrderGiven& given =
            trials.lesson().orders[static_cast<std::size_t>(place)].given;
        const bool right = course.repeated >= 0 && course.in_time && !course.misrepeated;
        if (course.given < 0 || assess::repeat_within(given) <= 0 || right) continue;
        const std::uint64_t tick = tick_of(course.given) + trials.ticks(kAfter);
        Candidate one{.change = {.kind = ChangeKind::order_repeated,
                                 .tick = tick,
                                 .report = {.code = ReportCode::order_repeated,
                                            .side = given.side,
                                            .value = given.value,
                                            .order_number = course.number,
                                            .order_code = given.code}},
                      .base = tick};
        for (const run::OrderView& order : trials.orders()) { // the first that was wrong, or late
            const auto* report = std::get_if<ReportMade>(&order.command);
            if (report == nullptr || report->code != ReportCode::order_repeated ||
                report->order_number != course.number)
                continue;
            one.change.was_tick = order.tick;
            break;
        }
        found.push_back(std::move(one));
    }
}

/// The orders with what is said changed; given at that tick. Nothing: what was said is not there.
std::optional<std::vector<run::OrderView>> with_words(const Trials& trials, const Change& change,
                                                      std::uint64_t tick) {
    auto orders = trials.orders();
    if (change.was_tick) {
        const auto was = std::ranges::find_if(orders, [&](const run::OrderView& order) {
            const auto* report = std::get_if<ReportMade>(&order.command);
            return report != nullptr && order.tick == *change.was_tick &&
                   report->code == change.report.code &&
                   (change.kind != ChangeKind::order_repeated ||
                    report->order_number == change.report.order_number);
        });
        if (was == orders.end()) return std::nullopt;
        orders.erase(was);
    }
    if (change.kind == ChangeKind::report_left_out) return orders;
    const auto behind = std::ranges::upper_bound(orders, tick, {}, &run::OrderView::tick);
    orders.insert(behind, {.run = 0, .tick = tick, .number = 0, .source = {}, .command = change.report});
    return orders;
}

/// The lever's track with the change made to it; its move begins at that tick. Nothing: the moves before and
/// behind leave no room for it.
std::optional<Track> with_move(const Trials& trials, const Change& change, std::uint64_t tick) {
    Track track = track_of(trials, change.lever);
    if (change.kind == ChangeKind::one_more) {
        const auto behind = std::ranges::upper_bound(track, tick, {}, &Place::tick);
        if (behind == track.begin() || std::prev(behind)->tick == tick) return std::nullopt;
        track.insert(behind, {tick, change.value});
        return track;
    }
    const auto moves = moves_of(track, trials.tick_rate());
    const auto move = std::ranges::find_if(
        moves, [&](const Move& one) { return track[one.first].tick == change.was_tick; });
    if (move == moves.end()) return std::nullopt;
    if (change.kind == ChangeKind::left_out) {
        track.erase(track.begin() + static_cast<std::ptrdiff_t>(move->first),
                    track.begin() + static_cast<std::ptrdiff_t>(move->last) + 1);
        return track;
    }
    const double before = track[move->first - 1].value;
    const double way = track[move->last].value - before;
    for (std::size_t k = move->first; k <= move->last; ++k) {
        track[k].tick += tick - *change.was_tick; // unsigned, and back again where it is earlier
        if (change.kind == ChangeKind::more || change.kind == ChangeKind::less)
            track[k].value = k == move->last
                                 ? change.value
                                 : before + (track[k].value - before) * (change.value - before) / way;
    }
    const bool meets_before = track[move->first].tick <= track[move->first - 1].tick;
    const bool meets_behind =
        move->last + 1 < track.size() && track[move->last].tick >= track[move->last + 1].tick;
    const bool behind_the_end = track[move->last].tick > static_cast<std::uint64_t>(trials.state().ended);
    if (meets_before || meets_behind || behind_the_end) return std::nullopt;
    return track;
}

} // namespace

std::vector<Lever> levers_of(const Trials& trials) {
    std::vector<Lever> all;
    for (const exercise::Side side : trials.sides())
        for (const LeverKind kind :
             {LeverKind::brake, LeverKind::speed, LeverKind::clutch, LeverKind::stopper})
            all.push_back({kind, side});
    all.push_back({LeverKind::engine, {}});
    all.push_back({LeverKind::rudder, {}});
    return all;
}

std::vector<Candidate> words_that_help(Trials& trials, std::size_t criterion) {
    std::vector<Candidate> found;
    const CriterionKind kind = trials.lesson().criteria[criterion].kind;
    if (kind == CriterionKind::report) add_reports(trials, criterion, found);
    if (kind == CriterionKind::order) add_repeats(trials, criterion, found);
    return found;
}

std::vector<Candidate> moves_that_were_made(const Trials& trials, std::size_t criterion) {
    std::vector<Candidate> found;
    for (const Change& move : moves_before(trials, lost_of(trials, criterion).until)) {
        const auto add = [&](ChangeKind kind, double towards) {
            found.push_back({.change = move, .base = move.tick, .towards = towards});
            found.back().change.kind = kind;
        };
        add(ChangeKind::sooner, 0);
        add(ChangeKind::later, 0);
        if (move.lever.catches() || move.lever.kind == LeverKind::rudder) continue;
        add(ChangeKind::more, 1);
        add(ChangeKind::less, -1);
    }
    return found;
}

std::vector<Candidate> moves_left_out(const Trials& trials, std::size_t criterion) {
    std::vector<Candidate> found;
    for (Change& move : moves_before(trials, lost_of(trials, criterion).until)) {
        const Track track = track_of(trials, move.lever);
        move.kind = ChangeKind::left_out;
        move.value = value_at(track, move.tick - 1);
        found.push_back({.change = move, .base = move.tick});
    }
    return found;
}

std::vector<Candidate> moves_not_made(const Trials& trials, std::size_t criterion) {
    std::vector<Candidate> found;
    const std::uint64_t lost = lost_of(trials, criterion).from;
    for (const Lever& lever : levers_of(trials)) {
        std::vector<double> values{0, 1};
        if (lever.kind == LeverKind::rudder) continue;
        if (lever.kind == LeverKind::speed) values = {0};
        if (lever.kind == LeverKind::engine) values = {0, kSlow, -kSlow};
        for (const double value : values)
            found.push_back(
                {.change = {.kind = ChangeKind::one_more, .lever = lever, .value = value}, .base = lost});
    }
    return found;
}

std::optional<Change> of_size(const Trials& trials, const Candidate& candidate, int steps) {
    Change change = candidate.change;
    change.steps = steps;
    const std::uint64_t time = trials.ticks(steps * kStep);
    switch (change.kind) {
    case ChangeKind::sooner:
        if (candidate.base < time) return std::nullopt;
        change.tick = candidate.base - time;
        return change;
    case ChangeKind::later:
        change.tick = candidate.base + time;
        return change;
    case ChangeKind::more:
    case ChangeKind::less: {
        const auto [least, most] = range_of(change.lever);
        change.value = change.was_value + candidate.towards * kShare * steps;
        if (change.value < least - 1e-9 || change.value > most + 1e-9) return std::nullopt;
        change.value = std::clamp(change.value, least, most);
        return change;
    }
    case ChangeKind::one_more: {
        if (candidate.base < time + trials.first_tick()) return std::nullopt;
        change.tick = candidate.base - time;
        change.was_value = value_at(track_of(trials, change.lever), change.tick);
        if (change.was_value == change.value) return std::nullopt;
        return change;
    }
    default:
        change.steps = 0;
        return change;
    }
}

std::optional<Change> further(const Change& change, int steps) {
    const bool goes_elsewhere = change.kind == ChangeKind::more || change.kind == ChangeKind::less ||
                                change.kind == ChangeKind::one_more;
    if (!goes_elsewhere || change.lever.catches()) return std::nullopt;
    const auto [least, most] = range_of(change.lever);
    const bool at_a_stop = change.value == 0 || change.value <= least || change.value >= most;
    Change to = change;
    to.value += kShare * steps;
    if (at_a_stop || to.value < least || to.value > most) return std::nullopt;
    return to;
}

std::optional<Variation> varied(const Trials& trials, const Change& change, int nudge) {
    const bool has_time = change.kind != ChangeKind::report_left_out && change.kind != ChangeKind::left_out;
    if (nudge != 0 && !has_time) return std::nullopt;
    const std::uint64_t by = trials.ticks(std::abs(nudge) * kStep);
    const std::uint64_t tick = nudge < 0 ? change.tick - std::min(change.tick, by) : change.tick + by;
    Variation variation{.orders = {}, .from = std::min(tick, change.was_tick.value_or(tick))};
    if (change.kind <= ChangeKind::order_repeated) {
        auto orders = with_words(trials, change, tick);
        if (!orders) return std::nullopt;
        variation.orders = std::move(*orders);
        return variation;
    }
    const auto track = with_move(trials, change, tick);
    if (!track) return std::nullopt;
    variation.orders = with_track(trials.orders(), change.lever, *track, trials.levers());
    return variation;
}

} // namespace windlass::whatif
