#include "instructor_console/recording_events.hpp"

#include "idl/topics.hpp"
#include "recorder/recording/recording.hpp"
#include "recorder/recording/typed.hpp"

#include <nlohmann/json.hpp>

#include <deque>

namespace windlass::console {

nlohmann::json events_of(const std::filesystem::path& path) {
    constexpr std::size_t kMost = 5000;
    recording::Recording recording({path});
    std::deque<nlohmann::json> events;
    auto cursor = recording.messages({.topics = {wire::topics::event.name}});
    while (const auto message = cursor.next()) {
        const auto event = recording::decode<Event>(message->payload);
        events.push_back({{"position", static_cast<double>(message->log_time - recording.start()) * 1e-9},
                          {"tick", event.tick()},
                          {"time", event.time()},
                          {"number", event.number()},
                          {"severity", static_cast<int>(event.severity())},
                          {"code", event.code().to_string()},
                          {"side", event.side()},
                          {"value", event.value()},
                          {"text", event.text().to_string()}});
        if (events.size() > kMost) events.pop_front();
    }
    return nlohmann::json(events);
}

} // namespace windlass::console
