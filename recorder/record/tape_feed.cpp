#include "recorder/record/tape_feed.hpp"

#include <numeric>

namespace windlass::recorder {

void TapeFeed::write_what_came(std::chrono::milliseconds wait,
                               const std::function<void(const Sample&)>& written) {
    const auto samples = queue_.pop_all(wait);
    in_hand_ = samples.size();
    for (const auto& sample : samples) {
        --in_hand_;
        tape_.write(sample);
        if (written) written(sample);
    }
}

void TapeFeed::give_up() {
    in_hand_ += queue_.pop_all(std::chrono::milliseconds(0)).size();
}

mcap::Strings TapeFeed::closing(const std::string& ended, const std::string& because) const {
    mcap::Strings entries{{"ended", ended},
                          {"because", because},
                          {"messages", std::to_string(tape_.messages())},
                          {"lost_at_end", std::to_string(lost())},
                          {"dropped", std::to_string(dropped())}};
    const auto drops = queue_.drops();
    for (std::size_t topic = 0; topic < drops.size(); ++topic)
        if (drops[topic] > 0)
            entries[std::string("dropped.") + wire::topics::all[topic].name] = std::to_string(drops[topic]);
    return entries;
}

std::uint64_t TapeFeed::dropped() const {
    const Drops drops = queue_.drops();
    return std::accumulate(drops.begin(), drops.end(), std::uint64_t{0});
}

} // namespace windlass::recorder
