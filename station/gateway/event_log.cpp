#include "station/gateway/event_log.hpp"

#include "idl/payload.hpp"
#include "station/gateway/exercise_clock.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace windlass::gateway {

using nlohmann::json;

namespace {

// Levels and fields of foxglove.Log: docs.foxglove.dev/docs/visualization/message-schemas/log.
enum Level { kInfo = 2, kWarning = 3, kError = 4 };

constexpr const char* kSchema = R"({
  "title": "foxglove.Log", "description": "A log message", "type": "object",
  "properties": {
    "timestamp": {"type": "object", "title": "time",
                  "properties": {"sec": {"type": "integer", "minimum": 0},
                                 "nsec": {"type": "integer", "minimum": 0, "maximum": 999999999}}},
    "level": {"title": "foxglove.LogLevel",
              "oneOf": [{"title": "UNKNOWN", "const": 0}, {"title": "DEBUG", "const": 1},
                        {"title": "INFO", "const": 2}, {"title": "WARNING", "const": 3},
                        {"title": "ERROR", "const": 4}, {"title": "FATAL", "const": 5}]},
    "message": {"type": "string"}, "name": {"type": "string"},
    "file": {"type": "string"}, "line": {"type": "integer", "minimum": 0}
  }
})";

Level level(EventSeverity severity) {
    switch (severity) {
    case EVENT_INFO:
        return kInfo;
    case EVENT_CAUTION:
    case EVENT_WARNING:
        return kWarning;
    case EVENT_ALARM:
        break;
    }
    return kError;
}

} // namespace

FramePtr log_of(const SharedFrame& event) {
    Event said;
    try {
        said = wire::decode<Event>(event.payload);
    } catch (const std::exception&) {
        return nullptr;
    }
    constexpr std::uint64_t kSecond = 1'000'000'000;
    const std::uint64_t at = nanoseconds(said.time());
    const json log{{"timestamp", {{"sec", at / kSecond}, {"nsec", at % kSecond}}},
                   {"level", level(said.severity())},
                   {"message", fmt::format("{:.1f} s: {}", said.time(), said.text().c_str())},
                   {"name", said.code().c_str()},
                   {"file", ""},
                   {"line", 0}};
    const std::string text = log.dump(-1, ' ', false, json::error_handler_t::replace);
    auto frame = std::make_shared<SharedFrame>();
    frame->channel = EventLog::kChannel;
    frame->time = said.time();
    frame->payload.assign(text.begin(), text.end());
    return frame;
}

EventLog::EventLog(Feed& feed) : feed_{feed}, events_{number_of(feed.channels(), wire::topics::event)} {}

EventLog::~EventLog() {
    feed_.leave(events_, *this);
}

json EventLog::advertisements(bool with_schema) const {
    json list = json::array();
    if (events_ != 0)
        list.push_back({{"id", kChannel},
                        {"topic", "/log"},
                        {"encoding", "json"},
                        {"schemaName", "foxglove.Log"},
                        {"schemaEncoding", "jsonschema"},
                        {"schema", with_schema ? kSchema : ""}});
    return list;
}

void EventLog::listen(std::uint32_t channel, Ear& ear,
                      const std::function<void(std::vector<FramePtr>)>& begin) {
    if (channel != kChannel || ear_ != nullptr) return;
    ear_ = &ear;
    feed_.listen(events_, *this, [&](const std::vector<FramePtr>& events) {
        std::vector<FramePtr> logs;
        for (const FramePtr& event : events)
            if (FramePtr log = log_of(*event)) logs.push_back(std::move(log));
        begin(std::move(logs));
    });
}

void EventLog::leave(std::uint32_t channel, Ear& ear) {
    if (channel != kChannel || ear_ != &ear) return;
    feed_.leave(events_, *this);
    ear_ = nullptr;
}

void EventLog::hear(const FramePtr& frame) {
    if (const FramePtr log = log_of(*frame)) ear_->hear(log);
}

} // namespace windlass::gateway
