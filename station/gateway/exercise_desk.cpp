#include "station/gateway/exercise_desk.hpp"

#include "idl/moved_in_run.hpp"
#include "idl/payload.hpp"
#include "station/lever_sender.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::gateway {

namespace {

std::int64_t unix_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// For the last set points of a hand that lets go to be heard, in a network that loses some.
constexpr std::chrono::milliseconds kLastWords{50};

/// What the role writes besides levers.
Topics orders_of(const Role& role) {
    Topics orders;
    std::ranges::copy_if(role.writes, std::back_inserter(orders),
                         [](const wire::TopicInfo* topic) { return !is_lever_topic(*topic); });
    return orders;
}

/// A payload with that hand's key.
Payload key_of(Hand hand) {
    if (hand == Hand::helm) return {};
    WindlassCommand levers;
    levers.side(hand == Hand::port ? SIDE_PORT : SIDE_STARBOARD);
    return wire::encode(levers);
}

/// Under which name levers came.
std::string source_of(Hand hand, const Payload& levers) {
    try {
        return hand == Hand::helm ? wire::decode<HelmCommand>(levers).origin().source().to_string()
                                  : wire::decode<WindlassCommand>(levers).origin().source().to_string();
    } catch (const std::exception&) {
        return "a station that cannot be read";
    }
}

} // namespace

OrderWriter::OrderWriter(wire::Participant& participant, const wire::TopicInfo& topic, std::string name)
    : participant_{participant}, topic_{topic}, name_{std::move(name)} {
    writer_ = std::make_unique<wire::RawWriter>(participant_, topic_, station::LeverSender::kStrength);
}

void OrderWriter::write(const nlohmann::json& sample, const std::string& by) {
    const Payload payload =
        encode_order(topic_, sample,
                     {.source = by.empty() ? name_ : by, .serial = serial_ + 1, .sent_unix_ns = unix_ns()});
    ++serial_;
    if (!writer_->write(payload))
        throw Refused(topic_.name, "", "an order", "it could not be sent: too many wait to be");
}

void OrderWriter::write_levers(const nlohmann::json& sample, std::uint64_t moved_in_run,
                               const std::string& by) {
    wire::tell_moved_in_run(participant_, writer_->id(), moved_in_run);
    write(sample, by);
}

void OrderWriter::let_go() {
    writer_->wait_acknowledged(kLastWords);
    writer_ = std::make_unique<wire::RawWriter>(participant_, topic_, station::LeverSender::kStrength);
    serial_ = 0;
}

OrderWriters::OrderWriters(wire::Participant& participant, const Topics& topics, const std::string& name) {
    for (const wire::TopicInfo* topic : topics)
        writers_.try_emplace(topic->name, participant, *topic, name);
}

bool OrderWriters::has(const wire::TopicInfo& topic) const {
    return writers_.contains(topic.name);
}

bool OrderWriters::heard_by(const wire::TopicInfo& topic, const wire::WriterId& peer) const {
    const auto writer = writers_.find(topic.name);
    return writer != writers_.end() && writer->second.heard_by(peer);
}

void OrderWriters::write(const wire::TopicInfo& topic, const nlohmann::json& sample, const std::string& by) {
    const auto writer = writers_.find(topic.name);
    if (writer == writers_.end()) throw Refused(topic.name, "", "an order", "not for this seat");
    writer->second.write(sample, by);
}

ExerciseDesk::ExerciseDesk(const SharedReaders& readers, const std::string& exercise, station::Seat seat,
                           const std::string& name, LeverDesk::Changed levers_changed)
    : exercise_{exercise},
      role_{role_of(seat, exercise)},
      takes_over_{seat == station::Seat::instructor},
      feed_{readers, wire::exercise_partition(exercise), Feed::Kind::exercise, role_.hears},
      writers_{feed_.participant(), orders_of(role_), name},
      levers_{[this](Hand hand, const nlohmann::json& sample, std::uint64_t moved_in_run) {
                  const auto name = names_.find(levers_.holder(hand));
                  // put() has seen that the role has it.
                  hands_.at(hand).write_levers(sample, moved_in_run,
                                               name == names_.end() ? "" : name->second);
              },
              [this, changed = std::move(levers_changed)](Hand hand, LeverDesk::Page holder,
                                                          const std::string& taken_by) {
                  if (holder == nullptr) hands_.at(hand).let_go();
                  changed(hand, holder, taken_by);
              },
              [this](Hand hand) {
                  // Who takes over last has the levers; trainees' hands are equals.
                  if (takes_over_) hands_.at(hand).outrank();
              },
              [this] { return run_heard(); }} {
    for (const Hand hand : kHands)
        if (const wire::TopicInfo* topic = lever_topic(hand))
            hands_.try_emplace(hand, feed_.participant(), *topic, name);
}

void ExerciseDesk::leave(LeverDesk::Page page) {
    levers_.leave(page);
    names_.erase(page);
}

void ExerciseDesk::give(const wire::TopicInfo& topic, const nlohmann::json& sample, const std::string& by) {
    if (!writers_.has(topic)) throw Refused(topic.name, "", "an order", "not for this seat");
    const bool to_replay = std::string_view(topic.name) == wire::topics::replay_command.name;
    const auto taker =
        feed_.writer(to_replay ? static_cast<const wire::TopicInfo&>(wire::topics::replay_status)
                               : wire::topics::exercise_status);
    // In a station's first moments either may be so of a server that is there.
    const auto not_yet = [&](std::string why) {
        Refused refusal(topic.name, "", "an order", std::move(why));
        refusal.again = true;
        return refusal;
    };
    const std::string one = to_replay ? "replay" : "server";
    if (!taker) throw not_yet(fmt::format("no {} is heard here", one));
    if (!writers_.heard_by(topic, *taker))
        throw not_yet(fmt::format("the {} does not hear this station yet: give it again", one));
    writers_.write(topic, sample, by);
}

std::uint64_t ExerciseDesk::run_heard() const {
    const auto kept = feed_.kept(wire::topics::exercise_status);
    try {
        return kept.empty() ? 0 : wire::decode<ExerciseStatus>(kept.back()->payload).run();
    } catch (const std::exception&) { // of a writer that is no server of ours
        return 0;
    }
}

void ExerciseDesk::tick(Clock::time_point now) {
    for (const Hand hand : kHands)
        if (levers_.holder(hand) != nullptr) look_whose_word_counts(hand);
    levers_.tick(now);
}

void ExerciseDesk::look_whose_word_counts(Hand hand) {
    const wire::TopicInfo& topic = *lever_topic(hand);
    const auto spoken = feed_.spoken(topic, instance_of(topic, key_of(hand)));
    if (!spoken) return;
    const OrderWriter& ours = hands_.at(hand);
    if (ours.is_own(spoken->writer))
        levers_.heard_own(hand, spoken->at);
    else
        levers_.heard_other(hand, source_of(hand, spoken->frame->payload), spoken->at,
                            ours.outranked_by(spoken->writer));
}

const wire::TopicInfo* ExerciseDesk::lever_topic(Hand hand) const {
    const bool helm = hand == Hand::helm;
    for (const wire::TopicInfo* topic : role_.writes)
        if (is_lever_topic(*topic) && (std::string_view(topic->type) == "HelmCommand") == helm) return topic;
    return nullptr;
}

} // namespace windlass::gateway
