#include "server/exercise/weather.hpp"

#include "server/physics/base/state_limits.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace windlass::exercise {

namespace {

using physics::CurrentLayer;

constexpr double kTurn = 2 * std::numbers::pi;

constexpr std::array kStraight{
    &Weather::wind_speed,  &Weather::gust_factor, &Weather::gust_period,   &Weather::veering,
    &Weather::wave_height, &Weather::wave_period, &Weather::swell_height,  &Weather::swell_period,
    &Weather::tide_height, &Weather::visibility,  &Weather::current_speed,
};
constexpr std::array kAngles{&Weather::wind_from, &Weather::wave_from, &Weather::swell_from,
                             &Weather::current_towards};

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

/// The layers stand where those of the profile to come are; where it has none, where they were.
void blend(const std::vector<CurrentLayer>& before, const std::vector<CurrentLayer>& after, double share,
           std::vector<CurrentLayer>& now) {
    now = after.empty() ? before : after;
    for (CurrentLayer& layer : now) {
        const auto from = along_and_across(before, layer.depth), to = along_and_across(after, layer.depth);
        const double along = from[0] + share * (to[0] - from[0]);
        const double across = from[1] + share * (to[1] - from[1]);
        layer.share = std::hypot(along, across);
        layer.turn = std::atan2(across, along);
    }
}

bool same(const std::vector<CurrentLayer>& a, const std::vector<CurrentLayer>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.depth == y.depth && x.share == y.share && x.turn == y.turn;
    });
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
    for (const auto field : kStraight)
        now_.*field = before_.*field + share * (after_.*field - before_.*field);
    for (const auto field : kAngles)
        now_.*field =
            wrapped(before_.*field + share * std::remainder(after_.*field - before_.*field, kTurn), kTurn);
    now_.time_of_day = wrapped(
        before_.time_of_day + share * std::remainder(after_.time_of_day - before_.time_of_day, kDay), kDay);
    now_.wave_seed = after_.wave_seed;
    if (!same(now_.current_profile, after_.current_profile))
        blend(before_.current_profile, after_.current_profile, share, now_.current_profile);
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
    auto& [wind_speed, wind_from, gust_factor, gust_period, veering, wave_height, wave_period, wave_from,
           swell_height, swell_period, swell_from, wave_seed, current_speed, current_towards, current_profile,
           tide_height, visibility, time_of_day] = weather;
    WINDLASS_STATE(v, wind_speed, wind_from, gust_factor, gust_period, veering, wave_height, wave_period,
                   wave_from, swell_height, swell_period, swell_from, wave_seed, current_speed,
                   current_towards, tide_height, visibility, time_of_day);
    constexpr double kMaxWind = words::limits::wind_most, kMaxVeering = 0.1; // as orders may ask for
    constexpr double kMaxCurrent = 15, kMaxTide = 50;                        // and what a tide adds to it
    constexpr double kMaxGust = 5, kMaxPeriod = 3600, kMaxHeight = 30;
    v.within({"wind_speed"}, wind_speed, 0, kMaxWind);
    v.within({"veering"}, veering, -kMaxVeering, kMaxVeering);
    v.within({"current_speed"}, current_speed, 0, kMaxCurrent);
    v.within({"tide_height"}, tide_height, -kMaxTide, kMaxTide);
    WINDLASS_WITHIN(v, -physics::kMostTurned, physics::kMostTurned, wind_from, wave_from, swell_from,
                    current_towards);
    WINDLASS_WITHIN(v, 0, kMaxGust, gust_factor);
    WINDLASS_WITHIN(v, 0, kMaxPeriod, gust_period, wave_period, swell_period);
    WINDLASS_WITHIN(v, 0, kMaxHeight, wave_height, swell_height);
    WINDLASS_WITHIN(v, 0, physics::kFarthest, visibility);
    WINDLASS_WITHIN(v, 0, physics::kLongest, time_of_day);
    v.length({"layers"}, current_profile, kMaxCurrentLayers);
    for (auto& [depth, share, turn] : current_profile) {
        WINDLASS_STATE(v, depth, share, turn);
        WINDLASS_WITHIN(v, 0, physics::kFarthest, depth);
        WINDLASS_WITHIN(v, -100, 100, share, turn);
    }
}
WINDLASS_STATE_LISTED(Weather);

} // namespace windlass::exercise
