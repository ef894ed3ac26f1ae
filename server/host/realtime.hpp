#pragma once
// What goes first on a machine with other work: ticks, then the rest of a server, then everybody else.

#include <sched.h>

#include <string>
#include <vector>

namespace windlass::host {

/// Locks the memory of the process and puts the calling thread, and every thread it starts from now on,
/// under SCHED_FIFO. Returns what was refused, and what to do about it; the program runs without it.
std::vector<std::string> enter_realtime();

/// The calling thread ticks exercises: in a process that is in real time it goes before the others, so that
/// whatever a server does as it starts, or hears of one that does, delays no tick.
void go_before_others();

/// The calling thread works in what time the others leave; so do threads that it starts.
void leave_realtime();

/// The calling thread works in ordinary time, and where that is allowed goes before other programs there; so
/// do threads that it starts. For the network's own: of each server that joins or is lost they have so much
/// to hear of that in real time Linux would take the core from them for 50 ms, and from ticks with them.
void go_before_other_programs();

/// Gives the calling thread the scheduling back that it had, whatever it has been given meanwhile.
class SchedulingKept {
public:
    SchedulingKept();
    ~SchedulingKept();
    SchedulingKept(const SchedulingKept&) = delete;
    SchedulingKept& operator=(const SchedulingKept&) = delete;

private:
    const int policy_, nice_;
    sched_param parameters_{};
};

} // namespace windlass::host
