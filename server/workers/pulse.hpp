#pragma once
// A worker's sign of life.

#include <chrono>

namespace windlass::workers {

/// What a process tells its supervisor through a pipe, so that one that hangs is known from one that is at
/// work. Without a supervisor it tells nobody.
class Pulse {
public:
    /// descriptor: the pipe's end to write to, not blocking; -1: there is no supervisor.
    explicit Pulse(int descriptor = -1) : descriptor_(descriptor) {}

    /// It opens its exercises, each of which may take long: call it between them.
    void starting() { tell('s'); }
    /// It serves: call it often. What is told is told five times a second.
    void serving();

private:
    void tell(char what) const;

    int descriptor_;
    std::chrono::steady_clock::time_point told_{};
};

} // namespace windlass::workers
