#pragma once
// The ownership strengths with which others speak, as discovery tells them. Pure.

#include "idl/wire.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace windlass::wire {

/// Of the writers of other members on topics of exclusive ownership. From any thread.
class Strengths {
public:
    void found(const WriterId& writer, const std::string& topic, std::vector<std::string> partitions,
               std::uint32_t strength) {
        const std::lock_guard lock(mutex_);
        writers_[writer] = {topic, std::move(partitions), strength};
    }
    void gone(const WriterId& writer) {
        const std::lock_guard lock(mutex_);
        writers_.erase(writer);
    }

    /// The highest on that topic in that partition; 0: there are none. A partition that was given as a
    /// pattern counts only where it reads the same.
    std::uint32_t highest(const std::string& topic, const std::string& partition) const {
        const std::lock_guard lock(mutex_);
        std::uint32_t highest = 0;
        for (const auto& [writer, speaks] : writers_)
            if (speaks.topic == topic &&
                std::ranges::find(speaks.partitions, partition) != speaks.partitions.end())
                highest = std::max(highest, speaks.strength);
        return highest;
    }

private:
    struct Speaks {
        std::string topic;
        std::vector<std::string> partitions;
        std::uint32_t strength = 0;
    };
    mutable std::mutex mutex_;
    std::map<WriterId, Speaks> writers_;
};

} // namespace windlass::wire
