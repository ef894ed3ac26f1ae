#include "server/host/host.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <stdexcept>

namespace windlass::host {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLastWords{3000}; // for all that are closed together

} // namespace

void Host::open(const std::string& id, const exercise::ExerciseDef& def, run::SessionOptions options) {
    if (has(id)) throw std::invalid_argument(fmt::format("exercise {} is open on this server already", id));
    if (size() >= kMaxExercises)
        throw std::invalid_argument(
            fmt::format("{} exercises are open, as many as one server takes", size()));
    options.id = id;
    std::unique_ptr<HostedExercise> made;
    try {
        made = std::make_unique<HostedExercise>(member_, threads_, id, def, std::move(options));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("exercise {} ({}): {}", id, def.name, error.what()));
    }
    threads_.tasks.add(*exercises_.emplace(id, std::move(made)).first->second);
}

bool Host::close(const std::string& id, const std::string& reason) {
    const auto found = exercises_.find(id);
    if (found == exercises_.end()) return false;
    threads_.tasks.remove(*found->second);
    found->second->finish(reason, true);
    found->second->flush(kLastWords);
    exercises_.erase(found);
    return true;
}

void Host::close_all(const std::string& reason) {
    for (const auto& [id, exercise] : exercises_)
        threads_.tasks.remove(*exercise);
    for (const auto& [id, exercise] : exercises_)
        exercise->finish(reason, threads_.keeper != nullptr && threads_.keeper->ends_in_order());
    const auto end = Clock::now() + kLastWords;
    for (const auto& [id, exercise] : exercises_) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
        exercise->flush(std::max(left, std::chrono::milliseconds(0)));
    }
    exercises_.clear();
}

void Host::leave_all() {
    for (const auto& [id, exercise] : exercises_)
        threads_.tasks.remove(*exercise);
    exercises_.clear();
}

std::vector<HostedStatus> Host::status() const {
    std::vector<HostedStatus> all;
    all.reserve(size());
    for (const auto& [id, exercise] : exercises_)
        all.push_back(exercise->status());
    return all;
}

bool Host::all_ended() const {
    return size() > 0 && std::all_of(exercises_.begin(), exercises_.end(),
                                     [](const auto& one) { return one.second->ended(); });
}

bool Host::any_stopped_by_fault() const {
    return std::any_of(exercises_.begin(), exercises_.end(),
                       [](const auto& one) { return one.second->stopped_by_fault(); });
}

double Host::load() const {
    double sum = 0;
    for (const HostedStatus& each : status())
        sum += each.load / std::max(1.0, each.run.time_scale_achieved);
    return sum;
}

std::chrono::steady_clock::duration Host::longest_beat() const {
    std::chrono::steady_clock::duration longest{};
    for (const auto& [id, exercise] : exercises_)
        longest = std::max(longest, exercise->beat_lasts());
    return longest;
}

} // namespace windlass::host
