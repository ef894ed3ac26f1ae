#pragma once
// The exercise in three dimensions for one client of Foxglove's protocol.

#include "station/gateway/feed.hpp"
#include "station/gateway/scene_update.hpp"

namespace windlass::gateway {

/// The channel "/scene", made while a session listens to it. It is there only where the feed hears all of
/// scene_topics(): a seat learns nothing by it that it does not hear.
class SceneChannel final : public Source, private Ear {
public:
    /// channels: the feed's, which outlives this.
    SceneChannel(Source& feed, const std::vector<Channel>& channels);
    ~SceneChannel() override;

    static constexpr std::uint32_t kChannel = 201; ///< beyond those of feeds

    /// The exercise's time, s: what is new of the scene is sent, ten times a second at most. again: another
    /// run begins; what the session was shown is deleted and drawn anew, at once. From any thread.
    void tell(double time, bool again, Clock::time_point now);

    nlohmann::json advertisements(bool with_schema) const override;
    bool has(std::uint32_t channel) const override { return channel == kChannel && !topics_.empty(); }
    /// One ear at a time.
    void listen(std::uint32_t channel, Ear& ear,
                const std::function<void(std::vector<FramePtr>)>& begin) override;
    void leave(std::uint32_t channel, Ear& ear) override;
    void leave(Ear& ear) override { leave(kChannel, ear); }

private:
    void hear(const FramePtr& frame) override;
    FramePtr draw(bool anew, Clock::time_point now);

    Source& feed_;
    std::map<std::uint32_t, const wire::TopicInfo*> topics_; ///< by the feed's numbers; empty: it lacks one
    std::mutex mutex_;                                       ///< of what follows
    SceneHeard heard_;
    Ear* ear_ = nullptr;
    double time_ = 0;       ///< s
    double newest_ = 0;     ///< s, of what the session was shown
    std::uint64_t run_ = 0; ///< counts them
    std::string sent_;
    Clock::time_point sent_at_{};
};

} // namespace windlass::gateway
