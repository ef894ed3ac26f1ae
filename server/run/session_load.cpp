// Session: another exercise from a file, which is read while this one goes on.

#include "server/run/session.hpp"

#include "common/text.hpp"
#include "server/exercise/prelude.hpp"
#include "server/run/briefing.hpp"

#include <spdlog/fmt/fmt.h>

namespace windlass::run {

namespace {
constexpr std::size_t kWaiting = 64; // orders
constexpr const char* kReading = "exercise.reading";
} // namespace

void Session::begin_load(const RunOrder& order, const std::string& source) {
    loading_ = {.name = order.exercise,
                .source = source,
                .practice = order.practice,
                .reset = false,
                .file = {},
                .since = now_};
    if (!options_.load) return;
    loading_->file = options_.load(order.exercise);
    tell_reading();
}

/// A prelude takes seconds, or minutes on a busy machine: who waits for the answer knows that there will be
/// one.
void Session::tell_reading() {
    log(kReading, fmt::format("exercise \"{}\" is being read for {}", loading_->name, loading_->source));
}

/// The same exercise from its start. One that starts at anchor and came from a checkpoint must play its
/// prelude anew.
void Session::reset(const std::string& source) {
    const exercise::ExerciseDef again = def();
    if (exercise::anchored_by(again) != nullptr && !again.settled && options_.prepare) {
        loading_ = {.name = again.name,
                    .source = source,
                    .practice = false, // its definition says so
                    .reset = true,
                    .file = options_.prepare(again),
                    .since = now_};
        tell_reading();
        return;
    }
    exercise_ = exercise::Exercise(again);
    set_up();
    log("exercise.reset", "exercise reset by " + source);
}

void Session::wait_for_load(const ReceivedOrder& order) {
    if (waiting_.size() < kWaiting) {
        waiting_.push_back(order);
    } else {
        refuse("Order", order.source, "state", "loading",
               fmt::format("{} orders while a file is read for a LOAD", kWaiting));
    }
}

/// The file has been read, or is not to be waited for any more.
void Session::answer_load() {
    Loading done = std::move(*loading_);
    loading_.reset();
    try {
        if (!done.file.def.valid()) throw std::runtime_error("this server has no exercise folder");
        if (!done.file.done())
            throw std::runtime_error(fmt::format("a file that can be read within {:g} s", kReadingTime));
        exercise::ExerciseDef def = done.file.def.get();
        if (done.practice) put_to_practice(def);
        exercise_ = exercise::Exercise(def);
        set_up();
        if (done.reset)
            log("exercise.reset", "exercise reset by " + done.source);
        else
            log("exercise.loaded", "exercise loaded by " + done.source);
    } catch (const std::exception& error) {
        refuse("ExerciseCommand", done.source, "exercise", '"' + done.name + '"', printable(error.what()));
    }
}

/// Answers a LOAD when it can be, and carries out what has waited for that, up to the next LOAD.
void Session::take_what_waited() {
    while (loading_ || !waiting_.empty()) {
        if (!loading_) {
            const ReceivedOrder order = std::move(waiting_.front());
            waiting_.pop_front();
            std::visit([&](const auto& what) { carry_out(what, order); }, order.what);
            continue;
        }
        if (!loading_->file.done() && !loading_->file.hangs(now_ - loading_->since)) return;
        answer_load();
    }
}

} // namespace windlass::run
