#include "recorder/debrief/attempt_reader.hpp"

#include "recorder/debrief/curves.hpp"
#include "recorder/recording/typed.hpp"

#include "idl/topics.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::debrief {

namespace topics = wire::topics;

namespace {

constexpr double kIntervals = 300;     // of a series: about one a point of a printed plot, 180 mm wide
constexpr double kLeastInterval = 0.1; // s
constexpr double kTruths = 0.1;        // s between them: a report is as quick as a finger
constexpr double kPlaces = 400;        // of the track
constexpr double kMoved = 1;           // m, between two places of an anchor
constexpr double kWorkedCable = 0.3;   // m, beyond what a cable under load stretches at the gypsy
constexpr double kSlack = 1;           // s of exercise, by which the last status may be older than a stream

bool side_exists(int side) {
    return side == SIDE_PORT || side == SIDE_STARBOARD;
}

bool on_the_ground(AnchorPhase phase) {
    return phase == ANCHOR_ON_BOTTOM || phase == ANCHOR_DIGGING_IN || phase == ANCHOR_HOLDING ||
           phase == ANCHOR_DRAGGING;
}

template <class From>
void add_to(std::vector<Series>& series, std::span<const Curve<From>> curves, const From& sample) {
    for (std::size_t i = 0; i < curves.size(); ++i)
        series[i].add(sample.time(), curves[i].of(sample));
}

int way_of(double from, double to) {
    return (to > from) - (to < from);
}
/// All zero: a hand says again where its levers stand, which it does many times a second.
Way way_of(const WindlassCommand& a, const WindlassCommand& b) {
    return {way_of(a.brake(), b.brake()), way_of(a.speed_lever(), b.speed_lever()),
            way_of(a.clutch_in(), b.clutch_in()), way_of(a.stopper_closed(), b.stopper_closed()),
            way_of(a.emergency_stop(), b.emergency_stop())};
}
Way way_of(const HelmCommand& a, const HelmCommand& b) {
    return {way_of(a.engine(), b.engine()), way_of(a.rudder(), b.rudder()),
            way_of(a.bow_thruster(), b.bow_thruster()), way_of(a.stern_thruster(), b.stern_thruster())};
}

} // namespace

double AttemptReader::interval_of(const Attempt& attempt) {
    return std::max(kLeastInterval, attempt.duration() / kIntervals);
}

AttemptReader::AttemptReader(Attempt& attempt, double interval) : attempt_(attempt), interval_(interval) {
    for (Side& side : attempt.sides)
        side.curves.assign(windlass_curves().size(), Series(interval));
    attempt.ship.assign(ship_curves().size(), Series(interval));
    attempt.weather.assign(weather_curves().size(), Series(interval));
}

std::set<std::string> AttemptReader::topics() {
    std::set<std::string> names;
    for (const wire::TopicInfo* topic : {static_cast<const wire::TopicInfo*>(&topics::windlass_load),
                                         static_cast<const wire::TopicInfo*>(&topics::chain_state),
                                         static_cast<const wire::TopicInfo*>(&topics::anchor_state),
                                         static_cast<const wire::TopicInfo*>(&topics::ship_state),
                                         static_cast<const wire::TopicInfo*>(&topics::environment_state),
                                         static_cast<const wire::TopicInfo*>(&topics::event),
                                         static_cast<const wire::TopicInfo*>(&topics::bridge_order),
                                         static_cast<const wire::TopicInfo*>(&topics::exercise_truth),
                                         static_cast<const wire::TopicInfo*>(&topics::assessment),
                                         static_cast<const wire::TopicInfo*>(&topics::order_taken),
                                         static_cast<const wire::TopicInfo*>(&topics::prediction),
                                         static_cast<const wire::TopicInfo*>(&topics::scene_description),
                                         static_cast<const wire::TopicInfo*>(&topics::seabed_description)})
        names.insert(topic->name);
    return names;
}

bool AttemptReader::read(const recording::Message& message, bool in_run) {
    const std::string& topic = message.topic();
    // One line a topic: what is of it is decoded and added; what came before the run is passed over.
    const auto is = [&](const auto& known) { return topic == known.name; };
    const auto with = [&]<class T>(const wire::Topic<T>&, bool wanted = true) {
        if (in_run && wanted) add(recording::decode<T>(message.payload));
    };
    try {
        if (is(topics::windlass_load)) with(topics::windlass_load);
        if (is(topics::chain_state)) with(topics::chain_state);
        if (is(topics::anchor_state)) with(topics::anchor_state);
        if (is(topics::ship_state)) with(topics::ship_state);
        if (is(topics::event)) with(topics::event);
        if (is(topics::bridge_order)) with(topics::bridge_order);
        if (is(topics::exercise_truth)) with(topics::exercise_truth);
        if (is(topics::assessment)) with(topics::assessment);
        if (is(topics::prediction)) with(topics::prediction);
        if (is(topics::environment_state)) with(topics::environment_state);
        if (is(topics::order_taken)) add(recording::decode<OrderTaken>(message.payload)); // knows its run
        if (is(topics::scene_description)) {
            auto scene = recording::decode<SceneDescription>(message.payload);
            attempt_.length_overall = scene.length_overall();
            attempt_.beam = scene.beam();
            attempt_.ship_form = std::move(scene);
        }
        if (is(topics::seabed_description))
            attempt_.bed = recording::decode<SeabedDescription>(message.payload);
    } catch (const mcap::Damage&) {
        return false;
    }
    return true;
}

