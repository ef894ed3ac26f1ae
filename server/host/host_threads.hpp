#pragma once
// The threads of a process that hosts exercises.

#include "server/dds/publishing_pool.hpp"
#include "server/host/lookout.hpp"
#include "server/host/task_pool.hpp"
#include "server/host/timekeeping.hpp"
#include "server/keep/keeper.hpp"

#include <algorithm>

namespace windlass::host {

/// Tick, publish and look ahead for what hosts open; several hosts may share them. They go after their hosts.
struct HostThreads {
    /// ticking: threads that tick, at least one. Two write at the least: one that waits for a slow reader
    /// holds up half of it. keeping: has the exercises on disk; none: they are not kept.
    explicit HostThreads(unsigned ticking, keep::Keeper* keeping = nullptr)
        : keeper(keeping), publishing(std::max(2U, ticking)), tasks(ticking, [this] { publishing.call(); }) {}

    keep::Keeper* const keeper;
    Timekeeping timekeeping;
    Lookout lookout;
    dds::PublishingPool publishing;
    TaskPool tasks; // goes first
};

} // namespace windlass::host
