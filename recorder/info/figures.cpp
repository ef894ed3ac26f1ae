#include "recorder/info/figures.hpp"

#include "idl/topics.hpp"
#include "recorder/recording/typed.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::recorder {

using recording::Message;
using recording::Recording;

double TopicFigures::rate() const {
    return messages > 1 && last > first ? static_cast<double>(messages - 1) / (last - first) : 0;
}

double TopicFigures::latency_at(double part) const {
    if (latency.empty()) return 0;
    return latency[static_cast<std::size_t>(std::lround(part * static_cast<double>(latency.size() - 1)))];
}

namespace {

/// Row of the topic table; topics of others come behind.
std::size_t row_of(const std::string& topic) {
    const auto& all = wire::topics::all;
    return static_cast<std::size_t>(
        std::ranges::find_if(all, [&](const auto& row) { return topic == row.name; }) - all.begin());
}

class Count {
public:
    explicit Count(Recording& recording) : recording_(recording) {}

    void add(const Message& message) {
        ++figures.messages;
        TopicFigures& topic = topic_of(message);
        const double at = static_cast<double>(message.log_time - recording_.start()) * 1e-9;
        if (topic.messages++ == 0) {
            topic.first = at;
        } else if (at - topic.last > topic.largest_gap) {
            topic.largest_gap = at - topic.last;
            topic.largest_gap_at = topic.last;
        }
        topic.last = at;
        topic.bytes += message.payload.size();
        // What was written before the recording and kept for late joiners was not under way all that time.
        if (message.publish_time >= recording_.start())
            topic.latency.push_back(static_cast<float>(message.log_time - message.publish_time) * 1e-9F);
        count_lost(message, topic);
        if (message.topic() == wire::topics::event.name) add_event(message);
    }

    Figures figures;

    void finish() {
        for (auto& [row, topic] : topics_) {
            std::ranges::sort(topic.latency);
            figures.topics.push_back(std::move(topic));
        }
    }

private:
    TopicFigures& topic_of(const Message& message) {
        auto& topic = topics_[{row_of(message.topic()), message.topic()}];
        if (topic.messages == 0) {
            topic.topic = message.topic();
            topic.type = recording_.type_of(*message.channel).type;
        }
        return topic;
    }

    void count_lost(const Message& message, TopicFigures& topic) {
        const auto writer = message.channel->metadata.find("writer");
        if (writer == message.channel->metadata.end()) return;
        topic.writers.insert(writer->second);
        if (writer->second == "many") return; // several counts in one channel
        auto& last = sequences_[topic.topic + writer->second];
        if (last != 0 && message.sequence > last + 1) topic.lost += message.sequence - last - 1;
        last = std::max(last, message.sequence);
    }

    void add_event(const Message& message) {
        try {
            const auto event = recording::decode<Event>(message.payload);
            // Two servers after one another, or a replay: the same numbers again are other events.
            auto& last = event_numbers_[message.channel->metadata.contains("writer")
                                            ? message.channel->metadata.at("writer")
                                            : std::string()];
            if (last == event.number()) return;
            last = event.number();
            figures.events.push_back(event);
        } catch (const mcap::Damage&) {
            return; // counted all the same
        }
    }

    Recording& recording_;
    std::map<std::pair<std::size_t, std::string>, TopicFigures> topics_;
    std::map<std::string, std::uint32_t> sequences_;
    std::map<std::string, std::uint64_t> event_numbers_;
};

} // namespace

Figures figures_of(Recording& recording) {
    Count count(recording);
    auto cursor = recording.messages();
    while (const auto message = cursor.next())
        count.add(*message);
    count.finish();
    return std::move(count.figures);
}

} // namespace windlass::recorder
