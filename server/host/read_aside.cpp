#include "server/host/read_aside.hpp"

#include "server/exercise/prelude.hpp"
#include "server/host/realtime.hpp"

#include <atomic>
#include <optional>
#include <stdexcept>
#include <thread>

namespace windlass::host {

namespace {

constexpr int kMaxReading = 4;

std::atomic<int> reading = 0;

} // namespace

run::Reading read_aside(std::function<exercise::ExerciseDef()> read) {
    std::promise<exercise::ExerciseDef> promise;
    const auto in_hand = std::make_shared<std::atomic<bool>>(false);
    run::Reading begun{.def = promise.get_future(), .in_hand = in_hand};
    if (++reading > kMaxReading) {
        --reading;
        promise.set_exception(std::make_exception_ptr(
            std::runtime_error("a disk that answers: files asked for before have not been read yet")));
        return begun;
    }
    std::thread([read = std::move(read), promise = std::move(promise), in_hand]() mutable {
        leave_realtime(); // whatever the thread that asked for it is
        std::optional<exercise::ExerciseDef> def;
        try {
            def = read();
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
        *in_hand = true;
        --reading;
        if (!def) return;
        try {
            promise.set_value(exercise::with_prelude_played(std::move(*def)));
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
    }).detach();
    return begun;
}

} // namespace windlass::host
