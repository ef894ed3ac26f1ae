#include "instructor_console/classroom.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>

namespace windlass::console {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Servers = std::map<std::string, ClassroomStatus>;

constexpr auto kServerHeard = 15s; // a server that says each second how things stand
constexpr auto kOthers = 2s;       // after the first server: for those that it hears besides
constexpr auto kAnswers = 60s;     // a server that is heard answers within that, however busy its machine

/// This console in the classroom.
class Visit {
public:
    explicit Visit(wire::JoinOptions session)
        : name_(session.name), participant_([&] {
              session.partition = wire::kClassroomPartition;
              return session;
          }()) {}

    /// Those that are heard. enough: whether the one that is looked for is among them; while it is not, and
    /// one is missing that another hears, that one is waited for: a busy machine may need more than two
    /// seconds to find it.
    Servers servers(double timeout, const std::function<bool(const Servers&)>& enough = {}) {
        std::unique_lock lock(mutex_);
        if (!news_.wait_for(lock, std::chrono::duration<double>(timeout),
                            [this] { return !servers_.empty(); }))
            return servers_;
        if (!news_.wait_for(lock, kOthers, [this] { return complete(); }) && enough)
            news_.wait_for(lock, kServerHeard, [&] { return complete() || enough(servers_); });
        return servers_;
    }

    /// Sends it to the server that it names. done: by what in that server's status it shows.
    Answer give(ClassroomCommand& order, double timeout, std::string text,
                const std::function<bool(const ClassroomStatus&)>& done) {
        using Kind = Answer::Kind;
        const auto begun = Clock::now(), until = begun + std::chrono::duration_cast<Clock::duration>(
                                                             std::chrono::duration<double>(timeout));
        wire::Writer<ClassroomCommand> writer(participant_, wire::topics::classroom_command);
        const auto all = static_cast<int>(servers(0).size());
        while (writer.matched() < all && Clock::now() < until)
            std::this_thread::sleep_for(10ms);
        const auto unix_time = std::chrono::system_clock::now().time_since_epoch();
        order.origin().source(name_);
        order.origin().sent_unix_ns(std::chrono::nanoseconds(unix_time).count());
        order.origin().serial(static_cast<std::uint64_t>(order.origin().sent_unix_ns()));
        std::unique_lock lock(mutex_);
        refusal_.clear(); // those of earlier consoles of this name are kept for late joiners
        reading_ = false;
        about_ = order.id().to_string();
        lock.unlock();
        if (!writer.write(order)) return {Kind::none, "the order could not be sent: is it too long?", {}};
        lock.lock();
        bool shown = false;
        const auto answered = [&] {
            const auto server = servers_.find(order.server().to_string());
            shown = server != servers_.end() && done(server->second);
            return shown || !refusal_.empty();
        };
        news_.wait_until(lock, until, answered);
        // A server that is heard will answer, and one that says that it is at work however long it takes: a
        // busy machine may need all of the time until now to find the server's reader.
        const auto heard = [&] {
            return Clock::now() - heard_at_[order.server().to_string()] < kServerHeard;
        };
        while (!answered() && heard() && (reading_ || Clock::now() - begun < kAnswers))
            news_.wait_for(lock, 1s);
        const std::chrono::duration<double> waited = Clock::now() - begun;
        if (!refusal_.empty()) return {Kind::refused, refusal_, {}};
        if (shown) return {Kind::carried_out, std::move(text), {}};
        return {
            Kind::none,
            fmt::format("no answer from server {} in {:.0f} s", order.server().to_string(), waited.count()),
            {}};
    }

private:
    /// As many servers are heard as they hear of each other.
    bool complete() const {
        return std::all_of(servers_.begin(), servers_.end(),
                           [this](const auto& one) { return one.second.neighbours() < servers_.size(); });
    }
    void hear(const ClassroomStatus& status) {
        {
            const std::lock_guard lock(mutex_);
            servers_[status.server().to_string()] = status;
            heard_at_[status.server().to_string()] = Clock::now();
        }
        news_.notify_all();
    }
    void hear(const Event& event) {
        const std::string text = event.text().to_string(); // "TOPIC from SOURCE: FIELD = VALUE refused; ..."
        if (event.code() == "classroom.reading") {
            const std::lock_guard lock(mutex_);
            reading_ = reading_ || text.starts_with(fmt::format("exercise {}: the order of {} takes its time",
                                                                about_, name_));
            return;
        }
        if (event.code() != "command.refused" || text.find(" from " + name_ + ":") == std::string::npos)
            return;
        {
            const std::lock_guard lock(mutex_);
            refusal_ = text;
        }
        news_.notify_all();
    }

