#include "station/gateway/exercise_desk.hpp"

#include "idl/payload.hpp"
#include "station/lever_sender.hpp"

#include <algorithm>

namespace windlass::gateway {

namespace {

std::int64_t unix_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
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

OrderWriters::OrderWriters(wire::Participant& participant, const Topics& topics, std::string name)
    : name_{std::move(name)} {
    for (const wire::TopicInfo* topic : topics)
        lines_.emplace(topic->name,
                       Line{wire::RawWriter(participant, *topic, station::LeverSender::kStrength)});
}

bool OrderWriters::has(const wire::TopicInfo& topic) const {
    return lines_.contains(topic.name);
}

bool OrderWriters::heard_by(const wire::TopicInfo& topic, const wire::WriterId& peer) const {
    const auto line = lines_.find(topic.name);
    return line != lines_.end() && line->second.writer.heard_by(peer);
}

void OrderWriters::outrank(const wire::TopicInfo& topic) {
    if (const auto line = lines_.find(topic.name); line != lines_.end()) line->second.writer.outrank();
}

bool OrderWriters::is_own(const wire::TopicInfo& topic, const wire::WriterId& writer) const {
    const auto line = lines_.find(topic.name);
    return line != lines_.end() && line->second.writer.id() == writer;
}

void OrderWriters::write(const wire::TopicInfo& topic, const nlohmann::json& sample) {
    const auto line = lines_.find(topic.name);
    if (line == lines_.end()) throw Refused(topic.name, "", "an order", "not for this seat");
    const Payload payload = encode_order(
        topic, sample, {.source = name_, .serial = line->second.serial + 1, .sent_unix_ns = unix_ns()});
    ++line->second.serial;
    if (!line->second.writer.write(payload))
        throw Refused(topic.name, "", "an order", "it could not be sent: too many wait to be");
}

ExerciseDesk::ExerciseDesk(const wire::Participant& member, const std::string& exercise, station::Seat seat,
                           const std::string& name, LeverDesk::Changed levers_changed)
    : exercise_{exercise},
      role_{role_of(seat, exercise)},
      takes_over_{seat == station::Seat::instructor},
      feed_{wire::Participant(member, wire::exercise_partition(exercise)), Feed::Kind::exercise, role_.hears},
      writers_{feed_.participant(), role_.writes, name},
      levers_{[this](Hand hand, const nlohmann::json& sample) {
                  writers_.write(*lever_topic(hand), sample); // put() has seen that the role has it
              },
              std::move(levers_changed),
              [this](Hand hand) {
                  // Who takes over last has the levers; trainees' hands are equals.
                  if (takes_over_) writers_.outrank(*lever_topic(hand));
              }} {}

void ExerciseDesk::give(const wire::TopicInfo& topic, const nlohmann::json& sample) {
    if (!writers_.has(topic)) throw Refused(topic.name, "", "an order", "not for this seat");
    const bool to_replay = std::string_view(topic.name) == wire::topics::replay_command.name;
    const auto taker =
        feed_.writer(to_replay ? static_cast<const wire::TopicInfo&>(wire::topics::replay_status)
                               : wire::topics::exercise_status);
    if (!taker || !writers_.heard_by(topic, *taker))
        throw Refused(topic.name, "", "an order",
                      to_replay ? "no replay is heard here" : "no server is heard here");
    writers_.write(topic, sample);
}

void ExerciseDesk::tick(Clock::time_point now) {
    for (const Hand hand : {Hand::port, Hand::starboard, Hand::helm})
        if (levers_.holder(hand) != nullptr) look_whose_word_counts(hand);
    levers_.tick(now);
}

void ExerciseDesk::look_whose_word_counts(Hand hand) {
    const wire::TopicInfo& topic = *lever_topic(hand);
    const auto spoken = feed_.spoken(topic, instance_of(topic, key_of(hand)));
    if (!spoken) return;
    const bool own = writers_.is_own(topic, spoken->writer);
    levers_.heard(hand, own, own ? "" : source_of(hand, spoken->frame->payload), spoken->at);
}

const wire::TopicInfo* ExerciseDesk::lever_topic(Hand hand) const {
    const bool helm = hand == Hand::helm;
    for (const wire::TopicInfo* topic : role_.writes)
        if (is_lever_topic(*topic) && (std::string_view(topic->type) == "HelmCommand") == helm) return topic;
    return nullptr;
}

} // namespace windlass::gateway
