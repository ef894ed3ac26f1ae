#pragma once
// A bar on the terminal while long work goes on.

#include <chrono>
#include <string>

namespace windlass::lab {

/// Drawn on stderr when that is a terminal, five times in a second at most; nothing otherwise. Wiped at the
/// end.
class ProgressBar {
public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// share: 0..1 of the work that is done; what: now at work on.
    void show(double share, const std::string& what);

private:
    bool terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point last_;
};

} // namespace windlass::lab