bool AttemptReader::in_order(double time, double& last) const {
    if (!(time > last) || time < attempt_.began || time > attempt_.ended + kSlack) return false;
    last = time;
    return true;
}

void AttemptReader::add(const WindlassLoad& load) {
    if (!side_exists(load.side())) return;
    const auto index = static_cast<std::size_t>(load.side());
    OfSide& of = sides_[index];
    if (!in_order(load.time(), of.load)) return;
    Side& side = attempt_.sides[index];
    add_to(side.curves, windlass_curves(), load);
    side.breaking_load = load.breaking_load();
    side.brake_rating = load.brake_rating();
    side.cable_out = load.cable_out();
    side.brake_energy = load.brake_energy();
    of.now.tension = load.hawse_tension();
    of.now.brake = load.brake_position();
    of.now.brake_load = load.brake_load();
    of.now.brake_capacity = load.brake_capacity();
    of.now.cable_speed = load.cable_speed();
    of.now.stopper_closed = load.stopper_closed();
    of.now.power = load.power() && !load.tripped();
    if (!of.first) of.first = load;
    side.worked = side.worked || std::abs(load.cable_out() - of.first->cable_out()) > kWorkedCable ||
                  load.brake_position() != of.first->brake_position() ||
                  load.speed_lever() != of.first->speed_lever() || load.clutch() != of.first->clutch() ||
                  load.stopper_closed() != of.first->stopper_closed();
}

void AttemptReader::add(const ChainState& chain) {
    if (!side_exists(chain.side())) return;
    const auto index = static_cast<std::size_t>(chain.side());
    OfSide& of = sides_[index];
    if (chain.time() < of.chain + kTruths || !in_order(chain.time(), of.chain)) return;
    of.now.time = chain.time();
    of.now.cable_out = chain.cable_out();
    of.now.lead_clock = chain.lead_clock();
    of.now.stay = chain.stay();
    attempt_.sides[index].truths.push_back(of.now);
}

void AttemptReader::add(const AnchorState& anchor) {
    if (!side_exists(anchor.side())) return;
    const auto index = static_cast<std::size_t>(anchor.side());
    if (!in_order(anchor.time(), sides_[index].anchor)) return;
    sides_[index].now.anchor = anchor.phase();
    if (!on_the_ground(anchor.phase())) return;
    Side& side = attempt_.sides[index];
    side.dragged = std::max(side.dragged, anchor.dragged());
    sides_[index].now.dragged = side.dragged;
    const Vec3& now = anchor.position();
    if (!side.anchor.empty() &&
        std::hypot(now.x() - side.anchor.back().x(), now.y() - side.anchor.back().y()) < kMoved)
        return;
    side.anchor.push_back(now);
}

void AttemptReader::add(const ShipState& ship) {
    if (!in_order(ship.time(), ship_)) return;
    add_to(attempt_.ship, ship_curves(), ship);
    const double apart = interval_ * kIntervals / kPlaces;
    const Place place{ship.time(), ship.position().x(), ship.position().y(), ship.heading()};
    if (!attempt_.track.empty() && ship.time() < attempt_.track.back().time + apart) return;
    attempt_.track.push_back(place);
}

void AttemptReader::add(const EnvironmentState& air) {
    if (!in_order(air.time(), air_)) return;
    add_to(attempt_.weather, weather_curves(), air);
    attempt_.wave_seed = air.now().wave_seed();
}

bool AttemptReader::ours(std::uint64_t run) const {
    return run == attempt_.origin.run ||
           std::ranges::find(attempt_.origin.taken_up_from, run) != attempt_.origin.taken_up_from.end();
}

void AttemptReader::take_back_to(double time) {
    const auto later = [time](const auto& each) { return each.time > time; };
    std::erase_if(attempt_.events, [time](const Event& each) { return each.time() > time; });
    std::erase_if(attempt_.orders, [time](const GivenOrder& each) { return each.order.time() > time; });
    std::erase_if(attempt_.reports, later);
    std::erase_if(attempt_.lever_moves, later);
    std::erase_if(attempt_.words, later);
}

void AttemptReader::add(const Event& event) {
    if (event.code() == "exercise.taken_up") take_back_to(event.value());
    // Each run counts its events from 1.
    const auto known = [&](const Event& each) {
        return each.number() == event.number() && each.tick() == event.tick();
    };
    if (std::string_view(event.code().c_str()).starts_with("model.")) return;
    if (event.time() > attempt_.ended + kSlack || std::ranges::any_of(attempt_.events, known)) return;
    attempt_.events.push_back(event);
}

