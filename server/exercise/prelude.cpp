#include "server/exercise/prelude.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/exercise.hpp"
#include "server/exercise/moor.hpp"
#include "server/physics/windlass/band_brake.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::exercise {

namespace {

// All of this is handling, chosen so that the anchor digs in and the cable lies stretched.
constexpr double kMaxWind = 8;           ///< m/s, in which she comes to anchor
constexpr double kHung = 5;              ///< m of cable, the anchor at the waterline
constexpr double kSternway = -0.25;      ///< m/s, half a knot: letting go
constexpr double kFallsBack = -0.4;      ///< m/s: laying the cable out
constexpr double kTakesStrain = -0.2;    ///< m/s: letting the cable come to strain
constexpr double kFall = 3;              ///< m/s, of the cable until the anchor lies: no heap falls on it
constexpr double kPayOut = 1;            ///< m/s, of the cable after that
constexpr double kTest = 0.4;            ///< of full astern
constexpr double kStill = 60;            ///< s that the anchor stands the test
constexpr double kWindRises = 180;       ///< s
constexpr double kLies = 300;            ///< s after that
constexpr double kHoldsAgain = 600;      ///< s after that, at most
constexpr double kLookTime = 0.1;        ///< s between two looks
constexpr double kMinute = 60;           ///< s
constexpr double kAtMost = 30 * kMinute; ///< s of exercise, for each part of the work

/// A hand at brake, telegraph and thrusters, who sees everything.
class Hand {
public:
    Hand(Exercise& exercise, const ExerciseDef& def)
        : exercise_(exercise), def_(def), tackle_(*anchored_by(def)), levers_{.side = tackle_.side} {
        exercise_.view(seen_);
    }

    void let_go();
    void pay_out();
    void test_the_anchor();
    void lie();
    void secure();

private:
    const TackleView& cable() const {
        return *std::find_if(seen_.tackle.begin(), seen_.tackle.end(),
                             [&](const TackleView& t) { return t.side == tackle_.side; });
    }
    void go_on(double seconds);
    template <class Done>
    void until(const char* what, const Done& done);
    void brake(double position);
    void grip(double share);
    void hold(double speed);
    void helm(double surge, double max_astern);

