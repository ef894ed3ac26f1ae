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

/// Of threads that begin from now on. Where memory is locked all of a stack is there at once, which is 8 MB
/// as a rule, and Fast DDS begins a thread for each port.
void keep_stacks_small() {
    constexpr std::size_t kStack = 2UL << 20; // bytes
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStack);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
}

} // namespace

std::vector<std::string> enter_realtime() {
    keep_stacks_small();
    std::vector<std::string> refused;
    if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
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
