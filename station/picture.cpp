#include "station/picture.hpp"

#include <algorithm>

namespace windlass::station {

namespace {

template <class T>
void put(Latest<T>& latest, const T& sample, Clock::time_point now) {
    latest.sample = sample;
    latest.at = now;
}

// A side that is not on board is no reason to write outside the array: the sample is dropped.
TacklePicture* tackle_of(Picture& picture, std::int32_t side) {
    return side == SIDE_PORT || side == SIDE_STARBOARD ? &picture.tackle[static_cast<std::size_t>(side)]
                                                       : nullptr;
}

void widen(Extremes& extremes, const WindlassLoad& load) {
    if (load.hawse_tension() > extremes.hawse_tension) {
        extremes.hawse_tension = load.hawse_tension();
        extremes.hawse_tension_time = load.time();
    }
    extremes.brake_load = std::max(extremes.brake_load, load.brake_load());
    extremes.pay_out_speed = std::max(extremes.pay_out_speed, load.cable_speed());
    extremes.lining_temperature = std::max(extremes.lining_temperature, load.lining_temperature());
}

void widen(SeenExtremes& seen, const ForecastleView& view) {
    if (view.gypsy_load_indicated() > seen.load) {
        seen.load = view.gypsy_load_indicated();
        seen.load_time = view.time();
    }
    const double speed = view.counter_fitted() ? view.cable_speed_indicated() : view.cable_speed_seen();
    seen.pay_out_speed = std::max(seen.pay_out_speed, speed);
    seen.lining = std::max(seen.lining, view.lining());
}

bool waits(const BridgeOrder& order) {
    return order.state() == ORDER_GIVEN || order.state() == ORDER_MISREPEATED ||
           order.state() == ORDER_NOT_REPEATED;
}

/// Among the events after so many, newest last: "TOPIC from SOURCE: FIELD = VALUE refused; allowed: ..."
template <class T>
std::optional<std::string> refused_in(const EventLog<T>& log, std::uint64_t seen, const std::string& source,
                                      double since) {
    const std::string sender = " from " + source + ":";
    for (const T& event : log.after(seen)) {
        std::string text = event.text().to_string();
        if (event.code() == "command.refused" && event.time() >= since &&
            text.find(sender) != std::string::npos)
            return text;
    }
    return std::nullopt;
}

} // namespace

void Picture::receive(const ExerciseStatus& sample, Clock::time_point now) {
    put(status, sample, now);
}
void Picture::receive(const ExerciseTruth& sample, Clock::time_point now) {
    put(truth, sample, now);
}
void Picture::receive(const EnvironmentState& sample, Clock::time_point now) {
    put(environment, sample, now);
}
void Picture::receive(const ShipState& sample, Clock::time_point now) {
    put(ship, sample, now);
}
void Picture::receive(const BridgeView& sample, Clock::time_point now) {
    put(bridge, sample, now);
}
void Picture::receive(const HelmCommand& sample, Clock::time_point now) {
    put(helm, sample, now);
}
void Picture::take_instructor(const HelmCommand& sample, Clock::time_point now) {
    put(instructor_helm, sample, now);
}

void Picture::receive(const AnchorState& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->anchor, sample, now);
}

void Picture::receive(const ChainState& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->chain, sample, now);
}

void Picture::receive(const WindlassCommand& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->levers, sample, now);
}

void Picture::take_instructor(const WindlassCommand& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->instructor_levers, sample, now);
}

void Picture::receive(const WindlassLoad& sample, Clock::time_point now) {
    auto* found = tackle_of(*this, sample.side());
    if (!found) return;
    if (found->load && sample.tick() < found->load->tick()) found->extremes = {};
    put(found->load, sample, now);
    widen(found->extremes, sample);
}

void Picture::receive(const ForecastleView& sample, Clock::time_point now) {
    auto* found = tackle_of(*this, sample.side());
    if (!found) return;
    if (found->view && sample.tick() < found->view->tick()) found->seen = {};
    put(found->view, sample, now);
    widen(found->seen, sample);
}

