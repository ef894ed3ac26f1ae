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

} // namespace

void Picture::take(const ExerciseStatus& sample, Clock::time_point now) {
    put(status, sample, now);
}
void Picture::take(const ShipState& sample, Clock::time_point now) {
    put(ship, sample, now);
}
void Picture::take(const HelmCommand& sample, Clock::time_point now) {
    put(helm, sample, now);
}

void Picture::take(const AnchorState& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->anchor, sample, now);
}

void Picture::take(const ChainState& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->chain, sample, now);
}

void Picture::take(const WindlassCommand& sample, Clock::time_point now) {
    if (auto* found = tackle_of(*this, sample.side())) put(found->levers, sample, now);
}

void Picture::take(const WindlassLoad& sample, Clock::time_point now) {
    auto* found = tackle_of(*this, sample.side());
    if (!found) return;
    if (found->load && sample.tick() < found->load->tick()) found->extremes = {};
    put(found->load, sample, now);
    widen(found->extremes, sample);
}

void Picture::take(const Event& sample, Clock::time_point) {
    if (!events.empty() && sample.number() <= events.back().number()) {
        events.clear();
        ++runs;
    }
    events.push_back(sample);
    if (events.size() > kEventsKept) events.pop_front();
    ++events_received;
}

void Picture::take(const Alert& sample, Clock::time_point) {
    std::erase_if(alerts, [&](const Alert& other) {
        return other.code() == sample.code() && other.side() == sample.side();
    });
    if (sample.condition() != ALERT_NORMAL) alerts.push_back(sample);
}

std::vector<Event> Picture::events_after(std::uint64_t seen) const {
    const auto fresh = std::min<std::uint64_t>(events_received - seen, events.size());
    return {events.end() - static_cast<std::ptrdiff_t>(fresh), events.end()};
}

std::optional<std::string> Picture::refusal(const std::string& source, std::uint64_t seen,
                                            double since) const {
    // "TOPIC from SOURCE: FIELD = VALUE refused; allowed: ..."
    const std::string sender = " from " + source + ":";
    for (const Event& event : events_after(seen)) {
        std::string text = event.text().to_string();
        if (event.code() == "command.refused" && event.time() >= since &&
            text.find(sender) != std::string::npos)
            return text;
    }
    return std::nullopt;
}

double Picture::time(int side) const {
    using namespace std::chrono_literals;
    const auto& load = tackle.at(static_cast<std::size_t>(side)).load;
    // Loads of a windlass that the exercise has no more are of another time.
    const bool heard = load && status && *load.at > *status.at - 1s;
    return heard ? std::max(load->time(), status->time()) : status->time();
}

bool Picture::replayed() const {
    return status && status->state() == RUN_REPLAY;
}

std::optional<double> Picture::silence(Clock::time_point now) const {
    if (!status) return std::nullopt;
    const auto age = [now](Clock::time_point at) { return std::chrono::duration<double>(now - at).count(); };
    double silent = age(*status.at);
    // A paused exercise sends its status only; a running one must send loads too.
    if (status->state() != RUN_RUNNING) return silent;
    for (const auto& each : tackle)
        if (each.load) silent = std::max(silent, age(*each.load.at));
    return silent;
}

} // namespace windlass::station