    Exercise& exercise_;
    const ExerciseDef& def_;
    const GroundTackleDef& tackle_;
    WindlassOrder levers_;
    Snapshot seen_;
};

void Hand::go_on(double seconds) {
    const auto ticks = std::lround(seconds * def_.tick_rate_hz);
    for (long k = 0; k < ticks; ++k)
        if (!exercise_.step(1.0 / def_.tick_rate_hz))
            throw std::runtime_error("at_anchor: the state ceases to be finite in the prelude");
    exercise_.view(seen_);
}

/// Looks on until something is so. Throws when that takes too long.
template <class Done>
void Hand::until(const char* what, const Done& done) {
    for (const double end = seen_.time + kAtMost; !done(); go_on(kLookTime))
        if (seen_.time > end)
            throw std::runtime_error(
                "/tackle/" + std::to_string(&tackle_ - def_.tackle.data()) +
                "/at_anchor: " + std::to_string(tackle_.at_anchor) +
                " is not allowed: cable, ground and weather in which she can be brought up; "
                "half an hour went by before " +
                what);
}

void Hand::brake(double position) {
    levers_.brake = position;
    exercise_.apply(levers_);
}

/// The brake by the share of its rating that it grips with; 0: the lining just clear of the drum.
void Hand::grip(double share) {
    brake(physics::position_of_grip(tackle_.windlass, share));
}

/// The brake so that no more than this speed of the cable (m/s) comes of any pull.
void Hand::hold(double speed) {
    grip(std::clamp(0.2 + 0.3 * (cable().windlass.cable_speed - speed), 0.0, 1.0));
}

/// Engine for a speed (m/s ahead), thrusters for the heading that she began with.
void Hand::helm(double surge, double max_astern) {
    const double off = std::remainder(seen_.ship.heading - def_.ship_start.heading, 2 * std::numbers::pi);
    const double turn = std::clamp(-5 * off - 50 * seen_.ship.yaw_rate, -1.0, 1.0);
    const double engine = std::clamp(2 * (surge - seen_.ship.surge), -max_astern, 0.5);
    exercise_.apply(HelmOrder{.engine = engine, .bow_thruster = turn, .stern_thruster = -turn});
}

void Hand::let_go() {
    until("the anchor was on the bottom", [&] {
        hold(kFall);
        return cable().anchor.phase == AnchorPhase::on_bottom;
    });
}

void Hand::pay_out() {
    const double target = physics::metres_from_shackles(tackle_.at_anchor);
    const physics::Vec3 landed = cable().anchor.shackle;
    const double plumb = cable().hawse.z() - landed.z(); // down, and from there along the bottom: never taut
    until("the cable was out", [&] {
        const WindlassView& windlass = cable().windlass;
        const double want = std::min(target, plumb + (cable().hawse - landed).head<2>().norm());
        const double short_of = want - windlass.cable_out;
        if (short_of > 0)
            hold(kPayOut);
        else
            grip(0.8);
        helm(kFallsBack, 0.2);
        return windlass.cable_out > target - 0.5;
    });
    brake(1);
}

void Hand::test_the_anchor() {
    double still_since = seen_.time, dragged = 0, max = kTest, eased_at = seen_.time;
    until("the anchor stood the engine astern", [&] {
        if (cable().anchor.dragged > dragged + 0.1 || seen_.ship.surge < -0.03) {
            still_since = seen_.time;
            dragged = cable().anchor.dragged;
        }
        if (cable().anchor.phase == AnchorPhase::dragging && seen_.time > eased_at + kMinute) {
            eased_at = seen_.time;
            max /= 2;
        }
        helm(kTakesStrain, max);
        return seen_.time > still_since + kStill;
    });
    exercise_.apply(HelmOrder{});
}

void Hand::lie() {
    until("she was brought up", [&] { return exercise_.brought_up(tackle_.side); });
}

void Hand::secure() {
    levers_.stopper_closed = tackle_.stopper_closed;
    exercise_.apply(levers_);
    go_on(10);
    brake(tackle_.brake);
    Weather weather = seen_.environment.now;
    weather.wind_speed = def_.weather.wind_speed;
    exercise_.apply(EnvironmentOrder{weather, kWindRises});
    go_on(kWindRises + kLies);
    // An anchor that gave way while the wind rose is given time to hold again; in a storm it may not.
    for (double waited = 0; waited < kHoldsAgain && !exercise_.brought_up(tackle_.side); waited += kMinute)
        go_on(kMinute);
}

} // namespace

const GroundTackleDef* anchored_by(const ExerciseDef& def) {
    const auto found = std::find_if(def.tackle.begin(), def.tackle.end(),
                                    [](const GroundTackleDef& tackle) { return tackle.at_anchor > 0; });
    return found == def.tackle.end() ? nullptr : &*found;
}

ExerciseDef before_prelude(const ExerciseDef& def) {
    ExerciseDef before = def;
    if (anchored_by(def) == nullptr) return before;
    GroundTackleDef& tackle = before.tackle[static_cast<std::size_t>(anchored_by(def) - def.tackle.data())];
    tackle.cable_out = kHung, tackle.anchor_home = false;
    tackle.brake = 1, tackle.clutch_in = false, tackle.stopper_closed = false;
    Weather& weather = before.weather;
    weather.wind_speed = std::min(weather.wind_speed, kMaxWind);
    weather.gust_factor = 1;
    before.tide.clear();
    weather.veering = weather.wave_height = weather.swell_height = 0;
    if (moored(def)) {
        begin_moor(before);
    } else {
        before.ship_start.surge = kSternway;
        before.ship_start.sway = before.ship_start.yaw_rate = 0;
    }
    lay_weather(weather, before.environment);
    return before;
}

void play_prelude(Exercise& exercise, const ExerciseDef& def) {
    if (moored(def)) return play_moor(exercise, def);
    Hand hand(exercise, def);
    hand.let_go();
    hand.pay_out();
    hand.test_the_anchor();
    hand.lie();
    hand.secure();
}

ExerciseDef with_prelude_played(ExerciseDef def) {
    if (anchored_by(def) == nullptr || def.settled) return def;
    def.settled = std::make_shared<const std::vector<std::uint8_t>>(write_checkpoint(Exercise(def)));
    return def;
}

} // namespace windlass::exercise