void Picture::receive(const Event& sample, Clock::time_point) {
    events.receive(sample);
}

void Picture::take_forecastle_event(const SeatEvent& sample, Clock::time_point) {
    seat_events[0].receive(sample);
}

void Picture::take_bridge_event(const SeatEvent& sample, Clock::time_point) {
    seat_events[1].receive(sample);
}

void Picture::take_event_beside(const SeatEvent& sample, Clock::time_point) {
    seat_events[1].receive(sample, sample.forecastle());
}

void Picture::take_forecastle_question(const Question& sample, Clock::time_point now) {
    put(questions[0], sample, now);
}

void Picture::take_bridge_question(const Question& sample, Clock::time_point now) {
    put(questions[1], sample, now);
}

void Picture::take_instruction(const SeatEvent& sample, Clock::time_point) {
    instructions[sample.forecastle() ? 0 : 1].receive(sample);
}

void Picture::receive(const Alert& sample, Clock::time_point) {
    std::erase_if(alerts, [&](const Alert& other) {
        return other.code() == sample.code() && other.side() == sample.side();
    });
    if (sample.condition() != ALERT_NORMAL) alerts.push_back(sample);
}

void Picture::receive(const BridgeOrder& sample, Clock::time_point) {
    if (!orders.empty() && sample.run() < orders.back().run()) return; // a late word of a run that is over
    if (!orders.empty() && sample.run() > orders.back().run()) orders.clear();
    const auto at = std::ranges::find_if(
        orders, [&](const BridgeOrder& other) { return other.number() >= sample.number(); });
    if (at != orders.end() && at->number() == sample.number())
        *at = sample;
    else
        orders.insert(at, sample);
}

void Picture::receive(const Report& sample, Clock::time_point) {
    if (!bridge || bridge->vhf_works()) reports.add(sample);
}

std::optional<std::string> Picture::refusal(const std::string& source, const LogsRead& seen,
                                            double since) const {
    auto told = refused_in(events, seen.events, source, since);
    for (std::size_t seat = 0; seat < seat_events.size() && !told; ++seat)
        told = refused_in(seat_events[seat], seen.seat_events[seat], source, since);
    return told;
}

const BridgeOrder* Picture::order_to_repeat() const {
    if (!orders.empty() && status && status->run() != orders.back().run()) return nullptr; // of a run before
    const auto found = std::find_if(orders.rbegin(), orders.rend(), waits);
    return found == orders.rend() ? nullptr : &*found;
}

const BridgeOrder* Picture::order(BridgeOrderCode code) const {
    const auto found = std::find_if(orders.rbegin(), orders.rend(),
                                    [code](const BridgeOrder& order) { return order.code() == code; });
    return found == orders.rend() ? nullptr : &*found;
}

double Picture::time(int side) const {
    using namespace std::chrono_literals;
    if (!status) return 0;
    const TacklePicture& one = tackle.at(static_cast<std::size_t>(side));
    double newest = status->time();
    // What was heard of a windlass that the exercise has no more is of another time.
    if (one.view && *one.view.at > *status.at - 1s) newest = std::max(newest, one.view->time());
    if (one.load && *one.load.at > *status.at - 1s) newest = std::max(newest, one.load->time());
    return newest;
}

bool Picture::replayed() const {
    return status && status->state() == RUN_REPLAY;
}

std::optional<double> Picture::silence(Clock::time_point now) const {
    if (!status) return std::nullopt;
    const auto age = [now](Clock::time_point at) { return std::chrono::duration<double>(now - at).count(); };
    double silent = age(*status.at);
    // A paused exercise sends its status only; a running one must send views or loads too.
    if (status->state() != RUN_RUNNING) return silent;
    for (const auto& each : tackle) {
        if (each.view) silent = std::max(silent, age(*each.view.at));
        if (each.load) silent = std::max(silent, age(*each.load.at));
    }
    return silent;
}

} // namespace windlass::station
