#pragma once
// Lines for whoever runs the program; of a flood, the first few each second.

#include "station/gateway/history.hpp"

#include <functional>
#include <mutex>
#include <string>

namespace windlass::gateway {

/// From any thread.
class LineLog {
public:
    using Write = std::function<void(const std::string&)>;

    /// write: as GatewayOptions::log; none: nothing is told.
    explicit LineLog(Write write) : write_{std::move(write)} {}

    void tell(const std::string& line);

private:
    const Write write_;
    std::mutex mutex_;
    Clock::time_point second_{};
    int told_ = 0, not_told_ = 0;
};

} // namespace windlass::gateway
