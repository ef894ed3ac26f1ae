#pragma once
// Alerts that the server has raised, with their life after IMO MSC.302(87).

#include "server/run/received_order.hpp"
#include "server/run/status.hpp"

#include <string_view>
#include <vector>

namespace windlass::run {

/// Holds one alert for each code and side. Every change is noted, to be published.
class AlertBoard {
public:
    static constexpr double kSilence = 30; ///< s of wall time

    /// The condition arose: the alert is active and unacknowledged. tick, time, and texts come with it.
    void raise(AlertView alert);

    /// The condition ended: acknowledged alerts go back to normal, others wait for their acknowledgement.
    void rectify(std::string_view code, int side, std::uint64_t tick, double time);

    /// Whether it was raised, at time (s of exercise) or before, and its condition has not ended since.
    bool stands(std::string_view code, int side, double time) const;

    /// Acknowledges or silences at wall time now (s); false when there is no such alert, or nothing to do for
    /// it.
    bool acknowledge(const AlertOrder& order, std::uint64_t tick, double time, double now);

    /// What was silenced kSilence ago and is still not acknowledged sounds again (7.3.5).
    void sound_again(std::uint64_t tick, double time, double now);

    /// Alerts that changed since the last clear_changes().
    const std::vector<AlertView>& changes() const { return changes_; }
    void clear_changes() { changes_.clear(); }

private:
    AlertView* find(std::string_view code, int side);
    void change(AlertView& alert, AlertCondition condition, std::uint64_t tick, double time);

    std::vector<AlertView> alerts_;
    std::vector<AlertView> changes_;
};

} // namespace windlass::run
