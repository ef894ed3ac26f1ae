#include "server/exercise/moor.hpp"

#include "server/exercise/exercise.hpp"
#include "server/physics/windlass/band_brake.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace windlass::exercise {

namespace {

using physics::Vec3;

// All of this is handling, chosen so that both anchors dig in and neither cable lies in a heap.
constexpr double kHung = 5;        ///< m of cable, the anchor at the waterline
constexpr double kSlack = 0.8;     ///< of the height from lip to bottom: cable over the way to the anchor
constexpr double kFall = 3;        ///< m/s, of the cable until the anchor lies
constexpr double kPayOut = 1;      ///< m/s, of the cable after that
constexpr double kLaysOut = 0.6;   ///< m/s, of the ship
constexpr double kPulls = 0.1;     ///< m/s, of the ship as she tries an anchor
constexpr double kTried = 3;       ///< of an anchor's weight, that it is to bear
constexpr double kNearly = 0.5;    ///< m of cable
constexpr double kTurns = 0.01;    ///< rad/s
constexpr double kRest = 20;       ///< s, between two pieces of work
constexpr double kLies = 600;      ///< s
constexpr double kLookTime = 0.1;  ///< s, between two looks
constexpr double kAtMost = 1800;   ///< s of exercise, for each part of the work
constexpr double kWindRises = 180; ///< s

Vec3 compass(double heading) {
    return {std::sin(heading), std::cos(heading), 0};
}

/// On which she moored.
double first_heading(const ExerciseDef& def) {
    return def.ship_start.heading - def.ship_start.turned;
}

/// m, over the ground from the lips, as she lies moored, to an anchor.
double way_to_anchor(const ExerciseDef& def, std::size_t tackle) {
    return physics::metres_from_shackles(def.tackle[tackle].at_anchor) -
           kSlack * (depth_at_bow(def) + def.ship.hawse_height);
}

/// m, plan: midway between her lips as she lies moored.
Vec3 berth(const ExerciseDef& def) {
    return Vec3(def.ship_start.x, def.ship_start.y, 0) +
           def.ship.hawse_forward * compass(def.ship_start.heading);
}

class Moor {
public:
    Moor(Exercise& exercise, const ExerciseDef& def)
        : exercise_(exercise),
          def_(def),
          dt_(1.0 / def.tick_rate_hz),
          heading_(first_heading(def)),
          bow_(berth(def) + way_to_anchor(def, 0) * compass(heading_)),
          line_(compass(heading_)) {
        for (std::size_t k : {0, 1})
            levers_[k].side = def.tackle[k].side;
        exercise_.view(seen_);
    }

    void lay_out();
    void middle();
    void try_anchors();
    void turn();
    void lie();

private:
    const TackleView& cable(std::size_t k) const {
        return *std::find_if(seen_.tackle.begin(), seen_.tackle.end(),
                             [&](const TackleView& t) { return t.side == def_.tackle[k].side; });
    }
    double out(std::size_t k) const { return cable(k).windlass.cable_out; }
    double wanted(std::size_t k) const { return physics::metres_from_shackles(def_.tackle[k].at_anchor); }
    /// m, of the bow ahead of its berth, along the line of the anchors.
    double ahead() const { return (bow_ - berth(def_)).dot(line_); }

    void go_on(double speed, double yaw_rate);
    void go_on_free(double seconds);
    template <class Done, class Work>
    void until(const char* what, const Done& done, const Work& work);
    void wait(double seconds);
    void brake(std::size_t k, double position);
    void hold(std::size_t k, double speed);
    void veer(std::size_t k, double most);
    void let_go(std::size_t k);

