#pragma once
// The alerts of every exercise of a classroom, of which a page has no more than a line each.

#include "station/gateway/feed.hpp"

#include <nlohmann/json.hpp>

namespace windlass::gateway {

/// The alert to be told first of samples of Alert, ForecastleAlert and ServerAlert: of those that wait to be
/// acknowledged the highest priority, of equal ones the latest (MSC.302(87) has them so). Its code, side,
/// priority (a number, as in Alert), text and raised_time, and waiting: how many there are. null: none waits.
/// A payload that is no alert is passed over.
nlohmann::json alert_to_tell(const std::vector<FramePtr>& frames);

class AlertWatch {
public:
    /// Hears alerts of these exercises and of no others from now on. An exercise that cannot be joined is
    /// left out.
    void follow(const SharedReaders& readers, const std::vector<std::string>& exercises);

    /// alert_to_tell() by exercise; exercises of which none waits are left out.
    nlohmann::json told() const;

private:
    std::map<std::string, std::unique_ptr<Feed>> feeds_; // by exercise
};

} // namespace windlass::gateway
