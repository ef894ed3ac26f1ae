#include "server/host/realtime.hpp"

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <system_error>

namespace windlass::host {

namespace {

// Above all ordinary threads, below the kernel's own interrupt threads (50).
constexpr int kTicks = 20, kOthers = 19;

std::string reason() {
    return std::error_code(errno, std::generic_category()).message();
}

} // namespace

std::vector<std::string> enter_realtime() {
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

SchedulingKept::SchedulingKept() : policy_(sched_getscheduler(0)) {
    sched_getparam(0, &parameters_);
}

SchedulingKept::~SchedulingKept() {
    sched_setscheduler(0, policy_, &parameters_);
}

} // namespace windlass::host
