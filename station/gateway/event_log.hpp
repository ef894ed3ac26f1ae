#pragma once
// Events for the log panels of Foxglove and Lichtblick, which take nothing but foxglove.Log.

#include "station/gateway/feed.hpp"

namespace windlass::gateway {

/// An Event's frame as a foxglove.Log in JSON: exercise time, level by severity (caution and warning:
/// WARNING, alarm: ERROR), code as its name, the text with the exercise's time. Nothing where the payload is
/// no Event.
FramePtr log_of(const SharedFrame& event);

/// The channel "/log" of one foreign session, made of a feed's events while that session listens.
class EventLog final : public Source, private Ear {
public:
    /// The feed outlives it.
    explicit EventLog(Feed& feed);
    ~EventLog() override;

    static constexpr std::uint32_t kChannel = 200; ///< beyond those of feeds

    nlohmann::json advertisements(bool with_schema) const override;
    bool has(std::uint32_t channel) const override { return channel == kChannel; }
    /// One ear at a time.
    void listen(std::uint32_t channel, Ear& ear,
                const std::function<void(std::vector<FramePtr>)>& begin) override;
    void leave(std::uint32_t channel, Ear& ear) override;
    void leave(Ear& ear) override { leave(kChannel, ear); }

private:
    void hear(const FramePtr& frame) override;

    Feed& feed_;
    std::uint32_t events_; ///< number of the feed's channel; 0: it hears no events
    Ear* ear_ = nullptr;   ///< changed only while the feed calls nobody here
};

} // namespace windlass::gateway
