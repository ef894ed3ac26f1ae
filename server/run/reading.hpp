#pragma once
// An exercise that is being read on another thread.

#include "server/exercise/definition/exercise_def.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>

namespace windlass::run {

/// s of wall time after which a file is not waited for any more that has not been read: a disk or a network
/// that hangs. What comes after the file has been read takes so many ticks of the model at most, on any
/// machine.
inline constexpr double kReadingTime = 60;

/// A file on its way from the disk to an exercise that can be opened, its prelude played.
struct Reading {
    std::future<exercise::ExerciseDef> def;           ///< or a std::exception with a text for people
    std::shared_ptr<const std::atomic<bool>> in_hand; ///< the file has been read; null: nobody tells

    /// There is an answer; or there will be none, as nobody reads.
    bool done() const {
        return !def.valid() || def.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }
    /// Not to be waited for any more, after so many s.
    bool hangs(double waited) const { return !done() && waited > kReadingTime && !(in_hand && *in_hand); }
};

} // namespace windlass::run
