#include "bench/lab/progress_bar.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace windlass::lab {

using Clock = std::chrono::steady_clock;

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(double share, const std::string& what) {
    const auto now = Clock::now();
    if (!terminal_ || (drawn_ && now - last_ < std::chrono::milliseconds(200))) return;
    last_ = now;
    drawn_ = true;
    const int full = static_cast<int>(24 * share);
    fmt::print(stderr, "\r\x1b[K[{:=<{}}{: <{}}] {:3.0f} % {}", "", full, "", 24 - full, 100 * share, what);
    std::fflush(stderr);
}

} // namespace windlass::lab