    const std::string name_;
    std::mutex mutex_;
    std::condition_variable news_;
    Servers servers_;
    std::map<std::string, Clock::time_point> heard_at_; // by server
    std::string refusal_;
    std::string about_;    // the exercise that the order is about
    bool reading_ = false; // its server says that it is at work
    wire::Participant participant_;
    // Last, so that they stop before what their callbacks use goes away.
    wire::Reader<ClassroomStatus> statuses_{participant_, wire::topics::classroom_status,
                                            [this](const ClassroomStatus& status) { hear(status); }};
    wire::Reader<Event> events_{participant_, wire::topics::event,
                                [this](const Event& event) { hear(event); }};
};

bool has(const ClassroomStatus& server, const std::string& id) {
    return std::any_of(server.exercises().begin(), server.exercises().end(),
                       [&](const ClassroomExercise& one) { return one.id() == id; });
}

Answer nobody() {
    return {Answer::Kind::no_server, "no server heard in the classroom of this domain", {}};
}

Answer failed(std::string text) {
    return {Answer::Kind::none, std::move(text), {}};
}

std::string names(const Servers& servers) {
    std::string text;
    for (const auto& [name, status] : servers)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

} // namespace

std::vector<ClassroomStatus> hear_servers(const wire::JoinOptions& session, double timeout) {
    std::vector<ClassroomStatus> all;
    for (auto& [name, status] : Visit(session).servers(timeout))
        all.push_back(std::move(status));
    return all;
}

Answer create_exercise(const wire::JoinOptions& session, const NewExercise& wanted, double timeout) {
    Visit visit(session);
    const auto servers = visit.servers(timeout, [&](const Servers& heard) {
        return !wanted.server.empty() && heard.contains(wanted.server);
    });
    if (servers.empty()) return nobody();
    const auto fewest =
        std::ranges::min_element(servers, {}, [](const auto& one) { return one.second.exercises().size(); });
    const auto server = wanted.server.empty() ? fewest->first : wanted.server;
    if (!servers.contains(server))
        return failed("no server " + server + " here; there are: " + names(servers));
    ClassroomCommand order;
    order.action(CLASSROOM_CREATE);
    order.server(server);
    order.id(wanted.id);
    order.exercise(wanted.file);
    order.definition().assign(wanted.definition.begin(), wanted.definition.end());
    order.wait(wanted.wait);
    order.practice(wanted.practice);
    const bool before = has(servers.at(server), wanted.id); // then only a refusal is an answer
    return visit.give(order, timeout, fmt::format("exercise {} created on server {}", wanted.id, server),
                      [&](const ClassroomStatus& now) { return !before && has(now, wanted.id); });
}

Answer remove_exercise(const wire::JoinOptions& session, const std::string& id, const std::string& server,
                       double timeout) {
    Visit visit(session);
    const auto servers = visit.servers(timeout, [&](const Servers& heard) {
        return std::ranges::any_of(heard, [&](const auto& one) { return has(one.second, id); });
    });
    if (servers.empty()) return nobody();
    ClassroomCommand order;
    order.action(CLASSROOM_REMOVE);
    order.id(id);
    order.server(server);
    for (const auto& [name, status] : servers)
        if (server.empty() && has(status, id)) order.server(name);
    if (order.server().size() == 0) return failed("no server here has an exercise " + id);
    return visit.give(order, timeout, fmt::format("exercise {} removed", id),
                      [&](const ClassroomStatus& now) { return !has(now, id); });
}

std::string classroom_text(const std::vector<ClassroomStatus>& servers) {
    std::string text;
    for (const auto& server : servers) {
        text += fmt::format("server {}: {} of {} exercises, {} threads\n", server.server().to_string(),
                            server.exercises().size(), server.max_exercises(), server.threads());
        for (const auto& one : server.exercises()) {
            text += fmt::format(
                "  {:<16} {:<9} {:>7}  scale {:.2f}  load {:4.1f} %  late {:.1f} ms  overruns {}  {}\n",
                one.id().to_string(), station::name(one.state()), station::clock(one.time()),
                one.time_scale_achieved(), 100 * one.load(), 1000 * one.lateness(), one.overruns(),
                one.exercise().to_string());
            if (one.failure().size() > 0) text += fmt::format("    failed: {}\n", one.failure().to_string());
        }
    }
    return text;
}

} // namespace windlass::console
