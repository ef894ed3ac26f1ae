#include "station/gateway/replays.hpp"

#include "idl/topics.hpp"
#include "idl/wire.hpp"
#include "station/gateway/orders.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::gateway {

using namespace std::chrono_literals;

namespace {

constexpr auto kShown = 60s; // a replay that nobody looks at goes on so long
constexpr std::size_t kMost = 4;

} // namespace

std::string Replays::show(const std::filesystem::path& recording) {
    const std::string name = recording.filename(), exercise = "replay-" + name;
    if (!wire::is_exercise_name(exercise))
        throw Refused("", "recording", name, "a name of 57 characters at most, to be replayed by a page");
    if (const auto running = all_.find(exercise);
        running != all_.end() && !running->second.process->ended()) {
        running->second.used = Clock::now();
        return exercise;
    }
    if (all_.size() >= kMost && !all_.contains(exercise))
        throw Refused("", "recording", name, fmt::format("{} replays at a time", kMost));
    std::vector<std::string> arguments{"replay", recording.string(), "--partition",
                                       exercise, "--paused",         "--stay"};
    std::ranges::copy(arguments_, std::back_inserter(arguments));
    try {
        all_[exercise] = {std::make_unique<RecorderProcess>(recorder_, arguments), Clock::now()};
    } catch (const std::exception& error) {
        all_.erase(exercise);
        throw Refused("", "recording", name, error.what());
    }
    if (log_) log_("replaying " + recording.string() + " in exercise " + exercise);
    return exercise;
}

void Replays::looked_at(const std::string& exercise, Clock::time_point now) {
    if (const auto its = all_.find(exercise); its != all_.end()) its->second.used = now;
}

void Replays::tick(Clock::time_point now) {
    for (auto at = all_.begin(); at != all_.end();) {
        if (now - at->second.used > kShown) at->second.process->stop();
        at = at->second.process->ended() ? all_.erase(at) : std::next(at);
    }
}

} // namespace windlass::gateway
