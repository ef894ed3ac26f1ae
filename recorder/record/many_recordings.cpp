#include "recorder/record/many_recordings.hpp"

#include "recorder/command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace windlass::recorder {

using namespace std::chrono_literals;
using nlohmann::json;

namespace {
constexpr std::size_t kLongestLine = 16 << 10;
}

ManyRecordings::ManyRecordings(const wire::JoinOptions& session, const RecordingOptions& options)
    : session_(session), options_(options), member_(session), code_(kOk) {}

bool ManyRecordings::go_on(std::chrono::milliseconds wait) {
    const bool open = read_orders(wait);
    std::vector<std::string> over;
    for (auto& [exercise, recording] : recordings_)
        if (!recording.go_on(0ms)) over.push_back(exercise);
    for (const std::string& exercise : over)
        end(exercise, "");
    return open;
}

int ManyRecordings::end(const std::string& because) {
    while (!recordings_.empty())
        end(recordings_.begin()->first, because);
    return code_;
}

bool ManyRecordings::read_orders(std::chrono::milliseconds wait) {
    pollfd orders{STDIN_FILENO, POLLIN, 0};
    if (poll(&orders, 1, static_cast<int>(wait.count())) <= 0) return true; // nothing, or a signal
    char buffer[4096];
    const auto count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count <= 0) return count < 0 && errno == EINTR;
    unread_.append(buffer, static_cast<std::size_t>(count));
    for (auto end = unread_.find('\n'); end != std::string::npos; end = unread_.find('\n')) {
        obey(unread_.substr(0, end));
        unread_.erase(0, end + 1);
    }
    if (unread_.size() > kLongestLine) {
        tell(fmt::format("stdin: a line of more than {} characters", kLongestLine));
        unread_.clear();
    }
    return true;
}

void ManyRecordings::obey(const std::string& line) {
    const json order = json::parse(line, nullptr, false);
    const auto text = [&](const char* field) {
        return order.is_object() && order.contains(field) && order[field].is_string()
                   ? order[field].get<std::string>()
                   : std::string();
    };
    if (const std::string exercise = text("record");
        wire::is_exercise_name(exercise) && !text("output").empty())
        begin(exercise, text("output"));
    else if (recordings_.contains(text("end")))
        end(text("end"), "stopped");
    else
        tell(fmt::format("stdin: {}: neither {{\"record\": an exercise's name, \"output\": a folder}} nor "
                         "{{\"end\": one that is recorded}}",
                         line));
}

void ManyRecordings::begin(const std::string& exercise, const std::filesystem::path& folder) {
    if (recordings_.contains(exercise)) {
        tell(fmt::format("exercise {} is recorded already", exercise));
        return;
    }
    const std::string partition = wire::exercise_partition(exercise);
    try {
        recordings_.try_emplace(exercise, wire::Participant(member_, partition),
                                LiveRecording::Of{session_.domain, partition, folder}, options_);
    } catch (const mcap::WriteError& error) {
        tell(error.what());
        tell_ended(exercise, kDisk);
    } catch (const std::exception& error) {
        tell(error.what());
        tell_ended(exercise, kFailed);
    }
}

void ManyRecordings::end(const std::string& exercise, const std::string& because) {
    const auto at = recordings_.find(exercise);
    const int code = at->second.end(because);
    recordings_.erase(at);
    tell_ended(exercise, code);
}

void ManyRecordings::tell_ended(const std::string& exercise, int code) {
    if (code != kOk) code_ = code;
    std::cout << json{{"ended", exercise}, {"code", code}}.dump() << std::endl;
}

} // namespace windlass::recorder
