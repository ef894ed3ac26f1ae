#include "server/physics/ship/foreign_ship.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

enum { kEast, kNorth, kUp, kHeading, kRoll, kPitch };

constexpr double kTakeUp = 0.2;                            // m/s, at which a place's difference is taken up
constexpr double kTakeUpTurn = 1 * std::numbers::pi / 180; // rad/s, an angle's
constexpr double kLeastBlend = 0.05;                       // s: samples come 20 times a second at least
constexpr double kFade = 10;                               // s, of foreign waves after a release
constexpr double kClockDrift = 1e-4;                       // of two clocks; a cheap one is off by 5e-5

bool is_angle(std::size_t i) {
    return i >= kHeading;
}

double turn_between(double from, double to) {
    return std::remainder(to - from, 2 * std::numbers::pi);
}

} // namespace

ForeignShip::Motion ForeignShip::motion_of(const ForeignSample& sample) {
    const Eigen::Matrix3d axes = sample.attitude.normalized().toRotationMatrix();
    const double heading = std::atan2(axes(0, 0), axes(1, 0));
    const double pitch = std::asin(std::clamp(axes(2, 0), -1.0, 1.0));
    const double roll = std::atan2(axes(2, 1), axes(2, 2));
    // The inverse of spin(): her turning is that of yaw, pitch and roll, each about its own axis.
    Eigen::Matrix3d about;
    about.col(0) = -Vec3::UnitZ();
    about.col(1) = Vec3(std::cos(heading), -std::sin(heading), 0);
    about.col(2) = axes.col(0);
    const Vec3 rates = about.inverse() * sample.angular_velocity;
    return {{sample.position.x(), sample.position.y(), sample.position.z(), heading, roll, pitch},
            {sample.velocity.x(), sample.velocity.y(), sample.velocity.z(), rates[0], rates[2], rates[1]}};
}

ForeignShip::Motion ForeignShip::motion_of(const ShipState& ship) {
    const Vec3 at = midships(ship), velocity = ship_velocity(ship) + wave_velocity(ship);
    const WaveMotion& w = ship.waves;
    const Flotation& f = ship.floats;
    return {{at.x(), at.y(), w.heave + f.heave, ship.heading, roll(ship), pitch(ship)},
            {velocity.x(), velocity.y(), velocity.z(), ship.yaw_rate, w.roll_rate + f.heel_rate,
             w.pitch_rate + f.trim_rate}};
}

/// The last sample at its own velocity until kLate, which then falls to nothing until kStill.
ForeignShip::Motion ForeignShip::carried_on(double now) const {
    const double age = now - (sent_ + offset_), lost = std::clamp(age, kLate, kStill) - kLate;
    const double left = 1 - lost / (kStill - kLate);
    const double way = std::min(age, kLate) + 0.5 * (1 + left) * lost;
    Motion motion = last_;
    for (std::size_t i = 0; i < motion.place.size(); ++i) {
        motion.place[i] += motion.rate[i] * way;
        motion.rate[i] *= left;
    }
    return motion;
}

/// What is still to be taken up at now: Hermite's cubics, from the whole of place and rate to nothing of
/// both.
ForeignShip::Motion ForeignShip::behind(double now) const {
    const double t = (now - blend_from_) / blend_time_;
    if (t >= 1) return {};
    const double of_place = (2 * t - 3) * t * t + 1, of_rate = ((t - 2) * t + 1) * t;
    const double rate_of_place = 6 * t * (t - 1), rate_of_rate = (3 * t - 4) * t + 1;
    Motion left;
    for (std::size_t i = 0; i < left.place.size(); ++i) {
        left.place[i] = behind_.place[i] * of_place + behind_.rate[i] * blend_time_ * of_rate;
        left.rate[i] = behind_.place[i] / blend_time_ * rate_of_place + behind_.rate[i] * rate_of_rate;
    }
    return left;
}

/// From one motion to another, no faster than places and angles are taken up.
void ForeignShip::blend(const Motion& from, const Motion& to, double now, double least_time) {
    blend_from_ = now;
    blend_time_ = least_time;
    for (std::size_t i = 0; i < from.place.size(); ++i) {
        behind_.place[i] =
            is_angle(i) ? turn_between(to.place[i], from.place[i]) : from.place[i] - to.place[i];
        behind_.rate[i] = from.rate[i] - to.rate[i];
        blend_time_ =
            std::max(blend_time_, std::abs(behind_.place[i]) / (is_angle(i) ? kTakeUpTurn : kTakeUp));
    }
}

