#include "server/host/neighbours.hpp"

#include <algorithm>
#include <limits>
#include <thread>
#include <tuple>

namespace windlass::host {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kSilence{3}; // status comes each second
constexpr std::size_t kMaxNeighbours = 64;  // as many as the topic keeps
// Servers on one host are connected within this, and then tell what they told last.
constexpr std::chrono::milliseconds kMeeting{150};
constexpr std::chrono::seconds kLongestMeeting{1};

/// ns since 1970, when the first of its exercises was opened; with none, later than any.
std::int64_t began(const ClassroomStatus& status) {
    std::int64_t first = std::numeric_limits<std::int64_t>::max();
    for (const auto& exercise : status.exercises())
        first = std::min(first, exercise.since_unix_ns());
    return first;
}

} // namespace

Neighbours::Neighbours(wire::Participant& member, const wire::WriterId& own)
    : own_(own),
      reader_(member, wire::topics::classroom_status,
              [this](const ClassroomStatus& status, const wire::WriterId& writer) { hear(status, writer); }) {
}

void Neighbours::hear(const ClassroomStatus& status, const wire::WriterId& writer) {
    if (writer == own_) return;
    const auto now = Clock::now();
    const std::lock_guard lock(mutex_);
    std::erase_if(heard_, [&](const auto& one) { return now - one.second.at > kSilence; });
    if (heard_.size() < kMaxNeighbours || heard_.contains(writer)) heard_[writer] = {status, now};
}

std::size_t Neighbours::count() const {
    const auto now = Clock::now();
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count_if(
        heard_.begin(), heard_.end(), [&](const auto& one) { return now - one.second.at <= kSilence; }));
}

void Neighbours::meet() const {
    const auto begun = Clock::now();
    std::this_thread::sleep_for(kMeeting);
    // One of the writers is our own.
    while (static_cast<int>(count()) + 1 < reader_.matched() && Clock::now() - begun < kLongestMeeting)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

template <class Condition>
bool Neighbours::any(Condition condition) const {
    const auto now = Clock::now();
    const std::lock_guard lock(mutex_);
    return std::any_of(heard_.begin(), heard_.end(), [&](const auto& one) {
        return now - one.second.at <= kSilence && condition(one.first, one.second.status);
    });
}

bool Neighbours::has_namesake(const std::string& name) const {
    return any([&](const auto&, const auto& theirs) { return theirs.server().to_string() == name; });
}

bool Neighbours::has_elder_namesake(const ClassroomStatus& own) const {
    return any([&](const wire::WriterId& writer, const ClassroomStatus& theirs) {
        return theirs.server() == own.server() &&
               std::tuple(began(theirs), writer) < std::tuple(began(own), own_);
    });
}

template <class Condition>
std::string Neighbours::find(const std::string& id, Condition condition) const {
    const auto now = Clock::now();
    const std::lock_guard lock(mutex_);
    for (const auto& [writer, heard] : heard_) {
        if (now - heard.at > kSilence) continue;
        std::string server = heard.status.server().to_string();
        for (const auto& exercise : heard.status.exercises())
            if (exercise.id().to_string() == id && condition(exercise, server)) return server;
    }
    return "";
}

std::string Neighbours::server_of(const std::string& id) const {
    return find(id, [](const auto&, const auto&) { return true; });
}

std::string Neighbours::earlier(const std::string& id, std::int64_t since_unix_ns,
                                const std::string& server) const {
    return find(id, [&](const ClassroomExercise& theirs, const std::string& whose) {
        return std::tuple(theirs.since_unix_ns(), whose) < std::tuple(since_unix_ns, server);
    });
}

} // namespace windlass::host
