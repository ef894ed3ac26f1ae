#include "sim/station_program.hpp"

#include "idl/payload.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::sim {

using gateway::Hand;
using gateway::Refused;
using nlohmann::json;

namespace {

constexpr int kStrength = 10; // of a hand, as station::LeverSender's

std::array<double, 5> values_of_levers(const WindlassCommand& levers) {
    return {levers.brake(), levers.speed_lever(), levers.clutch_in() ? 1.0 : 0.0,
            levers.stopper_closed() ? 1.0 : 0.0, levers.emergency_stop() ? 1.0 : 0.0};
}

} // namespace

/// As gateway::Feed of one exercise.
class StationProgram::Topics final : public gateway::Source {
public:
    Topics(const World& world, const gateway::Topics& heard) : world_(world) {
        for (const wire::TopicInfo* topic : heard) {
            const auto row = std::ranges::find_if(wire::topics::all, [&](const wire::TopicInfo& each) {
                return std::string_view(each.name) == topic->name;
            });
            const auto number = static_cast<std::uint32_t>(row - wire::topics::all.begin()) + 1;
            topics_.try_emplace(number, *row, number, false, true);
        }
    }

    void hear(const ToldSample& sample) {
        gateway::HeardTopic* const topic = of(*sample.topic);
        if (topic == nullptr) return;
        const auto frame = topic->frame_of(sample.payload, static_cast<std::int64_t>(world_.now() * 1e9),
                                           exercise_time_, world_.time());
        const bool is_status = sample.topic->name == std::string_view(wire::topics::exercise_status.name);
        if (is_status && frame->time < std::exchange(exercise_time_, frame->time))
            for (auto& [number, one] : topics_)
                one.back_to(frame->time);
        wire::WriterId writer{};
        for (std::size_t k = 0; k < 8; ++k)
            writer.at(k) = static_cast<std::uint8_t>(sample.server >> (8 * k));
        topic->hear(frame, writer);
    }

    gateway::HeardTopic* of(const wire::TopicInfo& topic) {
        const auto found = std::ranges::find_if(topics_, [&](const auto& one) {
            return std::string_view(one.second.topic().name) == topic.name;
        });
        return found == topics_.end() ? nullptr : &found->second;
    }
    gateway::HeardTopic* of(std::uint32_t channel) {
        const auto found = topics_.find(channel);
        return found == topics_.end() ? nullptr : &found->second;
    }

    json advertisements(bool) const override {
        json list = json::array();
        for (const auto& [number, one] : topics_)
            list.push_back({{"id", number}, {"topic", "/" + std::string(one.topic().name)}});
        return list;
    }
    bool has(std::uint32_t channel) const override { return topics_.contains(channel); }
    void listen(std::uint32_t channel, gateway::Ear& ear,
                const std::function<void(std::vector<gateway::FramePtr>)>& begin) override {
        if (auto* const topic = of(channel)) topic->listen(ear, begin, false, world_.time());
    }
    void leave(std::uint32_t channel, gateway::Ear& ear) override {
        if (auto* const topic = of(channel)) topic->leave(ear);
    }
    void leave(gateway::Ear& ear) override {
        for (auto& [number, one] : topics_)
            one.leave(ear);
    }

private:
    const World& world_;
    std::map<std::uint32_t, gateway::HeardTopic> topics_; // by channel
    double exercise_time_ = 0;                            // s
};

/// As gateway::ExerciseDesk of a trainees' station, whose hands are equals with all others.
class StationProgram::Desk final : public gateway::PageDesk {
public:
    explicit Desk(StationProgram& program)
        : program_(program),
          levers_([this](Hand hand, const json& sample,
                         std::uint64_t moved_in_run) { write(hand, sample, moved_in_run); },
                  [this](Hand hand, gateway::LeverDesk::Page holder, const std::string& taken_by) {
                      if (holder == nullptr) let_go(hand);
                      if (!taken_by.empty() && program_.options_.tells_no_takings) return;
                      for (gateway::PageSession* page : program_.pages_)
                          page->tell_levers(hand, holder, taken_by);
                  },
                  {}, [this] { return run_heard(); }) {
        for (Ends& ends : ends_)
            ends.writer = next_writer();
        orders_.writer = next_writer();
    }

