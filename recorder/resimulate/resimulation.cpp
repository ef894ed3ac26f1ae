#include "recorder/resimulate/resimulation.hpp"

#include "server/config/config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace windlass::recorder {

using exercise::Exercise;

namespace {

Exercise read_mark(recording::Recording& recording, const Run& run, const Mark& mark,
                   assess::Assessor& assessor) {
    try {
        return exercise::read_checkpoint(checkpoint_bytes(recording, run, mark), config::check_definition,
                                         &assessor);
    } catch (const exercise::CheckpointError& error) {
        throw Gap(fmt::format("the checkpoint at {:.2f} s: {}", mark.time, error.what()));
    }
}

std::uint64_t hash_of(const Exercise& exercise) {
    exercise::Snapshot seen;
    exercise.view(seen);
    return seen.state_hash;
}

} // namespace

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
      exercise_(read_mark(recording, run, checkpoint, assessor_)),
      next_mark_(static_cast<std::size_t>(&checkpoint - run.marks.data())),
      next_order_(static_cast<std::size_t>(
          std::ranges::upper_bound(run.orders, checkpoint.orders_taken, {}, &run::OrderView::number) -
          run.orders.begin())),
      orders_taken_(checkpoint.orders_taken) {
    if (!agrees(checkpoint))
        throw Gap(
            fmt::format("the checkpoint at {:.2f} s is not of the hash that is said of it", checkpoint.time));
}

/// Applies the orders of the present tick up to that number.
void Resimulation::take_orders(std::uint64_t last) {
    for (; next_order_ < run_.orders.size(); ++next_order_) {
        const auto& order = run_.orders[next_order_];
        if (order.tick > exercise_.tick() || order.number > last) break;
        if (order.number != orders_taken_ + 1 || order.tick < exercise_.tick()) lost();
        exercise_.apply(order.command);
        assessor_.hear(order.command);
        if (look_ && assessor_.assesses()) look_(assessor_);
        orders_taken_ = order.number;
    }
}

void Resimulation::lost() const {
    throw Gap(fmt::format("order {} is not in the recording; behind tick {} it cannot be gone through again",
                          orders_taken_ + 1, exercise_.tick()));
}

void Resimulation::step_to(std::uint64_t tick) {
    const double dt = 1.0 / exercise_.def().tick_rate_hz;
    while (exercise_.tick() < tick) {
        take_orders(std::numeric_limits<std::uint64_t>::max());
        if (!exercise_.step(dt))
            throw Gap(fmt::format("the state ceases to be finite at tick {}", exercise_.tick()));
        if (!assessor_.assesses()) continue;
        exercise_.view(seen_);
        ordered_.clear(); // what the lesson orders is in the recording
        assessor_.fold(seen_, ordered_);
        if (look_) look_(assessor_);
    }
}

bool Resimulation::agrees(const Mark& mark) {
    step_to(mark.tick);
    take_orders(mark.orders_taken);
    if (orders_taken_ != mark.orders_taken) lost();
    if (hash_of(exercise_) != mark.state_hash) return false;
    return !mark.checkpoint ||
           checkpoint_bytes(recording_, run_, mark) == exercise::write_checkpoint(exercise_, &assessor_);
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
        assess::Assessor beside;
        Exercise recorded = read_mark(recording_, run_, *shown, beside);
        parting.shown_tick = shown->tick;
        parting.fields = exercise::differences(recorded, exercise_);
        if (parting.fields.empty() && hash_of(recorded) != shown->state_hash)
            parting.fields.push_back({"Checkpoint.state_hash", std::to_string(shown->state_hash),
                                      std::to_string(hash_of(recorded))});
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
    const std::uint64_t orders_before = orders_taken_;
    for (; next_mark_ < run_.marks.size() && run_.marks[next_mark_].time <= to_time; ++next_mark_) {
        const Mark& mark = run_.marks[next_mark_];
        if (!agrees(mark)) {
            found.parting = part_at(mark, found.to_tick);
            break;
        }
        ++(mark.checkpoint ? found.checkpoints : found.hashes);
        found.to_tick = mark.tick;
        found.to_time = mark.time;
        found.orders = orders_taken_ - orders_before;
    }
    return found;
}

void Resimulation::go_through() {
    step_to(run_.marks.back().tick);
    take_orders(std::numeric_limits<std::uint64_t>::max());
    if (orders_taken_ < run_.marks.back().orders_taken) lost();
}

std::vector<std::uint8_t> Resimulation::state_at(double time) {
    const auto refuse = [](const Agreement& found) {
        if (found.parting)
            throw Gap("what was recorded does not come of its orders, as when another version of the "
                      "model recorded it: " +
                      found.parting->text());
    };
    refuse(compare(time));
    const double rate = exercise_.def().tick_rate_hz;
    step_to(std::max(exercise_.tick(), static_cast<std::uint64_t>(std::llround(time * rate))));
    auto state = exercise::write_checkpoint(exercise_, &assessor_);
    if (next_mark_ < run_.marks.size()) refuse(compare(run_.marks[next_mark_].time));
    return state;
}

} // namespace windlass::recorder
