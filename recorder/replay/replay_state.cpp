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

std::vector<KeptMessage> picture_at(recording::Recording& recording, Nanoseconds time) {
    // While an exercise stands still, streams come at 5 Hz: what is newer has every one of them.
    constexpr Nanoseconds kNewest = 250'000'000;
    std::vector<KeptMessage> picture;

    std::map<std::pair<std::string, std::int32_t>, KeptMessage> alerts;
    auto log =
        recording.messages({.topics = {wire::topics::event.name, wire::topics::alert.name}, .until = time});
    while (const auto message = log.next()) {
        if (message->topic() == wire::topics::event.name) {
            picture.emplace_back(*message);
            continue;
        }
        try {
            const auto alert = recording::decode<Alert>(message->payload);
            alerts[{alert.code().to_string(), alert.side()}] = KeptMessage(*message);
        } catch (const mcap::Damage&) {
            continue; // nobody can show it
        }
    }
    for (auto& [key, message] : alerts)
        picture.push_back(std::move(message));

    std::set<std::string> streams;
    for (const auto& row : wire::topics::all) {
        if (!shown_topics().contains(row.name)) continue;
        if (!row.transient_local) streams.insert(row.name);
        if (row.transient_local && !row.keyed && row.depth == 1)
            if (auto last = recording.last_before(row.name, time - 1)) picture.push_back(std::move(*last));
    }
    auto newest = recording.messages({.topics = streams, .from = time - kNewest, .until = time});
    while (const auto message = newest.next())
        picture.emplace_back(*message);

    std::ranges::stable_sort(picture, {}, &KeptMessage::log_time);
    return picture;
}

void AlertsShown::take(mcap::Bytes payload) {
    try {
        const auto alert = recording::decode<Alert>(payload);
        const std::pair key{alert.code().to_string(), alert.side()};
        if (alert.condition() == ALERT_NORMAL)
            active_.erase(key);
        else
            active_[key] = alert;
    } catch (const mcap::Damage&) {
        return;
    }
}

std::vector<mcap::Buffer> AlertsShown::all_clear() {
    std::vector<mcap::Buffer> payloads;
    for (auto& [key, alert] : active_) {
        alert.condition(ALERT_NORMAL);
        payloads.push_back(recording::encode(alert));
    }
    active_.clear();
    return payloads;
}

} // namespace windlass::recorder
