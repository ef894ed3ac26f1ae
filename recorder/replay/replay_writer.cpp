#include "recorder/replay/replay_writer.hpp"

#include <algorithm>
#include <utility>

namespace windlass::recorder {

namespace {
// Far more than people give between two looks; of a flood, the rest is not heard.
constexpr std::size_t kMaxCommands = 100;
} // namespace

ReplayWriter::ReplayWriter(const wire::JoinOptions& session)
    : participant_(session),
      statuses_(participant_, wire::topics::exercise_status, [](const auto&) {}),
      replay_status_(participant_, wire::topics::replay_status),
      reader_(participant_, wire::topics::replay_command,
              [this](const ReplayCommand& command, const wire::WriterId& writer) {
                  const std::lock_guard lock(mutex_);
                  if (commands_.size() < kMaxCommands) commands_.emplace_back(command, writer);
              }) {}

bool ReplayWriter::taken_by_another() const {
    return statuses_.matched() > (writers_.contains(wire::topics::exercise_status.name) ? 1 : 0);
}

void ReplayWriter::open(const std::set<std::string>& topics) {
    for (const auto& row : wire::topics::all) {
        if (!topics.contains(row.name)) continue;
        if (!row.from_server) throw std::logic_error(std::string("a replay does not write ") + row.name);
        writers_.try_emplace(row.name, participant_, row);
    }
}

bool ReplayWriter::write(const std::string& topic, wire::Bytes payload) {
    const auto writer = writers_.find(topic);
    return writer != writers_.end() && writer->second.write(payload);
}

void ReplayWriter::write(const ReplayStatus& status) {
    replay_status_.write(status);
}

void ReplayWriter::flush(std::chrono::milliseconds timeout) {
    using std::chrono::milliseconds, std::chrono::steady_clock;
    const auto end = steady_clock::now() + timeout;
    for (auto& [topic, writer] : writers_) {
        const auto left = std::chrono::duration_cast<milliseconds>(end - steady_clock::now());
        writer.wait_acknowledged(std::max(milliseconds(0), left));
    }
}

std::vector<std::pair<ReplayCommand, wire::WriterId>> ReplayWriter::take_commands() {
    const std::lock_guard lock(mutex_);
    return std::exchange(commands_, {});
}

} // namespace windlass::recorder
