#pragma once
// What must hold of what a page is told, whatever its gateway makes of it. Looks on at what the server tells
// and at what the page is sent, and knows of the gateway no more than that.

#include "idl/topics.hpp"
#include "sim/world.hpp"

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace windlass::sim {

/// A sample that the server tells.
struct ToldSample {
    const wire::TopicInfo* topic = nullptr;
    std::vector<std::uint8_t> payload{};
    std::string key{};        ///< of a topic with a key
    double time = 0;          ///< s of exercise
    std::uint64_t server = 0; ///< which one tells it: the next server is another
    std::uint64_t number = 0; ///< of all that are told

    bool is_state() const { return topic->rate > 0; } ///< of which the newest is enough
};
using ToldPtr = std::shared_ptr<const ToldSample>;

/// What a program has heard, and what of that a page must be given that comes now.
class HeardBook {
public:
    void hear(const ToldPtr& sample);
    /// Of what is told once: of events all up to where the present server went on, of alerts how each stands.
    std::vector<ToldPtr> stands(const std::string& topic) const;
    /// Of a state; nullptr: none was heard.
    ToldPtr newest(const std::string& topic) const;

private:
    std::map<std::string, std::deque<ToldPtr>> stands_;
    std::map<std::string, ToldPtr> newest_;
};

/// One connection of a page.
class PageChecks {
public:
    /// may_hear: names of the topics that its seat may be sent; of others no sample may come.
    explicit PageChecks(std::vector<std::string> may_hear) : may_hear_(std::move(may_hear)) {}

    /// The page subscribes. book: of its gateway. kept: how many samples that has for who comes late.
    void subscribes(std::uint32_t subscription, const wire::TopicInfo& topic, const HeardBook& book,
                    std::size_t kept);
    void unsubscribes(std::uint32_t subscription);
    /// Its gateway has heard that.
    void is_told(const ToldPtr& sample);

    /// It has been sent that.
    void gets(std::uint32_t subscription, const std::string& topic, const std::vector<std::uint8_t>& payload);
    /// It has been sent all that waited, so many messages. beside: of those that may wait, the gateway's
    /// most.
    void has_all(const HeardBook& book, std::size_t waited, std::size_t beside);

private:
    struct Subscription {
        std::string topic;
        bool is_state = false;
        std::deque<ToldPtr> to_come; // of what is told once
        std::vector<std::uint8_t> newest;
        std::size_t kept = 0; // samples that waited from the beginning, and may do so yet
    };
    std::vector<std::string> may_hear_;
    std::map<std::uint32_t, Subscription> subscriptions_;
};

} // namespace windlass::sim
