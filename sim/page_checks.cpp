#include "sim/page_checks.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

namespace windlass::sim {

void HeardBook::hear(const ToldPtr& sample) {
    const std::string name = sample->topic->name;
    if (sample->is_state()) {
        newest_[name] = sample;
        return;
    }
    auto& stands = stands_[name];
    // Another server goes on from its first moment: what lies behind that has not happened, and how alerts
    // stand is told anew.
    if (!stands.empty() && stands.back()->server != sample->server)
        std::erase_if(stands, [&](const ToldPtr& one) {
            return sample->topic->keyed || sample->time <= 0 || one->time > sample->time;
        });
    if (sample->topic->keyed)
        std::erase_if(stands, [&](const ToldPtr& one) { return one->key == sample->key; });
    stands.push_back(sample);
    if (!sample->topic->keyed && stands.size() > static_cast<std::size_t>(sample->topic->depth))
        stands.pop_front();
}

std::vector<ToldPtr> HeardBook::stands(const std::string& topic) const {
    const auto found = stands_.find(topic);
    return found == stands_.end() ? std::vector<ToldPtr>()
                                  : std::vector<ToldPtr>(found->second.begin(), found->second.end());
}

ToldPtr HeardBook::newest(const std::string& topic) const {
    const auto found = newest_.find(topic);
    return found == newest_.end() ? nullptr : found->second;
}

void PageChecks::subscribes(std::uint32_t subscription, const wire::TopicInfo& topic, const HeardBook& book,
                            std::size_t kept) {
    const auto stands = book.stands(topic.name);
    subscriptions_[subscription] = {.topic = topic.name,
                                    .is_state = topic.rate > 0,
                                    .to_come = {stands.begin(), stands.end()},
                                    .newest = {},
                                    .kept = kept};
}

void PageChecks::unsubscribes(std::uint32_t subscription) {
    subscriptions_.erase(subscription);
}

void PageChecks::is_told(const ToldPtr& sample) {
    if (sample->is_state()) return;
    for (auto& [number, one] : subscriptions_)
        if (one.topic == sample->topic->name) one.to_come.push_back(sample);
}

void PageChecks::gets(std::uint32_t subscription, const std::string& topic,
                      const std::vector<std::uint8_t>& payload) {
    if (std::ranges::find(may_hear_, topic) == may_hear_.end())
        throw Failure{"page roles", "no topic but those of its seat", topic};
    const auto found = subscriptions_.find(subscription);
    if (found == subscriptions_.end() || found->second.topic != topic)
        throw Failure{"page subscriptions", "samples of what it is subscribed to",
                      fmt::format("{} of subscription {}", topic, subscription)};
    Subscription& one = found->second;
    one.newest = payload;
    if (one.is_state) return;
    if (one.to_come.empty())
        throw Failure{"page events", fmt::format("{} once", topic), "one that it had, or that nobody told"};
    if (one.to_come.front()->payload != payload)
        throw Failure{"page events",
                      fmt::format("{} in order: sample {}", topic, one.to_come.front()->number),
                      "another one"};
    one.to_come.pop_front();
}

void PageChecks::has_all(const HeardBook& book, std::size_t waited, std::size_t beside) {
    std::size_t most = beside;
    for (auto& [number, one] : subscriptions_) {
        most += std::exchange(one.kept, 0) + 2; // of a state, of each side the newest
        if (!one.to_come.empty())
            throw Failure{"page events", fmt::format("all of {}", one.topic),
                          fmt::format("{} are missing, from sample {} on", one.to_come.size(),
                                      one.to_come.front()->number)};
        const ToldPtr newest = book.newest(one.topic);
        if (newest && one.newest != newest->payload)
            throw Failure{"page states", fmt::format("the newest {}: sample {}", one.topic, newest->number),
                          one.newest.empty() ? "none" : "another one"};
    }
    if (waited > most)
        throw Failure{"memory", fmt::format("{} messages wait for a page at most", most),
                      std::to_string(waited)};
}

} // namespace windlass::sim
