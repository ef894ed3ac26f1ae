// Session: an exercise that is kept on disk, and taken up again when its server was lost.

#include "server/exercise/checkpoint.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace windlass::run {

using exercise::RunState;

namespace {

constexpr const char* kNotKept = "exercise.not_kept";

} // namespace

std::string clock_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// Goes on from the state that was kept, or says why it begins from its definition.
void Session::begin_after_loss() {
    const Resumption how = *std::exchange(options_.resumption, std::nullopt); // a reset begins without it
    if (!how.checkpoint.empty()) {
        go_on_from(read_state(how.checkpoint));
        look_for_the_beginning();
        kept_course_ = how.course;
        if (!(options_.realtime && how.time_scale == 0)) status_.time_scale = how.time_scale;
        status_.state = how.set_back.empty() ? how.state : RunState::paused;
        const char* const stands = status_.state == RunState::running ? "running" : "paused";
        log("exercise.taken_up",
            fmt::format("taken up again at {} after the server was lost, {}", clock_text(time_),
                        status_.state == RunState::ready ? "ready" : stands),
            -1, time_);
        hold_for_questions(); // where it was lost between a freeze and the word of it
        if (running()) watch_for_a_hand();
        brief();
    } else if (!how.refused.empty()) {
        log("exercise.not_taken_up", "begins anew after the server was lost: " + how.refused);
    }
    if (how.set_back.empty()) return;
    options_.wait = true; // it ended the server: somebody is to look at it
    alerts_.raise(alert("exercise.set_back", -1, time_, {how.set_back}));
}

void Session::report_keeping(const std::string& trouble) {
    const bool not_kept = !trouble.empty();
    if (std::exchange(not_kept_, not_kept) == not_kept) return;
    if (not_kept) {
        log(kNotKept, "not kept on disk: " + trouble);
        alerts_.raise(alert(kNotKept, -1, 0, {trouble}));
    } else {
        log("exercise.kept", "kept on disk again");
        alerts_.rectify(kNotKept, -1, tick_, time_);
    }
}

} // namespace windlass::run
