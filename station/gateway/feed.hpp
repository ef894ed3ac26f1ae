#pragma once
// The DDS side of one partition: hears a role's topics unopened, keeps what late pages need, and hands every
// sample to the pages that want it. What several roles hear of an exercise is heard once.

#include "idl/raw.hpp"
#include "station/gateway/heard_topic.hpp"
#include "station/gateway/roles.hpp"

#include <memory>

namespace windlass::gateway {

/// One topic that a feed hears, as pages know it.
struct Channel {
    std::uint32_t number = 0; ///< from 1 on; the same in every feed of a role
    std::string name;         ///< "/ShipState"; of the classroom's events "/classroom/Event"
    const wire::TopicInfo* topic = nullptr;
};

/// The number that the feed gives a topic; 0: it does not hear it.
std::uint32_t number_of(const std::vector<Channel>& channels, const wire::TopicInfo& topic);

class SharedReaders;

class Feed final : public Source {
public:
    /// newest: an exercise, without the past of what is drawn over time.
    enum class Kind { exercise, newest, classroom };

    /// A topic that another feed of these readers has in that partition and kind is heard once, and what is
    /// kept of it is there from the beginning. Throws std::runtime_error when a reader cannot be made: the
    /// member may not read the topic.
    Feed(const SharedReaders& readers, const std::string& partition, Kind kind, const Topics& topics);
    ~Feed() override;
    Feed(const Feed&) = delete;
    Feed& operator=(const Feed&) = delete;

    const std::vector<Channel>& channels() const { return channels_; }
    nlohmann::json advertisements(bool with_schema) const override;
    bool has(std::uint32_t channel) const override;
    void listen(std::uint32_t channel, Ear& ear,
                const std::function<void(std::vector<FramePtr>)>& begin) override;
    void leave(std::uint32_t channel, Ear& ear) override;
    void leave(Ear& ear) override;

    /// What is kept of a topic; nothing where the feed does not hear it.
    std::vector<FramePtr> kept(const wire::TopicInfo& topic) const;

    /// Who wrote the newest sample of that topic; nothing where none came, or nobody writes it any more.
    std::optional<wire::WriterId> writer(const wire::TopicInfo& topic) const;

    /// The newest word on levers: of a topic of exclusive ownership, by instance_of(). Nothing where none was
    /// heard.
    std::optional<Spoken> spoken(const wire::TopicInfo& topic, const std::string& instance) const;

    /// In the partition, with raw ends only.
    wire::Participant& participant();

private:
    friend class SharedReaders;
    struct Line;
    struct Partition;
    struct Leave { ///< the line, which goes with the last who uses it
        std::shared_ptr<Partition> partition;
        void operator()(Line* line) const;
    };
    using LineInUse = std::unique_ptr<Line, Leave>;
    Line* line(std::uint32_t channel) const;
    Line* line(const wire::TopicInfo& topic) const;
    /// The view of a seat that is asked something at a freeze: what is kept of it is for nobody, lest a page
    /// that is loaded anew read the answer off it.
    bool withheld(const wire::TopicInfo& topic) const;

    std::shared_ptr<Partition> partition_;
    std::vector<Channel> channels_;
    std::vector<LineInUse> lines_; // as channels_
};

/// What all feeds of a program stand on: its member of the domain, and the readers that they share. Copies
/// are the same readers. From any thread.
class SharedReaders {
public:
    /// It has raw ends of the topics only.
    explicit SharedReaders(wire::Participant member);

private:
    friend class Feed;
    std::shared_ptr<Feed::Partition> partition(const std::string& name, Feed::Kind kind) const;

    struct Impl;
    std::shared_ptr<Impl> impl_;
};

} // namespace windlass::gateway
