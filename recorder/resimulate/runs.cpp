#include "recorder/resimulate/runs.hpp"

#include "idl/topics.hpp"
#include "recorder/recording/typed.hpp"
#include "server/dds/order_taken.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace windlass::recorder {

namespace topics = wire::topics;

namespace {

constexpr double kRounding = 0.001; // s; times are shown and typed so, and a tick is longer

Run& run_of(std::vector<Run>& runs, std::uint64_t number) {
    const auto found = std::ranges::find(runs, number, &Run::number);
    if (found != runs.end()) return *found;
    runs.emplace_back().number = number;
    return runs.back();
}

template <class Sample>
Mark mark_of(const Sample& sample, recording::Nanoseconds log_time) {
    return {.tick = sample.tick(),
            .orders_taken = sample.orders_taken(),
            .time = sample.time(),
            .state_hash = sample.state_hash(),
            .checkpoint = std::is_same_v<Sample, Checkpoint>,
            .log_time = log_time};
}

void put_in_order(Run& run) {
    std::ranges::stable_sort(run.marks, {}, [](const Mark& mark) {
        return std::tuple(mark.tick, mark.orders_taken, !mark.checkpoint);
    });
    std::ranges::stable_sort(run.orders, {}, &run::OrderView::number);
    // Not std::ranges::unique: Clang 14 does not compile the subrange of GCC 12's library that it returns.
    const auto same_number = [](const auto& a, const auto& b) { return a.number == b.number; };
    run.orders.erase(std::unique(run.orders.begin(), run.orders.end(), same_number), run.orders.end());
}

/// An event of the server's, that it has taken an exercise up.
struct TakenUp {
    std::uint64_t tick = 0;
    recording::Nanoseconds log_time = 0;
};

/// It is the second run's: at the state with which that begins, and told when all of the first had been.
bool is_between(const TakenUp& event, const Run& before, const Run& run) {
    const Mark* const begins = run.first_checkpoint();
    const auto last = std::ranges::max(before.marks, {}, &Mark::log_time);
    return begins != nullptr && begins->orders_taken == 0 && event.tick == begins->tick &&
           event.log_time >= last.log_time;
}

} // namespace

const Mark* Run::checkpoint_before(double time) const {
    const Mark* last = nullptr;
    for (const Mark& mark : marks)
        if (mark.checkpoint && mark.time <= time + kRounding) last = &mark;
    return last;
}

bool Run::covers(double time) const {
    return checkpoint_before(time) != nullptr && time <= marks.back().time + kRounding;
}

const Mark* Run::first_checkpoint() const {
    const auto found = std::ranges::find(marks, true, &Mark::checkpoint);
    return found == marks.end() ? nullptr : &*found;
}

std::vector<Run> runs_of(recording::Recording& recording) {
    std::vector<Run> runs;
    std::vector<TakenUp> taken_up;
    auto cursor = recording.messages(
        {.topics = {topics::exercise_status.name, topics::exercise_truth.name, topics::checkpoint.name,
                    topics::order_taken.name, topics::event.name}});
    while (const auto message = cursor.next()) {
        if (message->topic() == topics::event.name) {
            const auto sample = recording::decode<Event>(message->payload);
            if (sample.code() == "exercise.taken_up") taken_up.push_back({sample.tick(), message->log_time});
        } else if (message->topic() == topics::order_taken.name) {
            auto order = dds::order_view(recording::decode<OrderTaken>(message->payload));
            run_of(runs, order.run).orders.push_back(std::move(order));
        } else if (message->topic() == topics::checkpoint.name) {
            const auto sample = recording::decode<Checkpoint>(message->payload);
            run_of(runs, sample.run()).marks.push_back(mark_of(sample, message->log_time));
        } else if (message->topic() == topics::exercise_truth.name) {
            const auto sample = recording::decode<ExerciseTruth>(message->payload);
            run_of(runs, sample.run()).marks.push_back(mark_of(sample, message->log_time));
        } else {
            const auto sample = recording::decode<ExerciseStatus>(message->payload);
            run_of(runs, sample.run()).exercise = sample.exercise().to_string();
        }
    }
    std::ranges::for_each(runs, put_in_order);
    for (std::size_t k = 1; k < runs.size(); ++k)
        runs[k].taken_up =
            !runs[k - 1].marks.empty() && std::ranges::any_of(taken_up, [&](const TakenUp& event) {
                return is_between(event, runs[k - 1], runs[k]);
            });
    return runs;
}

std::vector<std::span<const Run>> attempts_of(const std::vector<Run>& runs) {
    std::vector<std::span<const Run>> attempts;
    for (auto first = runs.begin(); first != runs.end();) {
        const auto end = std::find_if(first + 1, runs.end(), [](const Run& run) { return !run.taken_up; });
        attempts.emplace_back(first, end);
        first = end;
    }
    return attempts;
}

const Run& find_run(const std::vector<Run>& runs, std::size_t wanted, double time) {
    std::string there;
    const Run* found = nullptr;
    for (std::size_t k = 1; k <= runs.size(); ++k) {
        const Run& run = runs[k - 1];
        if (const Mark* first = run.first_checkpoint())
            there += fmt::format("{}run {} from {} to {}", there.empty() ? "" : ", ", k,
                                 clock_text(first->time), clock_text(run.marks.back().time));
        if ((wanted == 0 || wanted == k) && run.covers(time)) found = &run;
    }
    if (found != nullptr) return *found;
    throw std::runtime_error(
        fmt::format("{}{:g} s of exercise is not in the recording, which has {}",
                    wanted > 0 ? fmt::format("run {} at ", wanted) : "", time,
                    there.empty() ? "no state to go on from: no Checkpoint is in it" : there));
}

Moment shown_at(recording::Recording& recording, const std::vector<Run>& runs, double position) {
    const auto at = recording.start() + static_cast<recording::Nanoseconds>(position * 1e9);
    const auto message = recording.last_before(topics::exercise_status.name, at);
    if (!message)
        throw std::runtime_error(fmt::format("nothing is known of the exercise at {:g} s", position));
    const auto status = recording::decode<ExerciseStatus>(message->payload);
    const auto run = std::ranges::find(runs, status.run(), &Run::number);
    if (run == runs.end() || run->marks.empty())
        throw std::runtime_error(fmt::format("no state of the run at {:g} s is in the recording", position));
    // Status and states are told one after the other: the last state may be a moment older.
    const double time = std::min(status.time(), run->marks.back().time);
    return {&find_run(runs, static_cast<std::size_t>(run - runs.begin()) + 1, time), time};
}

std::string clock_text(double seconds) {
    const double minutes = std::floor(seconds / 60);
    return fmt::format("{:.0f}:{:06.3f}", minutes, seconds - 60 * minutes);
}

std::vector<std::uint8_t> checkpoint_bytes(recording::Recording& recording, const Run& run,
                                           const Mark& mark) {
    auto cursor = recording.messages(
        {.topics = {topics::checkpoint.name}, .from = mark.log_time, .until = mark.log_time + 1});
    while (const auto message = cursor.next()) {
        auto sample = recording::decode<Checkpoint>(message->payload);
        if (sample.run() == run.number && sample.tick() == mark.tick) return std::move(sample.data());
    }
    throw mcap::Damage("the checkpoint of tick " + std::to_string(mark.tick) + " cannot be read");
}

} // namespace windlass::recorder
