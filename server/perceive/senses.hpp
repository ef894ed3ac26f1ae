#pragma once
// How coarse eyes and instruments are, and what more than one seat feels.

#include "idl/types.hpp"
#include "server/exercise/picture/snapshot.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace windlass::perceive {

inline constexpr double kDegree = words::units::degree; ///< rad
inline constexpr double kKnot = words::units::knot;     ///< m/s

/// The nearest whole step; never -0, whose bytes differ.
inline double in_steps(double value, double step) {
    return std::round(value / step) * step + 0.0;
}

/// rad, 0 .. 2 pi, of any angle.
inline double round_the_compass(double angle) {
    const double turn = std::remainder(angle, 2 * std::numbers::pi);
    return turn < 0 ? turn + 2 * std::numbers::pi : turn + 0.0;
}

/// The same in whole steps, of which so many make a turn.
inline double round_the_compass(double angle, int steps) {
    const double step = 2 * std::numbers::pi / steps;
    return static_cast<double>(std::lround(round_the_compass(angle) / step) % steps) * step;
}

/// How strong something is by the thresholds that it has passed.
template <std::size_t N>
int passed(const std::array<double, N>& thresholds, double value) {
    return static_cast<int>(
        std::count_if(thresholds.begin(), thresholds.end(), [=](double t) { return value > t; }));
}

inline constexpr double kMarkStep = 0.25;      ///< m, about a link
inline constexpr double kSpeedSeenStep = 0.25; ///< m/s, of a cable by the eye; tuned

/// K, skin of the lining, from which it is warm to a hand, smells, smokes, burns.
inline constexpr std::array kLining{words::limits::lining_warm, words::limits::lining_smells,
                                    words::limits::lining_smokes, words::limits::lining_burns};
inline LiningSeen lining_noticed(double temperature) {
    return static_cast<LiningSeen>(passed(kLining, temperature));
}

/// What of the bridge's instruments works.
struct Instruments {
    bool gps = true, gyro = true, log = true, anemometer = true, echo_sounder = true, vhf = true, cctv = true;
};
/// By the faults that are there.
Instruments working(const std::vector<exercise::FaultView>& faults);

/// rad: starboard down and bow up are positive.
struct Tilt {
    double roll = 0, pitch = 0;
};
inline Tilt tilt(const exercise::ShipView& ship) {
    const Eigen::Matrix3d axes = ship.attitude.toRotationMatrix(); // columns: forward, port, up
    return {std::atan2(axes(2, 1), axes(2, 2)), std::asin(std::clamp(axes(2, 0), -1.0, 1.0))};
}

/// The wind as it meets a ship under way.
struct ApparentWind {
    double speed = 0;    ///< m/s
    double from_bow = 0; ///< rad clockwise from ahead, where it comes from
};
inline ApparentWind apparent_wind(const exercise::Snapshot& s) {
    const exercise::EnvironmentView& air = s.environment;
    const physics::Vec3 against = // m/s, towards where the wind comes from
        physics::compass(air.now.wind_from + air.swing) * (air.now.wind_speed + air.gust) + s.ship.velocity;
    const double speed = std::hypot(against.x(), against.y());
    if (speed == 0) return {};
    return {speed, round_the_compass(std::atan2(against.x(), against.y()) - s.ship.heading)};
}

/// Whether the anchor can be seen from deck: its middle is above the water, or it hangs at the hawse and its
/// shackle is, as at the waterline from a low bow.
inline bool above_water(const exercise::AnchorView& anchor) {
    using exercise::AnchorPhase;
    if (anchor.phase == AnchorPhase::lost) return false;
    const bool at_the_hawse = anchor.phase == AnchorPhase::housed || anchor.phase == AnchorPhase::acockbill;
    return anchor.position.z() >= 0 || (at_the_hawse && anchor.shackle.z() >= 0);
}

} // namespace windlass::perceive
