#include "server/host/server_group.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>

namespace windlass::host {

/// A name in the classroom, and the exercises that it has.
struct ServerGroup::Server {
    Server(ServerGroup& group, std::string called)
        : name(std::move(called)),
          host(group.servers_.empty() ? group.classroom_ : group.join_(), group.threads_),
          classroom(group.classroom_, name, host, group.ticking_, group.source_,
                    [&group] { return group.load(); }) {
        classroom.meet_others();
    }

    const std::string name;
    Host host;
    Classroom classroom;
};

ServerGroup::ServerGroup(Join join, std::string name, unsigned threads, ExerciseSource source,
                         keep::Keeper* keeper)
    : join_(std::move(join)),
      classroom_(join_()),
      name_(std::move(name)),
      ticking_(threads),
      source_(std::move(source)),
      threads_(threads, keeper) {
    add_server();
}

ServerGroup::~ServerGroup() = default;

bool ServerGroup::full() const {
    return std::ranges::all_of(servers_,
                               [](const auto& server) { return server->host.size() >= Host::kMaxExercises; });
}

void ServerGroup::add_server() {
    const std::size_t number = servers_.size() + 1;
    servers_.push_back(
        std::make_unique<Server>(*this, number == 1 ? name_ : fmt::format("{}.{}", name_, number)));
    if (number > 1) spdlog::info("the places of {} are taken: also server {}", name_, servers_.back()->name);
}

void ServerGroup::open(const std::string& id, const exercise::ExerciseDef& def, run::SessionOptions options) {
    if (std::ranges::any_of(servers_, [&](const auto& server) { return server->host.has(id); }))
        throw std::invalid_argument(fmt::format("exercise {} is open on this server already", id));
    if (full() && servers_.size() < kMaxServers) add_server();
    const auto room = std::ranges::find_if(
        servers_, [](const auto& server) { return server->host.size() < Host::kMaxExercises; });
    if (room == servers_.end())
        throw std::invalid_argument(
            fmt::format("{} exercises are open, as many as one process takes", kMaxExercises));
    (*room)->host.open(id, def, std::move(options));
}

std::string ServerGroup::server_of(const std::string& id) const {
    return servers_.front()->classroom.server_of(id);
}

void ServerGroup::serve() {
    for (const auto& server : servers_)
        server->classroom.serve();
    if (full() && servers_.size() < kMaxServers) add_server();
}

std::string ServerGroup::name_taken() const {
    const auto taken =
        std::ranges::find_if(servers_, [](const auto& server) { return server->classroom.name_taken(); });
    return taken == servers_.end() ? "" : (*taken)->name;
}

bool ServerGroup::gave_all_way() const {
    return std::ranges::any_of(servers_, [](const auto& server) { return server->classroom.gave_way(); }) &&
           std::ranges::all_of(servers_, [](const auto& server) { return server->host.size() == 0; });
}

bool ServerGroup::all_ended() const {
    const auto idle = [](const auto& server) { return server->host.size() == 0; };
    return !std::ranges::all_of(servers_, idle) && std::ranges::all_of(servers_, [&](const auto& server) {
        return idle(server) || server->host.all_ended();
    });
}

bool ServerGroup::any_stopped_by_fault() const {
    return std::ranges::any_of(servers_,
                               [](const auto& server) { return server->host.any_stopped_by_fault(); });
}

double ServerGroup::load() const {
    double sum = 0;
    for (const auto& server : servers_)
        sum += server->host.load();
    return sum;
}

std::chrono::steady_clock::duration ServerGroup::longest_beat() const {
    std::chrono::steady_clock::duration longest{};
    for (const auto& server : servers_)
        longest = std::max(longest, server->host.longest_beat());
    return longest;
}

void ServerGroup::close_all(const std::string& reason) {
    for (const auto& server : servers_)
        server->host.close_all(reason);
}

void ServerGroup::leave_all() {
    for (const auto& server : servers_)
        server->host.leave_all();
}

} // namespace windlass::host
