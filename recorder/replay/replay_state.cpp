#include "recorder/replay/replay_state.hpp"

#include "idl/topics.hpp"
#include "recorder/recording/typed.hpp"

#include <algorithm>

namespace windlass::recorder {

using recording::KeptMessage;
using recording::Nanoseconds;

std::set<std::string> shown_topics() {
    std::set<std::string> topics;
    for (const auto& row : wire::topics::all)
        if (row.from_server) topics.insert(row.name);
    topics.erase(wire::topics::replay_status.name);
    return topics;
}

bool flag_as_replay(mcap::Buffer& payload) {
    // CDR header, then tick (8 bytes), time (8), state (4), as windlass.idl has them.
    constexpr std::size_t kState = 4 + 8 + 8;
    if (payload.size() < kState + 4 || payload[0] != 0 || payload[1] > 1) return false;
    const bool big_endian = payload[1] == 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t byte = big_endian ? 3 - i : i;
        payload[kState + i] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(RUN_REPLAY) >> 8 * byte);
    }
    return true;
}

namespace {

bool is_alert(const std::string& topic) {
    return topic == wire::topics::alert.name || topic == wire::topics::forecastle_alert.name ||
           topic == wire::topics::server_alert.name;
}

/// Which instance of a keyed topic the payload is of. Throws mcap::Damage.
std::string key_of(const std::string& topic, mcap::Bytes payload) {
    if (is_alert(topic)) {
        const auto alert = recording::decode<Alert>(payload);
        return alert.code().to_string() + " " + std::to_string(alert.side());
    }
    return std::to_string(recording::decode<BridgeOrder>(payload).number());
}

/// Topics by what a late joiner gets of them: all, the last of every key, the last.
struct Kept {
    std::set<std::string> all{wire::topics::event.name, wire::topics::forecastle_event.name,
                              wire::topics::bridge_event.name, wire::topics::forecastle_instruction.name,
                              wire::topics::bridge_instruction.name};
    std::set<std::string> by_key{wire::topics::alert.name, wire::topics::forecastle_alert.name,
                                 wire::topics::server_alert.name, wire::topics::bridge_order.name};
    std::set<std::string> last, streams;

    Kept() {
        for (const auto& row : wire::topics::all) {
            if (!shown_topics().contains(row.name)) continue;
            if (!row.transient_local) streams.insert(row.name);
            if (row.transient_local && !row.keyed && row.depth == 1) last.insert(row.name);
        }
    }
};

} // namespace

std::vector<KeptMessage> picture_at(recording::Recording& recording, Nanoseconds time) {
    // While an exercise stands still, streams come at 5 Hz: what is newer has every one of them.
    constexpr Nanoseconds kNewest = 250'000'000;
    static const Kept kept;
    std::vector<KeptMessage> picture;

    std::set<std::string> logs = kept.all;
    logs.insert(kept.by_key.begin(), kept.by_key.end());
    std::map<std::pair<std::string, std::string>, KeptMessage> by_key;
    auto log = recording.messages({.topics = logs, .until = time});
    while (const auto message = log.next()) {
        if (kept.all.contains(message->topic())) {
            picture.emplace_back(*message);
            continue;
        }
        try {
            by_key[{message->topic(), key_of(message->topic(), message->payload)}] = KeptMessage(*message);
        } catch (const mcap::Damage&) {
            continue; // nobody can show it
        }
    }
    for (auto& [key, message] : by_key)
        picture.push_back(std::move(message));

    for (const auto& topic : kept.last)
        if (auto last = recording.last_before(topic, time - 1)) picture.push_back(std::move(*last));
    auto newest = recording.messages({.topics = kept.streams, .from = time - kNewest, .until = time});
    while (const auto message = newest.next())
        picture.emplace_back(*message);

    std::ranges::stable_sort(picture, {}, &KeptMessage::log_time);
    return picture;
}

void Standing::keep(const std::string& topic, mcap::Bytes payload) {
    try {
        if (is_alert(topic)) {
            const auto alert = recording::decode<Alert>(payload);
            const Key key{topic, alert.code().to_string(), alert.side()};
            if (alert.condition() == ALERT_NORMAL)
                alerts_.erase(key);
            else
                alerts_[key] = alert;
        } else if (topic == wire::topics::bridge_order.name) {
            const auto order = recording::decode<BridgeOrder>(payload);
            if (order.state() == ORDER_CANCELLED)
                orders_.erase(order.number());
            else
                orders_[order.number()] = order;
        }
    } catch (const mcap::Damage&) {
        return;
    }
}

std::vector<Standing::Sample> Standing::taken_back() {
    std::vector<Sample> samples;
    for (auto& [key, alert] : alerts_) {
        alert.condition(ALERT_NORMAL);
        samples.push_back({std::get<0>(key), recording::encode(alert)});
    }
    for (auto& [number, order] : orders_) {
        order.state(ORDER_CANCELLED);
        samples.push_back({wire::topics::bridge_order.name, recording::encode(order)});
    }
    alerts_.clear();
    orders_.clear();
    return samples;
}

} // namespace windlass::recorder
