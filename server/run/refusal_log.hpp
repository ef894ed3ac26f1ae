#pragma once
// Refusals as events, without letting a flood of bad samples wash the log away.

#include "server/run/inbox.hpp"

#include <optional>
#include <string>

namespace windlass::server {

/// Every refusal is counted; the first few of each second become an event. What was left out is told with
/// the next event that goes through.
class RefusalLog {
public:
    /// The text to log for this refusal at wall time now (s), or nothing when there were too many already.
    std::optional<std::string> add(const Refusal& refusal, double now);

    /// The same for samples that found the mailbox full.
    std::optional<std::string> add_overflow(std::uint64_t samples, double now);

    std::uint64_t total() const { return total_; }

private:
    bool may_tell(double now);
    std::string with_untold(std::string text);

    std::uint64_t total_ = 0, untold_ = 0;
    double allowance_ = 0, asked_ = 0;
    bool first_ = true;
};

} // namespace windlass::server