    const std::string& exercise() const override { return exercise_; }
    const gateway::Role& role() const override { return program_.role_; }
    gateway::LeverDesk& levers() override { return levers_; }
    const wire::TopicInfo* lever_topic(Hand hand) const override {
        if (hand == Hand::helm || !program_.options_.written) return nullptr;
        const auto& writes = role().writes;
        const auto found = std::ranges::find_if(writes, [](const wire::TopicInfo* topic) {
            return std::string_view(topic->name) == wire::topics::windlass_command.name;
        });
        return found == writes.end() ? nullptr : *found;
    }

    void give(const wire::TopicInfo& topic, const json& sample, const std::string&) override {
        const bool may =
            program_.options_.written && std::ranges::any_of(role().writes, [&](const auto* each) {
                return std::string_view(each->name) == topic.name;
            });
        if (!may) throw Refused(topic.name, "", "an order", "not for this seat");
        const auto payload = gateway::encode_order(
            topic, sample,
            {.source = program_.options_.name, .serial = orders_.serial + 1, .sent_unix_ns = 0});
        if (std::string_view(topic.name) != wire::topics::alert_command.name) not_here();
        ++orders_.serial;
        program_.network_.send({.sample = wire::decode<AlertCommand>(payload), .writer = orders_.writer});
    }
    void call(gateway::LeverDesk::Page, const std::string&) override {}
    void leave(gateway::LeverDesk::Page page) override { levers_.leave(page); }

    void overhear(Hand hand, const Sent& sent) {
        spoken_.at(static_cast<std::size_t>(hand)) = {.sent = sent, .at = program_.world_.time()};
    }
    /// As ExerciseDesk::tick.
    void tick() {
        for (const Hand hand : {Hand::port, Hand::starboard})
            if (levers_.holder(hand) != nullptr && !program_.options_.looks_at_no_takings)
                look_whose_word_counts(hand);
        levers_.tick(program_.world_.time());
    }

    std::optional<wire::WriterId> speaks_as(Hand hand) const {
        const Ends& ends = ends_.at(static_cast<std::size_t>(hand));
        return ends.serial == 0 ? std::nullopt : std::optional(ends.writer);
    }
    bool killed = false; ///< nothing goes out any more

private:
    struct Ends {
        wire::WriterId writer{};
        std::uint64_t serial = 0;
        std::array<double, 5> at{}, moved_at{};
    };
    /// The last word that counted.
    struct Spoken {
        std::optional<Sent> sent{};
        gateway::Clock::time_point at{};
    };
    void look_whose_word_counts(Hand hand) {
        const auto& [sent, at] = spoken_.at(static_cast<std::size_t>(hand));
        if (!sent) return;
        if (sent->writer == ends(hand).writer)
            levers_.heard_own(hand, at);
        else
            levers_.heard_other(hand, std::get<WindlassCommand>(sent->sample).origin().source().to_string(),
                                at, sent->strength > kStrength);
    }
    Ends& ends(Hand hand) { return ends_.at(static_cast<std::size_t>(hand)); }

    wire::WriterId next_writer() {
        wire::WriterId id{};
        ++writers_;
        for (std::size_t k = 0; k < 4; ++k) {
            id.at(k) = static_cast<std::uint8_t>(writers_ >> (8 * k));
            id.at(4 + k) = static_cast<std::uint8_t>(program_.options_.number >> (8 * k));
        }
        id.back() = 1; // no other hand's
        return id;
    }