void AttemptReader::add(const BridgeOrder& order) {
    if (!ours(order.run())) return;
    const auto found = std::ranges::find_if(
        attempt_.orders, [&](const GivenOrder& each) { return each.order.number() == order.number(); });
    const double changed = attempt_.time_of(order.tick());
    if (found != attempt_.orders.end())
        *found = {order, changed};
    else
        attempt_.orders.push_back({order, changed});
}

void AttemptReader::add(const Prediction& prediction) {
    constexpr double kApart = 10; // s: predictions come every 2 s, the later the busier the machine
    constexpr double kReach = 60; // s that the last one goes, and is shown for
    constexpr double kJoined = 1; // s between two periods that are one
    if (!ours(prediction.run())) return;
    const double now = prediction.time();
    if (prediction.state() == PREDICTION_OFF) {
        if (sees_ahead_) attempt_.ahead.back().second = std::min(now, attempt_.ahead.back().second + kReach);
        sees_ahead_ = false;
    }
    if (prediction.moments().empty()) return;
    // However rarely they come: until they are switched off the newest one is shown.
    if (attempt_.ahead.empty() || (!sees_ahead_ && now - attempt_.ahead.back().second >= kJoined))
        attempt_.ahead.emplace_back(now, now);
    sees_ahead_ = true;
    attempt_.ahead.back().second = std::max(now, attempt_.ahead.back().second);
    for (const Event& event : prediction.events()) {
        const auto told = std::ranges::find_if(attempt_.foreseen, [&](const Foreseen& each) {
            return each.event.code() == event.code() && each.event.side() == event.side() &&
                   now - each.last_told <= kApart;
        });
        if (told != attempt_.foreseen.end())
            told->last_told = now;
        else
            attempt_.foreseen.push_back({.told = now, .last_told = now, .event = event});
    }
}

void AttemptReader::add(const ExerciseTruth& truth) {
    if (!ours(truth.run())) return;
    attempt_.definition_hash = truth.definition_hash();
    attempt_.depth = truth.depth();
    if (truth.title().size() > 0) attempt_.title = truth.title().to_string();
}

void AttemptReader::add(const Assessment& assessment) {
    if (!attempt_.assessment || assessment.tick() >= attempt_.assessment->tick())
        attempt_.assessment = assessment;
}

bool AttemptReader::Stroke::begins(const std::string& by, double time, const Way& way) {
    constexpr double kRest = 0.5; // s; a station sends levers that move every 0.05 s, a slow one each 0.1
    const bool goes_on = by == hand && time - last < kRest && way == towards;
    hand = by;
    last = time;
    towards = way;
    return !goes_on;
}

void AttemptReader::add(const OrderTaken& order) {
    if (!ours(order.run())) return;
    const double time = attempt_.time_of(order.tick());
    const std::string by = order.source().to_string();
    const auto count = [&](int Hand::*what) {
        if (by != "server") ++(attempt_.hands[by].*what);
    };
    switch (order.kind()) {
    case ORDER_TAKEN_WINDLASS: {
        const WindlassCommand& command = order.windlass();
        if (!side_exists(command.side())) return;
        OfSide& side = sides_[static_cast<std::size_t>(command.side())];
        const auto way = way_of(side.levers.value_or(WindlassCommand()), command);
        if (side.levers && way == Way{}) return;
        side.levers = command;
        if (side.stroke.begins(by, time, way)) count(&Hand::windlass);
        if (by != "server") attempt_.lever_moves.push_back({time, command.side(), by});
        return;
    }
    case ORDER_TAKEN_REPORT:
        count(&Hand::reports);
        attempt_.reports.push_back({time, order.tick(), by, order.report()});
        return;
    case ORDER_TAKEN_ASSESSMENT:
        count(&Hand::others);
        attempt_.words.push_back({time, by, order.assessment()});
        return;
    case ORDER_TAKEN_WATCH_CIRCLE:
        attempt_.watch = order.watch_circle().kept() ? std::optional(order.watch_circle()) : std::nullopt;
        return count(&Hand::others);
    case ORDER_TAKEN_HELM: {
        const auto way = way_of(helm_.value_or(HelmCommand()), order.helm());
        if (helm_ && way == Way{}) return;
        helm_ = order.helm();
        if (helm_stroke_.begins(by, time, way)) count(&Hand::helm);
        return;
    }
    case ORDER_TAKEN_BRIDGE_ORDER:
        return count(&Hand::orders);
    default:
        return count(&Hand::others);
    }
}

void AttemptReader::finish() {
    std::ranges::stable_sort(attempt_.events, {}, [](const Event& each) { return each.time(); });
    std::ranges::stable_sort(attempt_.orders, {}, [](const GivenOrder& each) { return each.order.number(); });
    std::ranges::stable_sort(attempt_.reports, {}, &SaidReport::time);
}

} // namespace windlass::debrief
