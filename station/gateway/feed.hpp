#pragma once
// The DDS side of one partition: hears a role's topics unopened, keeps what late pages need, and hands every
// sample to the pages that want it.

#include "idl/raw.hpp"
#include "station/gateway/roles.hpp"
#include "station/gateway/source.hpp"

#include <atomic>
#include <mutex>
#include <set>

namespace windlass::gateway {

/// Whose word was heard last of one instance of a topic.
struct Spoken {
    FramePtr frame;
    wire::WriterId writer{};
    Clock::time_point at;
};

/// One topic that a feed hears, as pages know it.
struct Channel {
    std::uint32_t number = 0; ///< from 1 on; the same in every feed of a role
    std::string name;         ///< "/ShipState"; of the classroom's events "/classroom/Event"
    const wire::TopicInfo* topic = nullptr;
};

/// The number that the feed gives a topic; 0: it does not hear it.
std::uint32_t number_of(const std::vector<Channel>& channels, const wire::TopicInfo& topic);

class Feed final : public Source {
public:
    /// newest: an exercise, without the past of what is drawn over time.
    enum class Kind { exercise, newest, classroom };

    /// The participant is already in the partition, and has raw ends of these topics only. Throws
    /// std::runtime_error when a reader cannot be made: its role may not read the topic.
    Feed(wire::Participant participant, Kind kind, const Topics& topics);
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

    wire::Participant& participant() { return participant_; }

private:
    struct Line;
    Line* line(std::uint32_t channel) const;
    Line* line(const wire::TopicInfo& topic) const;
    /// The view of a seat that is asked something at a freeze: what is kept of it is for nobody, lest a page
    /// that is loaded anew read the answer off it.
    bool withheld(const wire::TopicInfo& topic) const;
    /// The exercise's time, s, as ExerciseStatus tells it: what lies after it has not happened.
    void follow(double time);

    wire::Participant participant_;
    std::vector<Channel> channels_;
    std::atomic<double> exercise_time_ = 0;
    std::array<std::atomic<bool>, 2> asked_{}; // forecastle, bridge
    std::vector<std::unique_ptr<Line>> lines_; // as channels_
};

} // namespace windlass::gateway
