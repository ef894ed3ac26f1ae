#pragma once
// Plays a script against the picture of the exercise. Knows no clock and no network: time is exercise time.

#include "trainee_client/mate.hpp"
#include "trainee_client/script.hpp"

#include <deque>

namespace windlass::trainee {

class Player {
public:
    Player(Script script, int side);

    /// Steps whose conditions hold now, in order; each is given out once. Between them orders are repeated
    /// back, where the script does so. Nothing of the script after its end or a failure, and nothing before
    /// the exercise has been heard. A mate's stay where they are until the next call.
    std::vector<const Step*> advance(const station::Picture& picture);

    bool finished() const; ///< every step has been taken; a mate never is

    /// Why the script cannot go on: a step timed out, or the exercise ended or began again. Names the step,
    /// what it waited for and what the values were.
    const std::optional<std::string>& failure() const { return failure_; }

    /// The step being waited for, in words; empty after the end.
    std::string waiting_for(const station::Picture& picture) const;

private:
    double since_step(const station::Picture& picture) const;
    void skip_what_is_not_ordered(const station::Picture& picture);
    void repeat_orders(const station::Picture& picture, std::vector<const Step*>& taken);
    void fail(const station::Picture& picture, const std::string& reason);

    const Script script_;
    const int side_;
    std::size_t next_ = 0;
    std::optional<double> step_time_;  ///< s, when the last step was taken, or the start
    std::uint64_t reports_before_ = 0; ///< how many had been heard at that time
    double last_time_ = 0;             ///< s, to notice an exercise that begins again
    std::optional<std::string> failure_;
    std::deque<Step> repeats_; ///< given out, which stay where they are
    std::optional<Mate> mate_;
    std::vector<Step> mates_; ///< given out
};

} // namespace windlass::trainee
