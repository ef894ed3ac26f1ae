#include "station/gateway/line_log.hpp"

#include <fmt/format.h>

namespace windlass::gateway {

namespace {
constexpr int kLinesASecond = 20;
}

void LineLog::tell(const std::string& line) {
    if (!write_) return;
    const std::scoped_lock lock{mutex_};
    const auto now = Clock::now();
    if (now - second_ > std::chrono::seconds{1}) {
        if (not_told_ > 0) write_(fmt::format("and {} more", not_told_));
        second_ = now;
        told_ = not_told_ = 0;
    }
    if (++told_ > kLinesASecond)
        ++not_told_;
    else
        write_(line);
}

} // namespace windlass::gateway
