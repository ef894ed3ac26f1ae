// The ship moved by another simulator over a bad line, beside the same ship moved by the server's own model.

#include "rigs/drill.hpp"
#include "server/exercise/weather/weather.hpp"
#include "server/physics/ship/ship_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

namespace windlass::exercise {
using namespace rigs;

namespace {

using physics::ForeignSample;
using physics::ForeignShip;
using physics::ShipState;
using physics::Vec3;

/// A foreign bridge simulator: the server's own ship model outside the server, which hears CableForce 60
/// times a second and sends where she is 20 times a second, each sample 5 to 50 ms on its way, and every
/// twentieth lost.
class ForeignBridge {
public:
    ForeignBridge(const ExerciseDef& def, const ShipState& ship, double wind)
        : def_(def), dynamics_(def.ship), ship_(ship) {
        Weather weather = def.weather;
        weather.wind_speed = wind;
        lay_weather(weather, def_.environment);
    }

    void tick(Drill& drill, double dt) {
        if (ticks_ % 5 == 0) {
            pull_.force = drill.now().cable_force;
            pull_.moment = -drill.now().cable_moment.z(); // clockwise
        }
        dynamics_.step(def_.environment, {}, {}, pull_, dt, ship_);
        ++ticks_;
        const double t = ticks_ * dt;
        if (ticks_ % 15 == 0) {
            const int n = ticks_ / 15;
            const double delay = 0.005 + 0.045 * ((n * 7919) % 97) / 96;
            const ForeignSample sample{midships(ship_), attitude(ship_), ship_velocity(ship_), spin(ship_),
                                       1000 + t};
            if (n % 20 != 19) under_way_.push_back({t + delay, sample});
        }
        std::erase_if(under_way_, [&](const auto& each) {
            if (each.first > t) return false;
            drill.give(OwnShipSample(each.second));
            return true;
        });
    }

private:
    ExerciseDef def_;
    physics::ShipDynamics dynamics_;
    ShipState ship_;
    physics::CablePull pull_;
    int ticks_ = 0;
    std::vector<std::pair<double, ForeignSample>> under_way_;
};

ShipState state_of(const ShipView& view) {
    ShipState ship;
    ship.x = view.position.x(), ship.y = view.position.y(), ship.heading = view.heading;
    ship.surge = view.velocity.dot(forward(ship)), ship.sway = view.velocity.dot(starboard(ship));
    ship.yaw_rate = view.yaw_rate;
    return ship;
}

double rms(const std::vector<double>& values, std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i)
        sum += values[i] * values[i];
    return std::sqrt(sum / static_cast<double>(to - from));
}

/// On 6 shackles, two minutes after they were out; then the wind (m/s) changes. False: she did not get them
/// out.
bool comes_to_anchor(Drill& drill, double wind) {
    if (!let_go_and_pay_out(drill, 6)) return false;
    drill.run(120);
    drill.wind(wind);
    return true;
}

class ForeignShipAtAnchor : public testing::TestWithParam<double> {};

// Three per cent of the mean load, as the line's delay and jitter of 50 ms are worth some 1 % of a taut
// cable's critical damping; and what there is of a difference must not grow.
TEST_P(ForeignShipAtAnchor, PullsTheCableAsTheSameShipInside) {
    const double wind = GetParam();
    Drill inside(let_go_def()), outside(let_go_def());
    for (Drill* drill : {&inside, &outside})
        ASSERT_TRUE(comes_to_anchor(*drill, wind));
    ASSERT_EQ(inside.now().state_hash, outside.now().state_hash);
    ForeignBridge bridge(let_go_def(), state_of(outside.now().ship), wind);
    std::vector<double> off;
    double mean = 0;
    const int seconds = 300, rate = 300;
    for (int tick = 0; tick < seconds * rate; ++tick) {
        bridge.tick(outside, 1.0 / rate);
        ASSERT_TRUE(inside.tick() && outside.tick());
        mean += inside.windlass().hawse_tension / (seconds * rate);
        off.push_back(outside.windlass().hawse_tension - inside.windlass().hawse_tension);
    }
    EXPECT_EQ(outside.count("own_ship.foreign"), 1);
    EXPECT_EQ(outside.count("own_ship.late") + outside.count("own_ship.jumped"), 0);
    const std::size_t quarter = off.size() / 4;
    EXPECT_LT(rms(off, 0, off.size()), 0.03 * mean) << mean;
    EXPECT_LT(rms(off, 3 * quarter, off.size()), 0.03 * mean) << mean;
    RecordProperty("mean_kN", static_cast<int>(mean / 1e3));
    RecordProperty("rms_N", static_cast<int>(rms(off, 0, off.size())));
}
INSTANTIATE_TEST_SUITE_P(SlackAndTaut, ForeignShipAtAnchor, testing::Values(3.0, 20.0));

/// Of a load over a quarter of an hour.
struct Quarter {
    double mean = 0;  ///< N
    double swing = 0; ///< N, root mean square, about the mean of the last half minute: what a coupling that
                      ///< gives energy makes grow, and a ship's slow yaw does not
};

class LoadByQuarter {
public:
    static constexpr int kTicks = 900 * 300;

