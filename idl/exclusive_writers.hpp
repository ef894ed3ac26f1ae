#pragma once
// What discovery tells of the writers of others on topics of exclusive ownership. Pure.

#include "idl/wire.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace windlass::wire {

/// From any thread.
class ExclusiveWriters {
public:
    struct Writer {
        std::string topic;
        std::vector<std::string> partitions;
        std::uint32_t strength = 0;     ///< of ownership
        std::uint64_t moved_in_run = 0; ///< see moved_in_run.hpp; 0: not said
    };

    /// It is there, or says something else than before.
    void found(const WriterId& id, Writer writer) {
        const std::lock_guard lock(mutex_);
        writers_[id] = std::move(writer);
    }
    void gone(const WriterId& writer) {
        const std::lock_guard lock(mutex_);
        writers_.erase(writer);
    }

    /// The highest strength on that topic in that partition; 0: there are none. A partition that was given as
    /// a pattern counts only where it reads the same.
    std::uint32_t highest(const std::string& topic, const std::string& partition) const {
        const std::lock_guard lock(mutex_);
        std::uint32_t highest = 0;
        for (const auto& [writer, speaks] : writers_)
            if (speaks.topic == topic &&
                std::ranges::find(speaks.partitions, partition) != speaks.partitions.end())
                highest = std::max(highest, speaks.strength);
        return highest;
    }

    /// Of a writer that is not known: 0.
    std::uint32_t strength(const WriterId& writer) const {
        const std::lock_guard lock(mutex_);
        const auto found = writers_.find(writer);
        return found == writers_.end() ? 0 : found->second.strength;
    }

    /// Of a writer that is not known: 0.
    std::uint64_t moved_in_run(const WriterId& writer) const {
        const std::lock_guard lock(mutex_);
        const auto found = writers_.find(writer);
        return found == writers_.end() ? 0 : found->second.moved_in_run;
    }

private:
    mutable std::mutex mutex_;
    std::map<WriterId, Writer> writers_;
};

} // namespace windlass::wire
