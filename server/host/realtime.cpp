#include "server/host/realtime.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <system_error>

namespace windlass::host {

namespace {

// Above all ordinary threads, below the kernel's own interrupt threads (50).
constexpr int kTicks = 20, kOthers = 19;
// A share of nine in ten beside a program of ordinary niceness.
constexpr int kNiceOfNetwork = -10;

int niceness() {
    return getpriority(PRIO_PROCESS, 0); // on Linux of the calling thread
}

void set_niceness(int nice) {
    setpriority(PRIO_PROCESS, 0, nice);
}

std::string reason() {
    return std::error_code(errno, std::generic_category()).message();
}

/// Programs and libraries are brought in whole, since a first use of theirs may wait for the disk. A page of
/// memory is taken at its first use, which costs a microsecond or two, and then stays: three quarters of what
/// an exercise has are for storms of events and heaps of cable that few ever see.
bool lock_memory() {
    return mlockall(MCL_CURRENT) == 0 && mlockall(MCL_FUTURE | MCL_ONFAULT) == 0;
}

} // namespace

std::vector<std::string> enter_realtime() {
    std::vector<std::string> refused;
    if (!lock_memory()) {
        refused.push_back("memory cannot be locked (" + reason() +
                          "): raise `ulimit -l` or give the program CAP_IPC_LOCK");
    }
    sched_param parameters{};
    parameters.sched_priority = kOthers;
    if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) {
        refused.push_back("SCHED_FIFO is refused (" + reason() +
                          "): raise `ulimit -r` to 20 or give the program CAP_SYS_NICE");
    }
    return refused;
}

void go_before_others() {
    sched_param parameters{};
    if (sched_getscheduler(0) != SCHED_FIFO) return;
    parameters.sched_priority = kTicks;
    sched_setscheduler(0, SCHED_FIFO, &parameters);
}

void leave_realtime() {
    const sched_param ordinary{};
    sched_setscheduler(0, SCHED_OTHER, &ordinary);
}

void go_before_other_programs() {
    leave_realtime();
    set_niceness(kNiceOfNetwork);
}

SchedulingKept::SchedulingKept() : policy_(sched_getscheduler(0)), nice_(niceness()) {
    sched_getparam(0, &parameters_);
}

SchedulingKept::~SchedulingKept() {
    sched_setscheduler(0, policy_, &parameters_);
    set_niceness(nice_);
}

} // namespace windlass::host
