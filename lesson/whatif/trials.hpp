#pragma once
// An attempt gone through again from one of its checkpoints in another way: with other orders, with the
// lesson's model hands in place of the recorded ones from some tick on, or with a sea that is a little
// another. Marked by the fold that marks the lesson live. The same variation comes to the same bits.

#include "lesson/seat.hpp"
#include "lesson/whatif/attempt.hpp"
#include "lesson/whatif/levers.hpp"
#include "server/run/course.hpp"

#include <optional>
#include <stop_token>

namespace windlass::whatif {

/// A criterion, and the mark that it is to have.
struct Goal {
    std::size_t criterion = 0; ///< place in the lesson's
    int milli = 1000;          ///< 0..1000, at least
    bool operator==(const Goal&) const = default;
};

/// What is tried.
struct Variation {
    std::vector<run::OrderView> orders; ///< of all hands, by tick
    std::uint64_t from = 0;             ///< the first tick at which they are not the recorded ones
    /// From this tick on the lesson's model hands have levers and voice.
    std::optional<std::uint64_t> model_from{};
    double more_water = 0;    ///< m, from the checkpoint before
    bool other_gusts = false; ///< another seed of gusts and waves, from the checkpoint before
};

/// What came of it.
struct Outcome {
    bool kept = false;     ///< the goal is met, no must is missed that was met, and there are more points
    assess::Result result; ///< of the lesson's end; empty where it was given up before
};

class Trials {
public:
    /// attempt: must outlive this. model: the scripts of the lesson's model run; none: no hands take over.
    /// Goes through the attempt as it was. Throws
    /// std::runtime_error when it has no lesson that came to its end, or when the states that it has do not
    /// come of its orders, as when another version of the model recorded them; exercise::CheckpointError.
    /// stop: gives up whatever is under way, by std::runtime_error.
    Trials(const Attempt& attempt, const std::vector<trainee::Script>& model, std::stop_token stop = {});

    const assess::Lesson& lesson() const { return *lesson_; }
    const assess::Result& recorded() const { return recorded_; } ///< the marks of the attempt as it was
    const assess::State& state() const { return state_; }        ///< of its end
    /// Whether the recorded hands have said the same before that tick.
    bool said_before(const exercise::ReportMade& report, std::uint64_t tick) const;
    /// Orders of hands and instructors; not what the lesson itself orders, which comes again by itself.
    const std::vector<run::OrderView>& orders() const { return orders_; }
    const LeversAtFirst& levers() const { return levers_; } ///< before any order
    std::uint64_t first_tick() const { return first_tick_; }
    int tick_rate() const { return tick_rate_; } ///< Hz
    std::uint64_t ticks(double seconds) const;
    double seconds(std::uint64_t tick) const { return static_cast<double>(tick) / tick_rate_; }
    /// Whether there are gusts or waves, so that another seed is another course.
    bool has_gusts() const { return has_gusts_; }
    const std::vector<exercise::Side>& sides() const { return sides_; }
    bool has_model() const { return !beside_.front().seats.empty(); }

    /// Tries it, until the lesson ends or the goal can no longer be kept.
    Outcome go(const Variation& variation, const Goal& goal);
    /// Shows the pictures of a variation, one each kLook from that tick on until the other, and the lesson's
    /// state at each; at the latest where the variation's lesson ends.
    void show(const Variation& variation, std::uint64_t from, std::uint64_t until,
              const std::function<void(const exercise::Snapshot&, const assess::State&)>& look);
    /// Where the attempt as it was has come to at a tick.
    void look_at(std::uint64_t tick, const std::function<void(run::Course&)>& look);
    /// What the model's hands do once they have taken over, until a tick.
    std::vector<run::OrderView> orders_of_model(std::uint64_t model_from, std::uint64_t until);

    /// What all trials have cost so far: their number, and s of exercise gone through.
    std::size_t tried() const { return tried_; }
    double gone_through() const { return seconds(ticks_gone_); }

private:
    /// The model's hands as they stand beside a trainee, and what they would have said.
    struct Hands {
        std::vector<lesson::Seat> seats;
        std::vector<exercise::ReportMade> said;
    };
    class Walk;

    std::size_t checkpoint_before(std::uint64_t tick) const;

    const Attempt& attempt_;
    std::stop_token stop_;
    std::optional<assess::Lesson> lesson_;
    assess::Result recorded_;
    assess::State state_;
    std::vector<run::OrderView> orders_;
    LeversAtFirst levers_;
    std::vector<exercise::Side> sides_;
    std::vector<Hands> beside_; ///< at each checkpoint
    std::uint64_t first_tick_ = 0;
    int tick_rate_ = 300;
    bool has_gusts_ = false;
    std::size_t tried_ = 0;
    std::uint64_t ticks_gone_ = 0;
};

} // namespace windlass::whatif