    void write(Hand hand, const json& sample, std::uint64_t moved_in_run) {
        if (killed) return;
        Ends& its = ends(hand);
        const auto payload = gateway::encode_order(
            wire::topics::windlass_command, sample,
            {.source = program_.options_.name, .serial = its.serial + 1, .sent_unix_ns = 0});
        auto levers = wire::decode<WindlassCommand>(payload);
        program_.options_.written(levers_.holder(hand), levers);
        const auto at = values_of_levers(levers);
        for (std::size_t k = 0; k < at.size(); ++k)
            if (its.serial == 0 || at[k] != its.at[k]) its.moved_at[k] = program_.world_.now();
        its.at = at;
        ++its.serial;
        program_.network_.send({.sample = levers,
                                .writer = its.writer,
                                .moved_in_run = moved_in_run,
                                .strength = kStrength,
                                .moved_at = its.moved_at});
    }

    void let_go(Hand hand) {
        Ends& its = ends(hand);
        if (killed || its.serial == 0) return;
        program_.network_.leave(its.writer);
        its = {.writer = next_writer()};
    }

    std::uint64_t run_heard() const {
        const auto* const status = program_.topics_->of(wire::topics::exercise_status);
        const auto kept =
            status == nullptr ? std::vector<gateway::FramePtr>() : status->kept(program_.world_.time());
        return kept.empty() ? 0 : wire::decode<ExerciseStatus>(kept.back()->payload).run();
    }

    StationProgram& program_;
    const std::string exercise_ = "anna";
    std::uint64_t writers_ = 0;
    std::array<Ends, 2> ends_;     // by side
    std::array<Spoken, 2> spoken_; // the same
    Ends orders_;
    gateway::LeverDesk levers_;
};

StationProgram::StationProgram(World& world, Network& network, Options options)
    : world_(world),
      network_(network),
      options_(std::move(options)),
      role_(gateway::role_of(options_.seat, "anna")) {
    gateway::Topics heard = role_.hears;
    if (options_.hears_truth) heard.push_back(&wire::topics::event);
    topics_ = std::make_unique<Topics>(world_, heard);
    desk_ = std::make_shared<Desk>(*this);
}

StationProgram::~StationProgram() {
    desk_->killed = true;
    const auto pages = pages_; // which leave it one after the other
    for (gateway::PageSession* page : pages)
        page->close();
}

std::shared_ptr<gateway::PageSession> StationProgram::open_page(gateway::Transport& transport) {
    auto page = std::make_shared<gateway::PageSession>(
        *this, desk_, std::vector<gateway::Source*>{topics_.get()}, transport, "");
    pages_.insert(page.get());
    return page;
}

bool StationProgram::reads(const wire::TopicInfo& topic) const {
    return topics_->of(topic) != nullptr;
}

void StationProgram::hear(const ToldSample& sample) {
    topics_->hear(sample);
}

void StationProgram::overhear(const Sent& sent) {
    const auto* const levers = std::get_if<WindlassCommand>(&sent.sample);
    if (levers != nullptr && !sent.instructor) // who hears its topic
        desk_->overhear(levers->side() == SIDE_PORT ? Hand::port : Hand::starboard, sent);
}

void StationProgram::tick() {
    desk_->tick();
}

const wire::TopicInfo* StationProgram::topic_of(std::uint32_t channel) const {
    const auto* const topic = topics_->of(channel);
    return topic == nullptr ? nullptr : &topic->topic();
}

std::size_t StationProgram::kept(std::uint32_t channel) const {
    const auto* const topic = topics_->of(channel);
    return topic == nullptr ? 0 : topic->kept(world_.time()).size();
}

gateway::LeverDesk::Page StationProgram::holder(int side) const {
    return desk_->levers().holder(side == 0 ? Hand::port : Hand::starboard);
}

std::optional<wire::WriterId> StationProgram::speaks_as(int side) const {
    return desk_->speaks_as(side == 0 ? Hand::port : Hand::starboard);
}

json StationProgram::hello(const gateway::PageSession& page) const {
    return {{"op", "hello"}, {"seat", page.desk().role().name}, {"exercise", page.desk().exercise()}};
}

void StationProgram::not_here() {
    throw Refused("", "", "this", "it is not in the simulated centre");
}

} // namespace windlass::sim
