#include "lesson/whatif/search.hpp"

#include "lesson/play.hpp"

#include "lesson/whatif/candidates.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace windlass::whatif {

using assess::CriterionKind;

namespace {

constexpr std::array kSizes{2, 5, 15, 50, 150};    // steps
constexpr int kNudge = 2;                          // steps, that an answer must bear
constexpr std::array kMargins{0, 2, 4, 7, 12, 22}; // steps beyond the least, to make it sure
constexpr int kOthers = 3;                         // tried in place of an answer that chance decides
constexpr double kHalfSecond = 0.5;                // s, to which the last moment is told
constexpr std::array kBack{0, 5, 10, 20, 40, 80, 160, 320, 640, 1280, 2560}; // s before the loss
constexpr std::array kEarlier{0.0, 0.5, 1.0, 2.0, 4.0}; // s before the last moment, to make it sure
constexpr double kSeen = 0.3; // s, for which a lever of the model stands otherwise to be told

/// A change that was tried, and what came of it.
struct Tried {
    Change change;
    assess::Result result;
};

/// The search for one criterion.
class Search {
public:
    Search(Trials& trials, std::size_t criterion)
        : trials_(trials), criterion_(criterion), recorded_(trials.recorded().criteria[criterion]) {}

    Answer answer() {
        const std::size_t tried = trials_.tried();
        const double gone_through = trials_.gone_through();
        Answer answer{
            .criterion = criterion_, .lost = recorded_, .lost_time = trials_.seconds(recorded_.lost_tick)};
        answer.kept = change();
        if (!answer.kept && trials_.has_model()) answer.taken_over = take_over();
        answer.tried = trials_.tried() - tried;
        answer.gone_through = trials_.gone_through() - gone_through;
        return answer;
    }

    std::optional<TakenOver> take_over();

private:
    int milli_of(const assess::Result& result) const { return result.criteria[criterion_].milli; }

    /// Several orders or reports make up the mark, of which a change may mend one.
    bool counted() const {
        const assess::Criterion& asked = trials_.lesson().criteria[criterion_];
        return asked.kind == CriterionKind::order ||
               (asked.kind == CriterionKind::report && (asked.count > 1 || !asked.orders.empty()));
    }
    /// The mark with which the search is content.
    int enough() const { return counted() ? recorded_.milli + 1 : 1000; }
    /// What is worth telling where that cannot be had: that it is met, or more than it was.
    int least() const { return recorded_.met || counted() ? recorded_.milli + 1 : 500; }

    std::optional<Tried> attempt(const Change& change, int milli) {
        const auto variation = varied(trials_, change);
        if (!variation) return std::nullopt;
        const Outcome outcome = trials_.go(*variation, {criterion_, milli});
        if (!outcome.kept) return std::nullopt;
        return Tried{change, outcome.result};
    }

    /// The smallest change of a candidate between two sizes, of which the greater keeps it.
    Tried smallest(const Candidate& candidate, int too_small, Tried keeps, int milli) {
        for (int great = keeps.change.steps; great - too_small > 1;) {
            const int middle = too_small + (great - too_small) / 2;
            const auto change = of_size(trials_, candidate, middle);
            auto tried = change ? attempt(*change, milli) : std::nullopt;
            if (tried)
                keeps = std::move(*tried), great = middle;
            else
                too_small = middle;
        }
        return keeps;
    }

    struct Found {
        Candidate candidate;
        Tried tried;
    };

    /// The first size at which any candidate keeps enough of the mark, brought down to the smallest; else the
    /// best part of it.
    std::optional<Found> of_sizes(const std::vector<Candidate>& candidates) {
        std::optional<Found> part;
        int before = 0;
        for (const int size : kSizes) {
            std::optional<Found> whole;
            for (const Candidate& candidate : candidates) {
                // Another must be smaller than the one that is found.
                const auto change = of_size(trials_, candidate, whole ? whole->tried.change.steps - 1 : size);
                if (!change || change->steps <= before) continue;
                auto tried = attempt(*change, whole ? enough() : least());
                if (!tried) continue;
                const int milli = milli_of(tried->result);
                if (milli < enough() && part && milli <= milli_of(part->tried.result)) continue;
                Tried small = smallest(candidate, before, std::move(*tried), milli);
                if (milli < enough())
                    part = Found{candidate, std::move(small)};
                else
                    whole = Found{candidate, std::move(small)};
            }
            if (whole) return whole;
            before = size;
        }
        return part;
    }

    /// The first of those that have no size which keeps the whole mark; else the best part.
    std::optional<Found> one_of(const std::vector<Candidate>& candidates) {
        std::optional<Found> part;
        for (const Candidate& candidate : candidates) {
            auto tried = attempt(*of_size(trials_, candidate, 0), least());
            if (!tried) continue;
            const int milli = milli_of(tried->result);
            if (!part || milli > milli_of(part->tried.result)) part = Found{candidate, std::move(*tried)};
            if (milli == 1000) break;
        }
        return part;
    }