ForeignShip::Answer ForeignShip::hear(const ForeignSample& sample, double now, const ShipState& ship) {
    const bool first = has_ != Has::drives;
    if (!first && sample.time <= sent_) return Answer::out_of_order;
    const double interval = first ? 0 : sample.time - sent_;
    const double observed = now - sample.time;
    const double offset = first ? observed : std::min(offset_ + kClockDrift * interval, observed);

    const Motion is = motion_of(ship);
    ForeignShip next = *this;
    next.has_ = Has::drives;
    next.last_ = motion_of(sample);
    next.sent_ = sample.time;
    next.offset_ = offset;
    const Motion shall = next.carried_on(now);
    next.blend(is, shall, now, std::max(interval, kLeastBlend));
    const auto& off = next.behind_.place;
    if (std::hypot(off[kEast], off[kNorth]) > kNear || std::abs(off[kUp]) > kNearHeight ||
        std::max({std::abs(off[kHeading]), std::abs(off[kRoll]), std::abs(off[kPitch])}) > kNearAngle)
        return Answer::jumped;
    *this = next;
    return first ? Answer::took_over : Answer::taken;
}

ForeignShip::Drive ForeignShip::drive(double now) const {
    if (has_ != Has::drives) return Drive::none;
    const double age = now - (sent_ + offset_);
    return age < kLate ? Drive::fresh : age < kStill ? Drive::late : Drive::held;
}

void ForeignShip::place(double now, ShipState& ship) const {
    auto [place, rate] = carried_on(now);
    const Motion left = behind(now);
    for (std::size_t i = 0; i < place.size(); ++i) {
        place[i] += left.place[i];
        rate[i] += left.rate[i];
    }
    ship.x = place[kEast], ship.y = place[kNorth];
    ship.heading = std::remainder(place[kHeading], 2 * std::numbers::pi);
    const Vec3 velocity(rate[kEast], rate[kNorth], 0);
    ship.surge = velocity.dot(forward(ship)), ship.sway = velocity.dot(starboard(ship));
    ship.yaw_rate = rate[kHeading];
    ship.waves = {};
    ship.floats = {}; // what she reports is all of it
    ship.waves.heave = place[kUp], ship.waves.heave_speed = rate[kUp];
    ship.waves.roll = place[kRoll], ship.waves.roll_rate = rate[kRoll];
    ship.waves.pitch = place[kPitch], ship.waves.pitch_rate = rate[kPitch];
}

void ForeignShip::release(double now, const WaveMotion& sea, ShipState& ship) {
    if (has_ != Has::drives) return;
    has_ = Has::leaves;
    const Motion was = motion_of(ship);
    // What the sea does to her in the plane is no part of her place there.
    ship.x -= sea.surge * forward(ship).x() + sea.sway * starboard(ship).x();
    ship.y -= sea.surge * forward(ship).y() + sea.sway * starboard(ship).y();
    ship.surge -= sea.surge_speed, ship.sway -= sea.sway_speed;
    ship.waves = sea;
    blend(was, motion_of(ship), now, kFade);
}

void ForeignShip::fade(double now, WaveMotion& waves) {
    if (has_ != Has::leaves) return;
    if (now - blend_from_ >= blend_time_) has_ = Has::never;
    const auto [place, rate] = behind(now);
    waves.heave += place[kUp], waves.heave_speed += rate[kUp];
    waves.roll += place[kRoll], waves.roll_rate += rate[kRoll];
    waves.pitch += place[kPitch], waves.pitch_rate += rate[kPitch];
}

template <class Visitor, StateOf<ForeignShip> Self>
void visit_state(Visitor& v, Self& self) {
    constexpr double kBlendMax = 60; // s: more than the farthest sample that is taken asks for
    WINDLASS_STATE(v, self.has_, self.sent_, self.offset_, self.blend_from_, self.blend_time_);
    v.within({"blend_time_"}, self.blend_time_, kLeastBlend, kBlendMax);
    v.numbers({"last_.place"}, self.last_.place.data(), self.last_.place.size());
    v.numbers({"last_.rate"}, self.last_.rate.data(), self.last_.rate.size());
    v.numbers({"behind_.place"}, self.behind_.place.data(), self.behind_.place.size());
    v.numbers({"behind_.rate"}, self.behind_.rate.data(), self.behind_.rate.size());
    WINDLASS_WITHIN(v, -kLongest, kLongest, self.sent_, self.offset_, self.blend_from_);
    for (const auto* motion : {&self.last_, &self.behind_}) {
        v.all_within({"place"}, motion->place.data(), motion->place.size(), -kFarthest, kFarthest);
        v.all_within({"rate"}, motion->rate.data(), motion->rate.size(), -kFastest, kFastest);
    }
}
WINDLASS_STATE_LISTED(ForeignShip);

} // namespace windlass::physics
