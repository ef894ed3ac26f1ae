#include "recorder/resimulate/resimulation.hpp"

#include "server/config/config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace windlass::recorder {

using exercise::Exercise;

run::Course course_at(recording::Recording& recording, const Run& run, const Mark& mark) {
    try {
        assess::Assessor assessor;
        Exercise exercise = exercise::read_checkpoint(checkpoint_bytes(recording, run, mark),
                                                      config::check_definition, &assessor);
        return {std::move(exercise), std::move(assessor), mark.orders_taken};
    } catch (const exercise::CheckpointError& error) {
        throw Gap(fmt::format("the checkpoint at {:.2f} s: {}", mark.time, error.what()));
    }
}

std::string Divergence::text() const {
    std::string text = fmt::format("the state at tick {} is not the recorded one; at tick {} it still was",
                                   tick, agreed_tick);
    if (fields.empty()) text += "\n  no checkpoint follows that could show the fields";
    for (const auto& field : fields)
        text += fmt::format("\n  tick {}: {} was {}, and is {}", shown_tick, field.field, field.first,
                            field.second);
    return text;
}

Resimulation::Resimulation(recording::Recording& recording, const Run& run, const Mark& checkpoint)
    : recording_(recording),
      run_(run),
      course_(course_at(recording, run, checkpoint)),
      next_mark_(static_cast<std::size_t>(&checkpoint - run.marks.data())),
      next_order_(static_cast<std::size_t>(
          std::ranges::upper_bound(run.orders, checkpoint.orders_taken, {}, &run::OrderView::number) -
          run.orders.begin())) {
    if (!agrees(checkpoint))
        throw Gap(
            fmt::format("the checkpoint at {:.2f} s is not of the hash that is said of it", checkpoint.time));
}

/// Applies the orders of the present tick up to that number.
void Resimulation::take_orders(std::uint64_t last) {
    for (; next_order_ < run_.orders.size(); ++next_order_) {
        const auto& order = run_.orders[next_order_];
        if (order.tick > course_.exercise().tick() || order.number > last) break;
        if (!course_.is_next(order)) lost();
        course_.take(order);
        if (look_ && assessor().assesses()) look_(assessor());
    }
}

void Resimulation::lost() const {
    throw Gap(fmt::format("order {} is not in the recording; behind tick {} it cannot be gone through again",
                          course_.orders_taken() + 1, course_.exercise().tick()));
}

void Resimulation::step_to(std::uint64_t tick) {
    while (course_.exercise().tick() < tick) {
        take_orders(std::numeric_limits<std::uint64_t>::max());
        if (!course_.step())
            throw Gap(fmt::format("the state ceases to be finite at tick {}", course_.exercise().tick()));
        if (look_ && assessor().assesses()) look_(assessor());
    }
}

bool Resimulation::agrees(const Mark& mark) {
    step_to(mark.tick);
    take_orders(mark.orders_taken);
    if (course_.orders_taken() != mark.orders_taken) lost();
    if (course_.state_hash() != mark.state_hash) return false;
    return !mark.checkpoint || checkpoint_bytes(recording_, run_, mark) == course_.checkpoint();
}

/// What is different, by the next checkpoint from that state on.
Divergence Resimulation::part_at(const Mark& mark, std::uint64_t agreed_tick) {
    Divergence parting{.tick = mark.tick, .agreed_tick = agreed_tick, .shown_tick = mark.tick, .fields = {}};
    for (const Mark* shown = &mark; shown != run_.marks.data() + run_.marks.size(); ++shown) {
        if (!shown->checkpoint) continue;
        try {
            agrees(*shown);
        } catch (const Gap&) {
            return parting; // an order on the way there was lost
        }
        const run::Course recorded = course_at(recording_, run_, *shown);
        parting.shown_tick = shown->tick;
        parting.fields = exercise::differences(recorded.exercise(), course_.exercise());
        if (parting.fields.empty() && recorded.state_hash() != shown->state_hash)
            parting.fields.push_back({"Checkpoint.state_hash", std::to_string(shown->state_hash),
                                      std::to_string(recorded.state_hash())});
        if (parting.fields.empty() && !mark.checkpoint) {
            parting.shown_tick = mark.tick;
            parting.fields.push_back({"ExerciseTruth.state_hash", std::to_string(mark.state_hash),
                                      "of a state from which the next checkpoint comes as recorded"});
        }
        return parting;
    }
    return parting;
}

Agreement Resimulation::compare(double to_time) {
    const Mark* const first = &run_.marks[next_mark_];
    Agreement found{.from_tick = first->tick,
                    .to_tick = first->tick,
                    .from_time = first->time,
                    .to_time = first->time,
                    .parting = {}};
    const std::uint64_t orders_before = course_.orders_taken();
    for (; next_mark_ < run_.marks.size() && run_.marks[next_mark_].time <= to_time; ++next_mark_) {
        const Mark& mark = run_.marks[next_mark_];
        if (!agrees(mark)) {
            found.parting = part_at(mark, found.to_tick);
            break;
        }
        ++(mark.checkpoint ? found.checkpoints : found.hashes);
        found.to_tick = mark.tick;
        found.to_time = mark.time;
        found.orders = course_.orders_taken() - orders_before;
    }
    return found;
}

void Resimulation::go_through() {
    step_to(run_.marks.back().tick);
    take_orders(std::numeric_limits<std::uint64_t>::max());
    if (course_.orders_taken() < run_.marks.back().orders_taken) lost();
}

std::vector<std::uint8_t> Resimulation::state_at(double time) {
    const auto refuse = [](const Agreement& found) {
        if (found.parting)
            throw Gap("what was recorded does not come of its orders, as when another version of the "
                      "model recorded it: " +
                      found.parting->text());
    };
    refuse(compare(time));
    const double rate = course_.exercise().def().tick_rate_hz;
    step_to(std::max(course_.exercise().tick(), static_cast<std::uint64_t>(std::llround(time * rate))));
    auto state = course_.checkpoint();
    if (next_mark_ < run_.marks.size()) refuse(compare(run_.marks[next_mark_].time));
    return state;
}

} // namespace windlass::recorder