    /// What is said changes nothing about the ship; what was done may have been done otherwise; and last
    /// comes what was not done.
    std::optional<Found> find() {
        std::optional<Found> best;
        const auto search = [&](auto of, auto candidates) {
            if (best && milli_of(best->tried.result) >= enough()) return;
            auto all = candidates(trials_, criterion_);
            std::erase_if(all, [&](const Candidate& one) {
                return std::ranges::any_of(by_chance_, [&](const Change& other) {
                    return one.change.kind == other.kind && one.change.tick == other.tick &&
                           one.change.was_tick == other.was_tick && one.change.lever == other.lever &&
                           one.change.value == other.value;
                });
            });
            auto found = (this->*of)(all);
            if (found && (!best || milli_of(found->tried.result) > milli_of(best->tried.result)))
                best = std::move(found);
        };
        search(&Search::one_of, words_that_help);
        search(&Search::of_sizes, moves_that_were_made);
        search(&Search::one_of, moves_left_out);
        search(&Search::of_sizes, moves_not_made);
        return best;
    }

    /// Where chance decides the smallest, others that keep as much are tried in its place.
    std::optional<Kept> change() {
        std::optional<Kept> smallest;
        for (int k = 0; k <= kOthers; ++k) {
            const auto found = find();
            if (!found || (smallest && milli_of(found->tried.result) < milli_of(smallest->result))) break;
            Kept kept = made_sure(*found);
            if (kept.sure.stands()) return kept;
            by_chance_.push_back(found->candidate.change);
            if (!smallest) smallest = std::move(kept);
        }
        return smallest;
    }

    /// Nothing where the variation is none.
    std::optional<bool> stands(std::optional<Variation> variation, int milli, double water, bool gusts) {
        if (!variation) return std::nullopt;
        variation->more_water = water;
        variation->other_gusts = gusts;
        return trials_.go(*variation, {criterion_, milli}).kept;
    }

    /// once: no more is tried where something did not stand.
    Sure sure_of(const Change& change, int milli, bool once) {
        Sure sure;
        const auto look = [&](std::optional<bool>& at, std::optional<Variation> variation, double water,
                              bool gusts) {
            if (!once || sure.stands()) at = stands(std::move(variation), milli, water, gusts);
        };
        const auto with_lever = [&](int steps) {
            const auto to = further(change, steps);
            return to ? varied(trials_, *to) : std::nullopt;
        };
        look(sure.later, varied(trials_, change, kNudge), 0, false);
        look(sure.sooner, varied(trials_, change, -kNudge), 0, false);
        look(sure.more, with_lever(kNudge), 0, false);
        look(sure.less, with_lever(-kNudge), 0, false);
        look(sure.water, varied(trials_, change), lesson::kMillimetre, false);
        if (trials_.has_gusts()) look(sure.gusts, varied(trials_, change), 0, true);
        return sure;
    }

    /// The smallest change that stands; where none does, the least of all, which chance decides.
    Kept made_sure(const Found& found) {
        const Change& least_of_all = found.tried.change;
        const int milli = milli_of(found.tried.result);
        const bool has_size = least_of_all.steps > 0;
        for (const int margin : kMargins) {
            const auto greater =
                has_size ? of_size(trials_, found.candidate, least_of_all.steps + margin) : std::nullopt;
            const auto tried = !greater      ? std::nullopt
                               : margin == 0 ? std::optional(found.tried)
                                             : attempt(*greater, milli);
            if (!tried) continue;
            const Sure sure = sure_of(tried->change, milli, true);
            if (sure.stands()) return {tried->change, least_of_all.steps, sure, tried->result};
        }
        return {least_of_all, least_of_all.steps, sure_of(least_of_all, milli, false), found.tried.result};
    }

    std::uint64_t look_before(double time) const { // at which a hand looks
        return trials_.ticks(kStep) * static_cast<std::uint64_t>(std::max(time, 0.0) / kStep + 1e-6);
    }

    Variation with_model(std::uint64_t from) const {
        return {.orders = trials_.orders(), .from = from, .model_from = from};
    }

    /// The first word of the model's hands that the recorded ones have not said by then, nor soon after.
    std::optional<Change> first_word(const std::vector<run::OrderView>& model, std::uint64_t from) const {
        constexpr double kSoon = 5; // s
        for (const run::OrderView& order : model) {
            const auto* report = std::get_if<exercise::ReportMade>(&order.command);
            if (report == nullptr || order.tick < from ||
                trials_.said_before(*report, order.tick + trials_.ticks(kSoon)))
                continue;
            const bool repeats = report->code == exercise::ReportCode::order_repeated;
            return Change{.kind = repeats ? ChangeKind::order_repeated : ChangeKind::report_given,
                          .tick = order.tick,
                          .report = *report};
        }
        return std::nullopt;
    }

