#pragma once
// Refusals as events, without letting a flood of bad samples wash the log away.

#include "server/run/inbox.hpp"

#include <deque>
#include <optional>
#include <string>

namespace windlass::run {

/// Every refusal is counted; the first few of each second become an event. Of those left out the last of each
/// topic and field waits until there is room for it, and is told with the number of the others: none is left
/// out because nothing else is refused after it.
class RefusalLog {
public:
    /// What is to be logged.
    struct Told {
        std::string text;
        int side = -1;
        double number = 0; ///< the value, or how many samples
    };

    /// This refusal at wall time now (s); nothing when there were too many already, and it waits.
    std::optional<Told> add(const Refusal& refusal, double now);

    /// The same for samples that found the mailbox full.
    std::optional<Told> add_overflow(std::uint64_t samples, double now);

    /// One that has waited, now that there is room. To be asked before more are added, until there is
    /// nothing.
    std::optional<Told> overdue(double now);

    std::uint64_t total() const { return total_; }

private:
    struct Waiting {
        std::string reason; ///< topic and field
        Told last;
        std::uint64_t others = 0;  ///< samples left out before it
        std::uint64_t samples = 0; ///< its own
    };
    static Told with_others(Waiting refusal);
    std::optional<Told> tell(Waiting refusal, double now);
    bool may_tell(double now);

    std::deque<Waiting> waiting_; // one of each reason, of which there are some hundred
    std::uint64_t total_ = 0;
    double allowance_ = 0, asked_ = 0;
    bool first_ = true;
};

} // namespace windlass::run
