#include "bench/acceptance/balance.hpp"

#include "rigs/tackle_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lab {

using namespace rigs;
using namespace physics;

namespace {

/// A run whose books are kept from its first step.
class Books {
public:
    Books(const TackleSetup& setup, double depth) : rig(setup, quiet_water(depth)) {
        rig.tackle.keep_ledger();
        before_ = rig.tackle.energy(rig.environment);
    }

    /// Steps until the condition holds. Throws std::runtime_error when it does not in so many seconds.
    template <class Condition>
    void until(const char* what, const Condition& condition, double seconds) {
        if (!watch(condition, seconds))
            throw std::runtime_error(fmt::format("not within {} s: {}", seconds, what));
    }
    void wait(double seconds) {
        watch([] { return false; }, seconds);
    }

    Balance close(std::string run) const {
        const BandBrakeState& brake = rig.windlass().brake;
        const BrakeHeatCapacity capacity = brake_heat_capacity(rig.setup.windlass);
        Balance balance;
        balance.run = std::move(run);
        balance.given_up = before_ - rig.tackle.energy(rig.environment);
        for (const LedgerEntry& entry : entries(rig.tackle.ledger()))
            balance.sinks.push_back({entry.name, entry.joules});
        balance.brake = {{"in the drum's skin", capacity.skin * (brake.skin - kAirTemperature)},
                         {"in the steel next to it", capacity.shell * (brake.shell - kAirTemperature)},
                         {"in the rest of the drum", capacity.drum * (brake.drum - kAirTemperature)},
                         {"given to the air", brake.cooled},
                         {"boiled off", brake.dried}};
        balance.brake_heat = rig.tackle.ledger().brake;
        balance.lining = lining_, balance.drum = drum_;
        return balance;
    }

    TackleRig rig;

private:
    template <class Condition>
    bool watch(const Condition& condition, double seconds) {
        return rig.run_until(
            [&] {
                const BandBrakeState& brake = rig.windlass().brake;
                lining_ = std::max(lining_, brake.skin), drum_ = std::max(drum_, brake.drum);
                return condition();
            },
            seconds);
    }

    double before_ = 0, lining_ = 0, drum_ = 0;
};

TackleSetup set_up(const Machine& machine, double cable_out, bool clutch_in) {
    TackleSetup setup = machine.setup;
    setup.cable_out = cable_out;
    setup.clutch_in = clutch_in;
    return setup;
}

} // namespace

double Balance::turned_over() const {
    double in = std::max(0.0, given_up), out = std::max(0.0, -given_up);
    for (const Entry& sink : sinks)
        (sink.joules > 0 ? out : in) += std::abs(sink.joules);
    return std::max(in, out);
}

double Balance::open() const {
    double sum = -given_up;
    for (const Entry& sink : sinks)
        sum += sink.joules;
    return sum / turned_over();
}

Balance let_go(const Machine& machine) {
    Books books(set_up(machine, 5, false), 25);
    TackleRig& rig = books.rig;
    rig.lip_velocity = {-0.5, 0, 0};
    rig.levers.brake = 0;
    books.until(
        "two shackles out", [&] { return rig.windlass().cable_out > 55; }, 60);
    rig.levers.brake = 1;
    books.wait(30);
    return books.close("let go in 25 m, stopped at 55 m");
}

Balance walk_back(const Machine& machine) {
    Books books(set_up(machine, 5, true), 60);
    TackleRig& rig = books.rig;
    rig.lip_velocity = {-0.12, 0, 0}; // 0.25 knots
    rig.levers.brake = 0;
    rig.levers.speed = -0.4;
    books.until(
        "walked back", [&] { return rig.windlass().cable_out > 90; }, 1200);
    rig.levers.speed = 0;
    rig.levers.brake = 1;
    books.wait(30);
    return books.close("walked back in 60 m to 90 m");
}

Balance weigh(const Machine& machine) {
    Books books(set_up(machine, 5, false), 25);
    TackleRig& rig = books.rig;
    rig.lip_velocity = {-0.5, 0, 0};
    // A hand at the brake holds the fall, so that no cable comes down in a heap on the anchor, and then lays
    // it out as the hull moves.
    constexpr double kFall = 3; // m/s
    const auto landed = [&] {
        rig.grip(std::clamp(0.2 + 0.3 * (rig.windlass().cable_speed - kFall), 0.0, 1.0));
        return rig.tackle.anchor().holding().landed;
    };
    books.until("anchor on the bottom", landed, 60);
    double grip = 0;
    const auto laid = [&] {
        const double faster = rig.windlass().cable_speed + rig.lip_velocity.x(); // m/s than the hull
        grip = std::clamp(grip + 1e-3 * faster, 0.0, 1.0);
        rig.grip(grip);
        return rig.windlass().cable_out > 110;
    };
    books.until("cable laid out", laid, 300);
    rig.levers.brake = 1;
    books.until(
        "anchor dug in", [&] { return rig.tackle.anchor().holding().embedment > 0.5; }, 600);
    rig.lip_velocity = Vec3::Zero();
    rig.levers.clutch_in = true;
    books.until(
        "clutch in", [&] { return rig.windlass().clutch.position == Clutch::in; }, 60);
    rig.levers.brake = 0;
    rig.levers.speed = 0.5;
    rig.lip_velocity = {0.1, 0, 0}; // eased with the engine, until the cable is up and down
    books.until(
        "up and down", [&] { return rig.tackle.cable_direction().x() < 0.2; }, 900);
    rig.lip_velocity = Vec3::Zero();
    const double home = home_length(rig.setup.chain);
    books.until(
        "anchor home", [&] { return rig.windlass().cable_out < home + 1e-3; }, 900);
    rig.levers.speed = 0;
    rig.levers.brake = 1;
    books.wait(30);
    return books.close("let go in 25 m, dug in, weighed, home");
}

Balance run_out(const Machine& machine) {
    const double length = machine.setup.chain.length;
    Books books(set_up(machine, length - 60, false), length + 20);
    books.rig.levers.brake = 0;
    books.until(
        "cable gone", [&] { return books.rig.windlass().chain_gone; }, 60);
    books.wait(3);
    return books.close("run out, bitter end and all");
}

} // namespace windlass::lab
