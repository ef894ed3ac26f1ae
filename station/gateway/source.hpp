#pragma once
// What a session can be subscribed to.

#include "station/gateway/history.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>

namespace windlass::gateway {

/// Who hears samples. Called on DDS threads, one at a time for each topic: must be quick, and must not call
/// the source.
class Ear {
public:
    virtual ~Ear() = default;
    virtual void hear(const FramePtr& frame) = 0;
};

/// Channels by number. Every function may be called from any thread.
class Source {
public:
    virtual ~Source() = default;

    /// The channels, as Foxglove's `advertise` tells them; with_schema: with the text of each schema.
    virtual nlohmann::json advertisements(bool with_schema) const = 0;
    virtual bool has(std::uint32_t channel) const = 0;

    /// From now on the ear hears the channel; what was kept of it is handed to begin first, so that nothing
    /// is missed or heard twice.
    virtual void listen(std::uint32_t channel, Ear& ear,
                        const std::function<void(std::vector<FramePtr>)>& begin) = 0;
    /// No call to the ear comes after it.
    virtual void leave(std::uint32_t channel, Ear& ear) = 0;
    virtual void leave(Ear& ear) = 0;
};

} // namespace windlass::gateway
