#pragma once
// The threads of a process that hosts exercises.

#include "server/dds/publishing_pool.hpp"
#include "server/host/task_pool.hpp"
#include "server/host/timekeeping.hpp"

#include <algorithm>

namespace windlass::host {

/// Tick and publish what hosts open; several hosts may share them. They go after their hosts.
struct HostThreads {
    /// ticking: threads that tick, at least one. Two write at the least: one that waits for a slow reader
    /// holds up half of it.
    explicit HostThreads(unsigned ticking)
        : publishing(std::max(2U, ticking)), tasks(ticking, [this] { publishing.call(); }) {}

    Timekeeping timekeeping;
    dds::PublishingPool publishing;
    TaskPool tasks; // goes first
};

} // namespace windlass::host