    /// The first lever that the model's hands have otherwise, and when; of what is judged by words, the first
    /// word where it comes before.
    std::optional<Change> first_otherwise(std::uint64_t from) {
        constexpr double kWhile = 120; // s
        const std::uint64_t until = from + trials_.ticks(kWhile);
        std::vector<run::OrderView> model;
        std::ranges::copy_if(trials_.orders(), std::back_inserter(model),
                             [&](const run::OrderView& order) { return order.tick < from; });
        for (run::OrderView& order : trials_.orders_of_model(from, until))
            model.push_back(std::move(order));
        std::optional<Change> first;
        for (const Lever& lever : levers_of(trials_)) {
            const Track was = track_of(lever, trials_.orders(), trials_.levers(), trials_.first_tick());
            const Track is = track_of(lever, model, trials_.levers(), trials_.first_tick());
            std::uint64_t since = 0;
            for (std::uint64_t tick = from; tick < until; tick += trials_.ticks(kStep)) {
                const bool same = std::abs(value_at(was, tick) - value_at(is, tick)) < kShare;
                if (same) since = 0;
                if (!same && since == 0) since = tick;
                if (since == 0 || tick - since < trials_.ticks(kSeen)) continue;
                if (!first || since < first->tick)
                    first = Change{.kind = ChangeKind::one_more,
                                   .tick = since,
                                   .lever = lever,
                                   .value = value_at(is, since),
                                   .was_value = value_at(was, since)};
                break;
            }
        }
        const assess::CriterionKind kind = recorded_.kind;
        if (kind == assess::CriterionKind::order || kind == assess::CriterionKind::report)
            if (const auto word = first_word(model, from); word && (!first || word->tick <= first->tick))
                return word;
        return first;
    }

    Trials& trials_;
    std::size_t criterion_;
    assess::CriterionResult recorded_;
    std::vector<Change> by_chance_{}; ///< what is not to be found again
};

std::optional<TakenOver> Search::take_over() {
    const double lost = trials_.seconds(recorded_.lost_tick), first = trials_.seconds(trials_.first_tick());
    const int milli = least();
    std::optional<double> helps, too_late;
    assess::Result result;
    const auto keeps = [&](double time) {
        const Outcome outcome = trials_.go(with_model(look_before(time)), {criterion_, milli});
        if (outcome.kept) helps = time, result = outcome.result;
        return outcome.kept;
    };
    for (const int back : kBack) {
        const double time = std::max(lost - back, first);
        if (keeps(time)) break;
        too_late = time;
        if (time == first) return std::nullopt;
    }
    if (!helps) return std::nullopt;
    while (too_late && *too_late - *helps > kHalfSecond) {
        const double middle = 0.5 * (*helps + *too_late);
        if (!keeps(middle)) too_late = middle;
    }
    TakenOver taken{.time = trials_.seconds(look_before(*helps)), .sure = {}, .result = result};
    for (const double earlier : kEarlier) {
        const double time = *helps - earlier;
        if (time < first || (earlier > 0 && !keeps(time))) continue;
        const std::uint64_t tick = look_before(time);
        Sure sure;
        if (tick > trials_.first_tick() + trials_.ticks(kNudge * kStep))
            sure.sooner = stands(with_model(tick - trials_.ticks(kNudge * kStep)), milli, 0, false);
        sure.water = stands(with_model(tick), milli, lesson::kMillimetre, false);
        if (trials_.has_gusts()) sure.gusts = stands(with_model(tick), milli, 0, true);
        if (earlier == 0) taken.sure = sure;
        if (!sure.stands()) continue;
        taken.time = trials_.seconds(tick);
        taken.sure = sure;
        taken.result = result;
        break;
    }
    taken.first = first_otherwise(look_before(taken.time));
    return taken;
}

/// The search for a criterion that was lost.
Search search_for(Trials& trials, const std::string& criterion) {
    const auto lost = lost_criteria(trials);
    if (std::ranges::find(lost, criterion) == lost.end())
        throw std::invalid_argument(criterion + ": nothing of it was lost");
    const auto& all = trials.recorded().criteria;
    const auto found = std::ranges::find(all, criterion, &assess::CriterionResult::code);
    return {trials, static_cast<std::size_t>(found - all.begin())};
}

} // namespace

std::vector<std::string> lost_criteria(const Trials& trials) {
    std::vector<assess::CriterionResult> lost; // by what was done: an answer is no deed
    std::ranges::copy_if(trials.recorded().criteria, std::back_inserter(lost), [](const auto& one) {
        return one.kind != CriterionKind::rubric && one.kind != CriterionKind::question &&
               one.state != assess::CriterionState::not_in_play && one.milli < 1000;
    });
    std::ranges::stable_sort(lost, {}, &assess::CriterionResult::lost_tick);
    std::vector<std::string> codes;
    for (const assess::CriterionResult& one : lost)
        codes.push_back(one.code);
    return codes;
}

Answer what_if(Trials& trials, const std::string& criterion) {
    return search_for(trials, criterion).answer();
}

std::optional<TakenOver> last_moment(Trials& trials, const std::string& criterion) {
    return search_for(trials, criterion).take_over();
}

} // namespace windlass::whatif
