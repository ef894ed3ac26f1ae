#include "instructor_console/recording_events.hpp"

#include "common/base64.hpp"
#include "idl/topics.hpp"
#include "recorder/recording/recording.hpp"
#include "recorder/recording/typed.hpp"
#include "station/gateway/history.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <deque>
#include <map>

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

nlohmann::json past_of(const std::filesystem::path& path) {
    struct Kept {
        recording::KeptMessage message;
        double time;
    };
    recording::Recording recording({path});
    std::map<std::string, const wire::TopicInfo*> topics;
    recording::Query query;
    for (const wire::TopicInfo& topic : wire::topics::all)
        if (topic.from_server && gateway::past_of(topic).frames > 0) {
            topics[topic.name] = &topic;
            query.topics.insert(topic.name);
        }
    std::map<std::pair<std::string, std::string>, std::deque<Kept>> instances;
    auto cursor = recording.messages(query);
    while (const auto message = cursor.next()) {
        const wire::TopicInfo& topic = *topics.at(message->topic());
        const auto bounds = gateway::past_of(topic);
        const auto time = gateway::time_of(topic, message->payload);
        if (!time) continue;
        auto& kept = instances[{topic.name, gateway::instance_of(topic, message->payload)}];
        // Earlier than the last: a restore, from which another branch goes on.
        if (!kept.empty() && *time >= kept.back().time && *time < kept.back().time + bounds.apart) continue;
        kept.push_back({recording::KeptMessage(*message), *time});
        if (kept.size() > bounds.frames) kept.pop_front();
    }
    std::vector<const recording::KeptMessage*> all;
    for (const auto& [instance, kept] : instances)
        for (const Kept& each : kept)
            all.push_back(&each.message);
    std::ranges::stable_sort(all, {}, &recording::KeptMessage::log_time);
    auto past = nlohmann::json::array();
    for (const recording::KeptMessage* each : all)
        past.push_back({static_cast<double>(each->log_time - recording.start()) * 1e-9, each->topic,
                        base64(each->payload)});
    return past;
}

} // namespace windlass::console
