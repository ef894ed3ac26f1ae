#include "server/host/read_aside.hpp"

#include <pthread.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace windlass::server {

namespace {

constexpr int kMaxReading = 4;

std::atomic<int> reading = 0;

/// Reads in what time the exercises leave, whatever the thread that asked for it is.
void leave_realtime() {
    const sched_param ordinary{};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
}

} // namespace

std::future<exercise::ExerciseDef> read_aside(std::function<exercise::ExerciseDef()> read) {
    std::promise<exercise::ExerciseDef> promise;
    auto future = promise.get_future();
    if (++reading > kMaxReading) {
        --reading;
        promise.set_exception(std::make_exception_ptr(
            std::runtime_error("a disk that answers: files asked for before have not been read yet")));
        return future;
    }
    std::thread([read = std::move(read), promise = std::move(promise)]() mutable {
        leave_realtime();
        try {
            promise.set_value(read());
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
        --reading;
    }).detach();
    return future;
}

} // namespace windlass::server
