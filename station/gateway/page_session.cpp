#include "station/gateway/page_session.hpp"

#include "station/wind_sea.hpp"

#include <fmt/format.h>

namespace windlass::gateway {

using nlohmann::json;

namespace {

json value(const json& message, const char* name) {
    const auto found = message.is_object() ? message.find(name) : message.end();
    return message.is_object() && found != message.end() ? *found : json();
}

std::string text_of(const json& message, const char* name) {
    const json found = value(message, name);
    if (!found.is_string()) throw Refused("", name, found.is_null() ? "nothing" : "no text", "a text");
    return found.get<std::string>();
}

/// A figure above least, up to most.
double figure_of(const json& message, const char* name, double least, double most) {
    const json found = value(message, name);
    const bool fits = found.is_number() && found.get<double>() > least && found.get<double>() <= most;
    if (!fits) throw Refused("", name, found.dump(), fmt::format("above {:g}, up to {:g}", least, most));
    return found.get<double>();
}

json side_of(Hand hand) {
    return hand == Hand::helm ? json{{"helm", true}}
                              : json{{"side", hand == Hand::port ? SIDE_PORT : SIDE_STARBOARD}};
}

Hand hand_of(const json& message) {
    return value(message, "side") == SIDE_STARBOARD ? Hand::starboard : Hand::port;
}

} // namespace

PageSession::PageSession(PageHost& host, std::shared_ptr<PageDesk> desk, std::vector<Source*> sources,
                         Transport& transport, std::string name)
    : FoxgloveSession{std::move(sources), transport},
      host_{host},
      desk_{std::move(desk)},
      name_{std::move(name)} {
    if (!name_.empty()) desk_->call(this, name_);
}

PageSession::~PageSession() {
    PageSession::close();
}

void PageSession::open() {
    host_.log("a page opens in exercise " + desk_->exercise());
    tell_hello(host_.hello(*this));
    FoxgloveSession::open();
    for (const Hand hand : {Hand::port, Hand::starboard, Hand::helm})
        if (const auto holder = desk_->levers().holder(hand)) tell_levers(hand, holder);
}

void PageSession::close() {
    if (!std::exchange(open_, false)) return;
    look_ahead_no_more();
    FoxgloveSession::close();
    host_.forget(*this);
    desk_->leave(this);
}

/// Whoever has left the desk sees no prediction: none is made for him, and the record says of none that he
/// saw it.
void PageSession::look_ahead_no_more() {
    if (!std::exchange(looks_ahead_, false)) return;
    try {
        desk_->give(wire::topics::exercise_command, {{"action", "EXERCISE_PREDICT"}, {"predict", false}},
                    name_);
    } catch (const std::exception& error) { // its server is gone: nothing is predicted there
        host_.log(error.what());
    }
}

void PageSession::tell_hello(const json& hello) {
    if (hello == hello_) return;
    hello_ = hello;
    send(hello);
}

void PageSession::tell_levers(Hand hand, LeverDesk::Page holder, const std::string& taken_by) {
    json message = side_of(hand);
    message["op"] = "levers";
    message["held"] = holder != nullptr;
    message["by"] = holder == nullptr ? "nobody" : holder == this ? "this" : "another";
    if (!taken_by.empty()) message["taken_by"] = taken_by;
    send(message);
}

void PageSession::tell_alerts(const json& alerts) {
    if (alerts == alerts_) return;
    alerts_ = alerts;
    send(alerts);
}

void PageSession::tell_sent(const json& id) {
    send({{"op", "sent"}, {"id", id}});
}

void PageSession::tell(const json& id, const json& message) {
    send(message);
    tell_sent(id);
}

void PageSession::tell_refused(const json& id, const Refused& refusal) {
    host_.log(refusal.what());
    send({{"op", "refused"},
          {"id", id},
          {"topic", refusal.topic},
          {"field", refusal.field},
          {"value", refusal.value},
          {"allowed", refusal.allowed},
          {"again", refusal.again},
          {"text", refusal.what()}});
}

void PageSession::refuse(const json& message, const std::string& why) {
    tell_refused(value(message, "id"), Refused("", "", "this message", why));
}

bool PageSession::handle(const std::string& op, const json& message) {
    try {
        if (op == "levers")
            levers(hand_of(message), message);
        else if (op == "helm")
            levers(Hand::helm, message);
        else if (op == "let_go_levers")
            let_go(message);
        else if (op == "order")
            order(message);
        else if (op == "record")
            record(message);
        else if (op == "continue_live")
            continue_live(message);
        else if (op == "read_recording")
            host_.read_events(*this, value(message, "id"), text_of(message, "recording"));
        else if (op == "debrief")
            host_.debrief(*this, value(message, "id"), text_of(message, "recording"));
        else if (op == "replay")
            replay(message);
        else if (op == "exercise_files")
            exercise_files(message);
        else if (op == "wind_sea")
            wind_sea(message);
        else if (op == "watch_classroom")
            watch_classroom(message);
        else if (op == "camera")
            camera(message);
        else
            return FoxgloveSession::handle(op, message);
    } catch (const Refused& refusal) {
        tell_refused(value(message, "id"), refusal);
    }
    return true;
}

void PageSession::levers(Hand hand, const json& message) {
    const wire::TopicInfo* topic = desk_->lever_topic(hand);
    if (topic == nullptr)
        throw Refused(hand == Hand::helm ? "HelmCommand" : "WindlassCommand", "", "a hand on these levers",
                      "not for this seat");
    const json sample = hand == Hand::helm ? helm_levers(*topic, message) : windlass_levers(*topic, message);
    if (!desk_->levers().put(hand, this, sample, now()))
        throw Refused(topic->name, "", "a hand on these levers", "another page of this station has them");
    // A page says twenty times a second where its levers are: that alone is nobody's doing.
    if (json& before = set_.at(static_cast<std::size_t>(hand)); before != sample) {
        before = sample;
        acted_ = now();
    }
}

void PageSession::let_go(const json& message) {
    if (value(message, "helm") == true)
        desk_->levers().let_go(Hand::helm, this);
    else if (value(message, "side") == SIDE_PORT || value(message, "side") == SIDE_STARBOARD)
        desk_->levers().let_go(hand_of(message), this);
    else
        throw Refused("", "side", "nothing", "0 (port) or 1 (starboard), or helm: true");
}

void PageSession::order(const json& message) {
    const std::string name = text_of(message, "topic");
    const wire::TopicInfo* topic = find_topic(name);
    if (topic == nullptr) throw Refused("", "topic", "that name", "a topic of the wire");
    if (is_lever_topic(*topic)) throw Refused(topic->name, "", "an order", "levers go by op levers and helm");
    if (topic->name == std::string_view(wire::topics::restore_command.name))
        throw Refused(topic->name, "", "an order", "a recording is taken up by op continue_live");
    const json sample = value(message, "sample");
    if (!host_.order_classroom(*topic, sample, name_)) desk_->give(*topic, sample, name_);
    host_.tell_given(*this, topic->name);
    if (topic->name == std::string_view(wire::topics::exercise_command.name) &&
        value(sample, "action") == "EXERCISE_PREDICT")
        looks_ahead_ = value(sample, "predict") == true;
    acted_ = now();
    tell_sent(value(message, "id"));
}

void PageSession::record(const json& message) {
    const json on = value(message, "on");
    if (!on.is_boolean()) throw Refused("", "on", "nothing", "true or false");
    const json name = value(message, "name");
    host_.record(desk_->exercise(), on.get<bool>(), name.is_string() ? name.get<std::string>() : "");
    tell_sent(value(message, "id"));
}

void PageSession::replay(const json& message) {
    const std::string recording = text_of(message, "recording");
    tell(value(message, "id"),
         {{"op", "replay"}, {"recording", recording}, {"exercise", host_.replay(recording)}});
}

void PageSession::exercise_files(const json& message) {
    json request = json::object();
    for (const char* field : {"what", "name", "text", "over"})
        request[field] = value(message, field).is_string() ? value(message, field) : json("");
    host_.ask_exercise_files(*this, value(message, "id"), request);
}

void PageSession::wind_sea(const json& message) {
    constexpr double kWindMost = 100, kFetchMost = 1e7,
                     kDepthMost = 1e5; // m/s, m, m: no wind, no ocean has more
    const auto sea = station::wind_sea(figure_of(message, "wind_speed", 0, kWindMost),
                                       figure_of(message, "fetch", 0, kFetchMost),
                                       figure_of(message, "depth", 0, kDepthMost));
    tell(value(message, "id"), {{"op", "wind_sea"}, {"height", sea.height}, {"period", sea.period}});
}

void PageSession::watch_classroom(const json& message) {
    if (!host_.sees_truth()) throw Refused("", "", "the classroom's alerts", "for an instructor");
    watches_classroom_ = true;
    tell_sent(value(message, "id"));
}

void PageSession::camera(const json& message) {
    const std::string exercise = text_of(message, "exercise");
    const json since = value(message, "since");
    if (!since.is_number_integer()) throw Refused("", "since", since.dump(), "0, or at of the last answer");
    json answer = host_.look_at_forecastle(exercise, since.get<std::int64_t>());
    answer["op"] = "camera";
    answer["exercise"] = exercise;
    tell(value(message, "id"), answer);
}

void PageSession::continue_live(const json& message) {
    const json position = value(message, "position");
    if (!position.is_number() || position.get<double>() < 0)
        throw Refused("", "position", "this", "s from the recording's beginning");
    host_.continue_live(*this, value(message, "id"), text_of(message, "recording"), position.get<double>(),
                        text_of(message, "exercise"));
}

} // namespace windlass::gateway