    Exercise& exercise_;
    const ExerciseDef& def_;
    double dt_;                       // s
    double heading_;                  // rad
    Vec3 bow_;                        // m, plan: midway between the lips
    Vec3 line_;                       // from the second anchor to the first
    double speed_ = 0, yaw_rate_ = 0; // m/s along the line, rad/s
    WindlassOrder levers_[2];
    Snapshot seen_;
};

/// A look's time on, the ship moved at so much along the line (m/s) and turned about her bow (rad/s
/// clockwise).
void Moor::go_on(double speed, double yaw_rate) {
    speed_ = speed, yaw_rate_ = yaw_rate;
    for (long k = std::lround(kLookTime / dt_); k > 0; --k) {
        bow_ += dt_ * speed * line_;
        heading_ += dt_ * yaw_rate;
        const Vec3 ahead = compass(heading_), port(-ahead.y(), ahead.x(), 0);
        Eigen::Matrix3d axes;
        axes << ahead, port, Vec3::UnitZ();
        const Vec3 spin(0, 0, -yaw_rate), to_midships = -def_.ship.hawse_forward * ahead;
        exercise_.apply(OwnShipSample{.position = bow_ + to_midships,
                                      .attitude = Eigen::Quaterniond(axes),
                                      .velocity = speed * line_ + spin.cross(to_midships),
                                      .angular_velocity = spin,
                                      .time = exercise_.time()});
        if (!exercise_.step(dt_))
            throw std::runtime_error("at_anchor: the state ceases to be finite in the prelude");
    }
    exercise_.view(seen_);
}

void Moor::go_on_free(double seconds) {
    for (long k = std::lround(seconds / dt_); k > 0; --k)
        if (!exercise_.step(dt_))
            throw std::runtime_error("at_anchor: the state ceases to be finite in the prelude");
    exercise_.view(seen_);
}

/// Works and looks on until something is so; work moves the ship. Throws when that takes too long.
template <class Done, class Work>
void Moor::until(const char* what, const Done& done, const Work& work) {
    for (const double end = seen_.time + kAtMost; !done(); work())
        if (seen_.time > end)
            throw std::runtime_error(
                "/tackle/0/at_anchor: " + std::to_string(def_.tackle[0].at_anchor) +
                " is not allowed: cables, ground and weather in which she can be moored; "
                "half an hour went by before " +
                what);
}

void Moor::wait(double seconds) {
    const double end = seen_.time + seconds;
    until(
        "she lay still", [&] { return seen_.time >= end; }, [&] { go_on(0, 0); });
}

void Moor::brake(std::size_t k, double position) {
    levers_[k].brake = position;
    exercise_.apply(levers_[k]);
}

/// The brake so that no more than this speed of the cable (m/s) comes of any pull.
void Moor::hold(std::size_t k, double speed) {
    const double grip = 0.2 + 0.3 * (speed > 0 ? cable(k).windlass.cable_speed - speed : 2);
    brake(k, physics::position_of_grip(def_.tackle[k].windlass, std::clamp(grip, 0.0, 1.0)));
}

/// Cable as the ship goes away from its anchor, never taut: down, and from there along the bottom. most: m.
void Moor::veer(std::size_t k, double most) {
    const Vec3 way = cable(k).hawse - cable(k).anchor.shackle;
    hold(k, out(k) < std::min(most, way.z() + way.head<2>().norm()) ? kPayOut : 0);
}

void Moor::let_go(std::size_t k) {
    until(
        "the anchor was on the bottom", [&] { return cable(k).anchor.phase == AnchorPhase::on_bottom; },
        [&] {
            hold(k, kFall);
            go_on(0, 0);
        });
    brake(k, 1);
    wait(kRest);
}

/// Lets the first anchor go, drops back over both lengths, and lets the second go.
void Moor::lay_out() {
    let_go(0);
    until(
        "the second anchor's place", [&] { return ahead() <= -way_to_anchor(def_, 1); },
        [&] {
            veer(0, wanted(0) + wanted(1));
            go_on(-kLaysOut, 0);
        });
    brake(0, 1);
    wait(kRest);
    let_go(1);
}

/// Heaves the first in and veers the second, until she lies between them.
void Moor::middle() {
    levers_[0].clutch_in = true;
    exercise_.apply(levers_[0]);
    wait(kRest);
    brake(0, 0);
    const double from = ahead(), hove = out(0);
    until(
        "she was middled", [&] { return out(0) <= wanted(0); },
        [&] {
            levers_[0].speed_lever = 1;
            exercise_.apply(levers_[0]);
            veer(1, wanted(1));
            // Ahead as the cable comes in.
            const double share = (hove - out(0)) / (hove - wanted(0));
            go_on(std::clamp(from * (1 - share) - ahead(), 0.0, kLaysOut), 0);
        });
    levers_[0].speed_lever = 0;
    brake(0, 1);
    until(
        "the second cable was out", [&] { return out(1) >= wanted(1) - kNearly; },
        [&] {
            veer(1, wanted(1));
            go_on(kPulls, 0);
        });
    brake(1, 1);
    wait(kRest);
    levers_[0].clutch_in = false;
    exercise_.apply(levers_[0]);
    wait(kRest);
}

/// Pulls at each until it bears, and comes back.
void Moor::try_anchors() {
    for (std::size_t k : {0, 1}) {
        const double away = k == 0 ? -1 : 1, enough = kTried * def_.tackle[k].anchor.mass * physics::kGravity;
        until(
            "an anchor held", [&] { return cable(k).windlass.hawse_tension > enough; },
            [&] { go_on(away * kPulls, 0); });
        wait(kRest);
        until(
            "she lay in her berth again", [&] { return away * ahead() <= 0; },
            [&] { go_on(-away * kPulls, 0); });
    }
}

void Moor::turn() {
    const double left = def_.ship_start.turned;
    const double to = first_heading(def_) + left, way = left < 0 ? -1 : 1;
    until(
        "she had turned", [&] { return way * (to - heading_) <= 0; }, [&] { go_on(0, way * kTurns); });
    wait(kRest);
}

/// Herself again, as the exercise finds her.
void Moor::lie() {
    go_on_free(1); // nobody moves her any more: who touches the helm has her
    exercise_.apply(HelmOrder{.rudder = 0.01});
    exercise_.apply(HelmOrder{});
    for (std::size_t k : {0, 1}) {
        levers_[k].stopper_closed = def_.tackle[k].stopper_closed;
        exercise_.apply(levers_[k]);
    }
    go_on_free(10);
    for (std::size_t k : {0, 1})
        brake(k, def_.tackle[k].brake);
    Weather weather = seen_.environment.now;
    weather.wind_speed = def_.weather.wind_speed;
    exercise_.apply(EnvironmentOrder{weather, kWindRises});
    go_on_free(kWindRises + kLies);
}

} // namespace

bool moored(const ExerciseDef& def) {
    return std::count_if(def.tackle.begin(), def.tackle.end(),
                         [](const GroundTackleDef& tackle) { return tackle.at_anchor > 0; }) == 2;
}

void begin_moor(ExerciseDef& def) {
    const double heading = first_heading(def);
    const Vec3 at = berth(def) + (way_to_anchor(def, 0) - def.ship.hawse_forward) * compass(heading);
    for (GroundTackleDef& tackle : def.tackle) {
        tackle.cable_out = kHung, tackle.anchor_home = false;
        tackle.brake = 1, tackle.clutch_in = false, tackle.stopper_closed = false;
    }
    def.ship_start = {.x = at.x(), .y = at.y(), .heading = heading};
}

void play_moor(Exercise& exercise, const ExerciseDef& def) {
    Moor moor(exercise, def);
    moor.lay_out();
    moor.middle();
    moor.try_anchors();
    moor.turn();
    moor.lie();
}

} // namespace windlass::exercise
