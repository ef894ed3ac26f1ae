#pragma once
// From the queue of what was heard to the tape, and an account of what became of each sample.

#include "recorder/record/sample_queue.hpp"
#include "recorder/record/tape.hpp"

#include <functional>

namespace windlass::recorder {

class TapeFeed {
public:
    /// Both outlive it.
    TapeFeed(SampleQueue& queue, Tape& tape) : queue_(queue), tape_(tape) {}

    /// Writes what has come since, waiting for the first at most so long; `written` is called for each.
    /// Throws mcap::WriteError when the system refuses.
    void write_what_came(std::chrono::milliseconds wait,
                         const std::function<void(const Sample&)>& written = {});
    /// The system refused: what still waits is lost. To be called when nothing is heard any more.
    void give_up();

    /// What the recording is closed with. ended: UTC.
    mcap::Strings closing(const std::string& ended, const std::string& because) const;

    std::uint64_t lost() const { return tape_.lost() + in_hand_; } ///< that could not be written
    std::uint64_t dropped() const;                                 ///< for which the queue had no room
    bool heard_something() const { return tape_.messages() + lost() + dropped() > 0; }

private:
    SampleQueue& queue_;
    Tape& tape_;
    std::uint64_t in_hand_ = 0; // samples taken from the queue and not yet given to the tape
};

} // namespace windlass::recorder
