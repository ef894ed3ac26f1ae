#pragma once
// What waits to be sent to one page. A page that is slow loses old states, and nothing else.

#include "station/gateway/history.hpp"

#include <list>
#include <optional>
#include <string>
#include <unordered_map>

namespace windlass::gateway {

/// Not for two threads at once.
class Outbox {
public:
    /// Messages that may wait beside states and what was kept before the page came.
    static constexpr std::size_t kMost = 1024;

    /// A text, a time, or a sample of one of the page's subscriptions.
    struct Item {
        std::string text{};
        FramePtr frame{};
        std::uint32_t subscription = 0;
        std::uint64_t ns = 0; ///< the time, or that of the sample
        bool is_time = false;
    };

    /// Takes the place of an older state of the same subscription and instance that waits. False: too many
    /// wait, and this one is lost.
    bool put(std::uint32_t subscription, const FramePtr& frame);
    bool put(std::string text);

    /// The time of the client's clock, ns. Takes the place of an older one that waits.
    void put_time(std::uint64_t ns);

    /// What was kept before the page came: as many as there are. with_past: of states, too, all of them and
    /// not the newest alone.
    void put_kept(std::uint32_t subscription, const FramePtr& frame, bool with_past);

    /// Nothing of that subscription waits any more: else a page that reads nothing and subscribes again and
    /// again would have all that is kept wait once more each time.
    void forget(std::uint32_t subscription);

    /// The oldest; nothing waits: nothing.
    std::optional<Item> pop();

    bool empty() const { return items_.empty(); }

private:
    struct Waiting {
        Item item;
        bool counted;
        std::string slot; ///< of a state; empty: none
    };
    void put_newest(const std::string& slot, Item item);

    std::list<Waiting> items_;
    std::unordered_map<std::string, std::list<Waiting>::iterator> slots_;
    std::size_t counted_ = 0;
};

} // namespace windlass::gateway
