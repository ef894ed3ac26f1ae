#include "server/exercise/weather/weather.hpp"

#include "server/exercise/weather/weather_table.hpp"
#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace windlass::exercise {

namespace {

using physics::CurrentLayer;

constexpr double kTurn = 2 * std::numbers::pi;

/// value, from 0 up to a whole.
double wrapped(double value, double whole) {
    const double rest = std::fmod(value, whole);
    return rest < 0 ? rest + whole : rest;
}

/// Where the current goes at a depth, in shares of its speed along and across the direction that is named.
std::array<double, 2> along_and_across(const std::vector<CurrentLayer>& profile, double depth) {
    const auto flow = [](const CurrentLayer& layer) {
        return std::array{layer.share * std::cos(layer.turn), layer.share * std::sin(layer.turn)};
    };
    if (profile.empty()) return {1, 0};
    const auto below = std::find_if(profile.begin(), profile.end(),
                                    [=](const CurrentLayer& layer) { return layer.depth > depth; });
    if (below == profile.begin()) return flow(profile.front());
    if (below == profile.end()) return flow(profile.back());
    const CurrentLayer &a = *(below - 1), &b = *below;
    const double share = (depth - a.depth) / (b.depth - a.depth);
    const auto above = flow(a), under = flow(b);
    return {above[0] + share * (under[0] - above[0]), above[1] + share * (under[1] - above[1])};
}

bool same(const std::vector<CurrentLayer>& a, const std::vector<CurrentLayer>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.depth == y.depth && x.share == y.share && x.turn == y.turn;
    });
}

/// The layers stand where those of the profile to come are; where it has none, where they were. A profile
/// that is there already stays.
void blend(const std::vector<CurrentLayer>& before, const std::vector<CurrentLayer>& after, double share,
           std::vector<CurrentLayer>& now) {
    if (same(now, after)) return;
    now = after.empty() ? before : after;
    for (CurrentLayer& layer : now) {
        const auto from = along_and_across(before, layer.depth), to = along_and_across(after, layer.depth);
        const double along = from[0] + share * (to[0] - from[0]);
        const double across = from[1] + share * (to[1] - from[1]);
        layer.share = std::hypot(along, across);
        layer.turn = std::atan2(across, along);
    }
}

} // namespace

void lay_weather(const Weather& weather, physics::EnvironmentDef& environment) {
    environment.wind_speed = weather.wind_speed, environment.wind_from = weather.wind_from;
    environment.current_speed = weather.current_speed;
    environment.current_towards = weather.current_towards;
    environment.current_profile = weather.current_profile;
    environment.level = weather.tide_height;
}

double least_wave_period(double height) {
    constexpr double kLengths =
        14; // steepness 1/15 is the practice's bound for seas of up to 8 s (NORSOK N-003)
    if (height <= 0) return 0;
    return std::max(2.0, std::sqrt(kTurn * kLengths * height / physics::kGravity));
}

physics::SeaDef sea_of(const Weather& weather) {
    return {.wave_height = weather.wave_height,
            .wave_period = weather.wave_period,
            .wave_from = weather.wave_from,
            .swell_height = weather.swell_height,
            .swell_period = weather.swell_period,
            .swell_from = weather.swell_from,
            .seed = weather.wave_seed};
}

void WeatherInRamp::order(const Weather& weather, double ramp) {
    assert(ramp >= 0 && "orders are checked before");
    before_ = now_;
    after_ = weather;
    ramp_ = left_ = ramp;
    if (ramp == 0) now_ = before_ = after_;
}

bool WeatherInRamp::advance(double dt) {
    assert(dt > 0 && "a tick takes time");
    const double veered = now_.veering * dt;
    for (Weather* weather : {&now_, &before_, &after_}) {
        weather->time_of_day = wrapped(weather->time_of_day + dt, kDay);
        if (veered != 0) weather->wind_from = wrapped(weather->wind_from + veered, kTurn);
    }
    if (left_ == 0) return veered != 0;
    left_ = std::max(0.0, left_ - dt);
    if (left_ == 0) {
        now_ = before_ = after_;
        return true;
    }
    const double share = 1 - left_ / ramp_;
    const auto on_its_way = [share](double before, double after, double whole) {
        return wrapped(before + share * std::remainder(after - before, whole), whole);
    };
    for_each_field<Weather>([&](auto field) {
        auto& now = field.of(now_);
        const auto &before = field.of(before_), &after = field.of(after_);
        if constexpr (std::is_integral_v<std::decay_t<decltype(now)>>)
            now = after;
        else if constexpr (field.name == "time_of_day")
            now = on_its_way(before, after, kDay);
        else if constexpr (field.name == "current_profile")
            blend(before, after, share, now);
        else if constexpr (weather_row(field.name).is_direction())
            now = on_its_way(before, after, kTurn);
        else
            now = before + share * (after - before);
    });
    return true;
}

void WeatherInRamp::run_tide(const Tide& change) {
    for (Weather* weather : {&now_, &before_, &after_}) {
        weather->tide_height += change.height;
        if (change.stream.isZero(0)) continue;
        const physics::Vec3 stream =
            weather->current_speed * physics::compass(weather->current_towards) + change.stream;
        weather->current_speed = stream.norm();
        weather->current_towards = wrapped(std::atan2(stream.x(), stream.y()), kTurn);
    }
}

template <class Visitor, physics::StateOf<WeatherInRamp> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.now_, self.before_, self.after_, self.ramp_, self.left_);
    v.within({"ramp"}, self.ramp_, 0, 86400.0); // s, as orders may ask for
    v.within({"left"}, self.left_, 0, self.ramp_);
}
WINDLASS_STATE_LISTED(WeatherInRamp);

template <class Visitor, physics::StateOf<Weather> State>
void visit_state(Visitor& v, State& weather) {
    constexpr double kMaxCurrent = 15, kMaxTide = 50; // what orders may ask for, and what a tide adds to it
    for_each_field<Weather>([&](auto field) {
        auto& value = field.of(weather);
        constexpr physics::FieldName kName{field.name};
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
            v.field(kName, value);
            constexpr WeatherRow kRow = weather_row(field.name);
            if constexpr (kRow.is_direction())
                v.within(kName, value, -physics::kMostTurned, physics::kMostTurned);
            else if constexpr (field.name == "current_speed")
                v.within(kName, value, 0, kMaxCurrent);
            else if constexpr (field.name == "tide_height")
                v.within(kName, value, -kMaxTide, kMaxTide);
            else if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>)
                v.within(kName, value, kRow.low * kRow.si(), kRow.high * kRow.si());
        }
    });
    auto& current_profile = weather.current_profile;
    v.length({"layers"}, current_profile, kMaxCurrentLayers);
    for (auto& [depth, share, turn] : current_profile) {
        WINDLASS_STATE(v, depth, share, turn);
        WINDLASS_WITHIN(v, 0, physics::kFarthest, depth);
        WINDLASS_WITHIN(v, -100, 100, share, turn);
    }
}
WINDLASS_STATE_LISTED(Weather);

} // namespace windlass::exercise