    void look(double load) {
        constexpr double kShort = 30 * 300; // ticks
        short_mean_ += (load - short_mean_) / std::min(kShort, static_cast<double>(++looks_));
        sum_ += load;
        squares_ += (load - short_mean_) * (load - short_mean_);
    }
    Quarter over() {
        const Quarter found{sum_ / kTicks, std::sqrt(squares_ / kTicks)};
        sum_ = squares_ = 0;
        return found;
    }

private:
    double short_mean_ = 0, sum_ = 0, squares_ = 0;
    int looks_ = 0;
};

class ForeignShipForAnHour : public testing::TestWithParam<double> {};

// The same for an hour. 3 % of the mean load, as above, in every quarter of it, and swings that are the
// ship's own to 5 %: an oscillation that grew by 0.1 % a second would be 30 times as large at the end.

TEST_P(ForeignShipForAnHour, PullsAsTheSameShipInsideAndNoOscillationGrows) {
    const double wind = GetParam();
    Drill inside(let_go_def()), outside(let_go_def());
    for (Drill* drill : {&inside, &outside})
        ASSERT_TRUE(comes_to_anchor(*drill, wind));
    ForeignBridge bridge(let_go_def(), state_of(outside.now().ship), wind);
    LoadByQuarter within, without;
    for (int quarter = 0; quarter < 4; ++quarter) {
        double squares = 0;
        for (int tick = 0; tick < LoadByQuarter::kTicks; ++tick) {
            bridge.tick(outside, 1.0 / 300);
            ASSERT_TRUE(inside.tick() && outside.tick());
            within.look(inside.windlass().hawse_tension);
            without.look(outside.windlass().hawse_tension);
            const double off = outside.windlass().hawse_tension - inside.windlass().hawse_tension;
            squares += off * off / LoadByQuarter::kTicks;
        }
        const Quarter own = within.over(), foreign = without.over();
        EXPECT_LT(std::sqrt(squares), 0.03 * own.mean) << quarter;
        EXPECT_NEAR(foreign.mean, own.mean, 0.03 * own.mean) << quarter;
        EXPECT_NEAR(foreign.swing, own.swing, 0.05 * own.swing) << quarter;
    }
    EXPECT_EQ(outside.count("own_ship.late") + outside.count("own_ship.jumped"), 0);
}
INSTANTIATE_TEST_SUITE_P(SlackAndTaut, ForeignShipForAnHour, testing::Values(3.0, 20.0));

TEST(ForeignShip, IsFollowedHeldWhenSilentAndHandedBackByTheHelm) {
    Drill drill(let_go_def());
    drill.run(1);
    ShipState ship = state_of(drill.now().ship);
    const auto say = [&](double time) {
        drill.give(OwnShipSample{midships(ship), attitude(ship), ship_velocity(ship), spin(ship), time});
    };
    ship.surge = ship.sway = ship.yaw_rate = 0; // she has stopped, says the other model
    for (int i = 0; i < 100; ++i, drill.run(0.05))
        say(i * 0.05);
    EXPECT_EQ(drill.count("own_ship.foreign"), 1);
    EXPECT_NEAR(drill.now().ship.velocity.norm(), 0, 1e-3);
    drill.run(5);
    EXPECT_EQ(drill.count("own_ship.late"), 1);
    EXPECT_EQ(drill.count("own_ship.lost"), 1);
    drill.engine(0); // as it is: nobody moved it
    drill.run(1);
    EXPECT_EQ(drill.count("own_ship.handed_back"), 0);
    drill.engine(-0.5);
    drill.run(30);
    EXPECT_EQ(drill.count("own_ship.handed_back"), 1);
    EXPECT_GT(drill.now().ship.velocity.norm(), 0.02) << "her own engine moves her again";
}

} // namespace
} // namespace windlass::exercise
