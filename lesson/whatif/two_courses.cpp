#include "lesson/whatif/two_courses.hpp"

#include "server/assess/fold.hpp"
#include "server/assess/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::whatif {

using assess::CriterionKind;

namespace {

constexpr std::array kUsual{"cable_out", "cable_speed", "tension"};

/// A quantity of one side's cable, with what is allowed.
struct Asked {
    int side = 0;
    TwoCurves curves;
};

/// What a condition bounds: the part of it that did not hold, else the first. As bounds of what is asked for,
/// or, forbidden, without: what may not be has no least and no most.
std::optional<Asked> bounded(const assess::Condition& condition, int missing, bool forbidden) {
    if (condition.bounds.empty()) return std::nullopt;
    const auto count = static_cast<int>(condition.bounds.size());
    const assess::Bounds& bounds =
        condition.bounds[static_cast<std::size_t>(missing >= 0 && missing < count ? missing : 0)];
    Asked asked{condition.side, {.quantity = bounds.quantity, .was = {}, .would = {}}};
    if (!forbidden) {
        asked.curves.least = std::max(bounds.at_least, bounds.above);
        asked.curves.most = bounds.below;
    }
    return asked;
}

/// The quantity that the criterion looks at; nothing: it looks at what is said, or at what comes.
std::optional<Asked> asked_for(const Trials& trials, std::size_t criterion) {
    const assess::Criterion& asked = trials.lesson().criteria[criterion];
    const assess::Mark& mark = trials.state().marks[criterion];
    switch (asked.kind) {
    case CriterionKind::limit:
        return Asked{
            asked.side,
            {.quantity = asked.quantity, .least = asked.min, .most = asked.max, .was = {}, .would = {}}};
    case CriterionKind::state_at:
    case CriterionKind::final:
        return bounded(asked.that, mark.missing, false);
    case CriterionKind::prohibited:
        return bounded(asked.that, -1, true);
    case CriterionKind::sequence:
        if (const auto step = static_cast<std::size_t>(mark.step); step < asked.steps.size())
            return bounded(asked.steps[step], -1, false);
        return std::nullopt;
    default:
        return std::nullopt;
    }
}

/// The lever that is moved otherwise, and of the rudder the heading; nothing: it is a word.
std::optional<Asked> moved(const Answer& answer) {
    const std::optional<Change> change =
        answer.kept ? std::optional(answer.kept->change) : answer.taken_over->first;
    if (!change) return std::nullopt;
    switch (change->kind) {
    case ChangeKind::report_given:
    case ChangeKind::report_moved:
    case ChangeKind::report_left_out:
    case ChangeKind::order_repeated:
        return std::nullopt;
    default:
        break;
    }
    const Lever& lever = change->lever;
    const char* name = lever.kind == LeverKind::brake     ? "brake_position"
                       : lever.kind == LeverKind::speed   ? "speed_lever"
                       : lever.kind == LeverKind::clutch  ? "clutch_in"
                       : lever.kind == LeverKind::stopper ? "stopper_on"
                       : lever.kind == LeverKind::engine  ? "engine"
                                                          : "heading_deg"; // rudder
    const int side = lever.of_helm() ? 0 : static_cast<int>(lever.side);
    return Asked{side, {.quantity = assess::quantity_of(name), .was = {}, .would = {}}};
}

/// Whether anybody could see it: where the one run ends sooner, as far as both go.
bool differs(const Asked& asked) {
    constexpr double kSeen = 0.002; // of the largest value
    double largest = 0, apart = 0;
    const std::vector<Point>&was = asked.curves.was, &would = asked.curves.would;
    for (std::size_t k = 0; k < std::min(was.size(), would.size()); ++k) {
        largest = std::max({largest, std::abs(was[k].value), std::abs(would[k].value)});
        apart = std::max(apart, std::abs(was[k].value - would[k].value));
    }
    return apart > kSeen * largest;
}

Variation variation_of(const Trials& trials, const Answer& answer) {
    if (answer.kept) return *varied(trials, answer.kept->change);
    const std::uint64_t tick = trials.ticks(answer.taken_over->time);
    return {.orders = trials.orders(), .from = tick, .model_from = tick};
}

/// The first tick at which something is otherwise.
std::uint64_t changed_at(const Trials& trials, const Answer& answer) {
    if (!answer.kept) return trials.ticks(answer.taken_over->time);
    const Change& change = answer.kept->change;
    return std::min(change.tick, change.was_tick.value_or(change.tick));
}

} // namespace

std::optional<TwoCourses> two_courses(Trials& trials, const Answer& answer) {
    if (!answer.kept && !answer.taken_over) return std::nullopt;
    // What is drawn: the first of these in which anything moves otherwise.
    std::vector<std::vector<Asked>> ways;
    if (const auto asked = asked_for(trials, answer.criterion)) ways.push_back({*asked});
    const int side = trials.lesson().criteria[answer.criterion].side;
    ways.emplace_back();
    for (const char* usual : kUsual)
        ways.back().push_back({side, {.quantity = assess::quantity_of(usual), .was = {}, .would = {}}});
    if (const auto lever = moved(answer)) ways.push_back({*lever});

    const std::uint64_t changed = changed_at(trials, answer), before = trials.ticks(kWindowBefore);
    TwoCourses both{
        .changed = trials.seconds(changed), .lost = answer.lost_time, .curves = {}, .was = {}, .would = {}};
    const std::uint64_t from = std::max(trials.first_tick(), changed - std::min(changed, before));
    const std::uint64_t until =
        std::max(trials.ticks(answer.lost_time), changed) + trials.ticks(kWindowBehind);
    double last = trials.seconds(until); // s, of the pictures
    const auto go = [&](const Variation& variation, std::vector<Point> TwoCurves::*into,
                        std::optional<exercise::Snapshot>& picture) {
        trials.show(variation, from, until, [&](const exercise::Snapshot& seen, const assess::State& state) {
            if (!picture || seen.time <= last) picture = seen;
            for (std::vector<Asked>& way : ways)
                for (Asked& each : way)
                    if (const auto* tackle = assess::tackle_of(seen, each.side))
                        (each.curves.*into)
                            .push_back(
                                {seen.time, assess::figure(each.curves.quantity, seen, *tackle, state)});
        });
    };
    go(variation_of(trials, answer), &TwoCurves::would, both.would);
    if (both.would) last = both.would->time;
    go({.orders = trials.orders(), .from = from}, &TwoCurves::was, both.was);

    const auto found = std::ranges::find_if(
        ways, [&](const std::vector<Asked>& way) { return std::ranges::any_of(way, differs); });
    if (found != ways.end())
        for (Asked& each : *found)
            both.curves.push_back(std::move(each.curves));
    return both;
}

} // namespace windlass::whatif
