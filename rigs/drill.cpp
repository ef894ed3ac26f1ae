#include "rigs/drill.hpp"

#include "server/config/config.hpp"
#include "server/physics/windlass/band_brake.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::rigs {

exercise::ExerciseDef let_go_def() {
    return config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/let_go_port_25m.json");
}

exercise::ExerciseDef quiet_def(double depth, double cable_out) {
    exercise::ExerciseDef def;
    def.environment.depth = depth;
    def.weather.wind_speed = 0;
    def.weather.current_speed = 0;
    def.tackle[0].cable_out = cable_out;
    return def;
}

exercise::ExerciseDef anchor_home_def(double depth, double heading) {
    exercise::ExerciseDef def = quiet_def(depth, 5);
    def.ship_start.heading = heading;
    def.tackle[0].anchor_home = true;
    return def;
}

Drill::Drill(const exercise::ExerciseDef& def) : exercise_(def) {
    const exercise::GroundTackleDef& tackle = exercise_.def().tackle[0];
    levers_.side = tackle.side;
    levers_.brake = tackle.brake;
    levers_.clutch_in = tackle.clutch_in;
    levers_.stopper_closed = tackle.stopper_closed;
    exercise_.view(snapshot_);
}

void Drill::give(const exercise::Order& command) {
    orders_.push_back({exercise_.tick(), windlass().cable_speed, chain().cable_out, command});
    exercise_.apply(command);
}

void Drill::brake(double position) {
    levers_.brake = position;
    give(levers_);
}

void Drill::grip(double share) {
    brake(physics::position_of_grip(exercise_.def().tackle[0].windlass, share));
}

void Drill::speed_lever(double position) {
    levers_.speed_lever = position;
    give(levers_);
}

void Drill::clutch(bool in) {
    levers_.clutch_in = in;
    give(levers_);
}

void Drill::stopper(bool closed) {
    levers_.stopper_closed = closed;
    give(levers_);
}

void Drill::emergency_stop(bool pressed) {
    levers_.emergency_stop = pressed;
    give(levers_);
}

void Drill::engine(double order) {
    give(exercise::HelmOrder{.engine = order});
}

void Drill::helm(double engine, double bow_thruster, double stern_thruster) {
    give(exercise::HelmOrder{
        .engine = engine, .bow_thruster = bow_thruster, .stern_thruster = stern_thruster});
}

void Drill::wind(double speed) {
    exercise::Weather weather = snapshot_.environment.now;
    weather.wind_speed = speed;
    give(exercise::EnvironmentOrder{weather});
}

void Drill::wind_shifts(double from) {
    exercise::Weather weather = snapshot_.environment.now;
    weather.wind_from = from;
    give(exercise::EnvironmentOrder{weather});
}

void Drill::current(double speed, double towards) {
    exercise::Weather weather = snapshot_.environment.now;
    weather.current_speed = speed, weather.current_towards = towards;
    give(exercise::EnvironmentOrder{weather});
}

void Drill::fault(exercise::FaultCode code, double severity, exercise::FaultTrigger trigger, double value) {
    give(exercise::FaultOrder{.code = code,
                              .side = levers_.side,
                              .severity = severity,
                              .trigger = trigger,
                              .trigger_value = value});
}

void Drill::clear(exercise::FaultCode code) {
    give(exercise::FaultOrder{.code = code, .side = levers_.side, .clear = true});
}

bool Drill::tick() {
    const bool good = exercise_.step(1.0 / exercise_.def().tick_rate_hz);
    exercise_.view(snapshot_);
    log_.insert(log_.end(), snapshot_.events.begin(), snapshot_.events.end());
    largest_tension_ = std::max(largest_tension_, windlass().hawse_tension);
    fastest_payout_ = std::max(fastest_payout_, windlass().cable_speed);
    return good;
}

void Drill::run(double seconds) {
    const auto ticks = std::lround(seconds * exercise_.def().tick_rate_hz);
    for (long k = 0; k < ticks; ++k)
        tick();
}

bool Drill::run_until(const std::function<bool()>& done, double seconds) {
    const auto ticks = std::lround(seconds * exercise_.def().tick_rate_hz);
    for (long k = 0; k < ticks && !done(); ++k)
        tick();
    return done();
}

bool Drill::run_until_event(const std::string& code, double seconds) {
    std::size_t seen = log_.size();
    bool called = false;
    return run_until(
        [&] {
            const auto from = log_.begin() + static_cast<long>(seen);
            seen = log_.size();
            called = called || std::any_of(from, log_.end(), [&](const exercise::ExerciseEvent& event) {
                         return event.code == code;
                     });
            return called;
        },
        seconds);
}

int Drill::count(const std::string& code) const {
    return static_cast<int>(std::count_if(
        log_.begin(), log_.end(), [&](const exercise::ExerciseEvent& event) { return event.code == code; }));
}

std::optional<exercise::ExerciseEvent> Drill::first(const std::string& code) const {
    const auto found = std::find_if(log_.begin(), log_.end(),
                                    [&](const exercise::ExerciseEvent& event) { return event.code == code; });
    return found == log_.end() ? std::nullopt : std::optional(*found);
}

std::vector<std::string> Drill::story() const {
    std::vector<std::string> codes;
    for (const exercise::ExerciseEvent& event : log_) {
        if (std::find(codes.begin(), codes.end(), event.code) == codes.end()) codes.push_back(event.code);
    }
    return codes;
}

bool let_go_and_pay_out(Drill& drill, int shackles) {
    constexpr double kWait = 600;                      // s
    constexpr double kEaseOff = 1.5;                   // m/s
    const double growing = 60e3 * drill.anchor_size(); // N, of cable that grows
    const auto out = [&](double target) { return [&, target] { return drill.shackles() >= target; }; };
    const auto slower = [&](double speed) {
        return [&, speed] { return std::abs(drill.windlass().cable_speed) < speed; };
    };

    drill.run(5);
    drill.grip(0);
    if (!drill.run_until_event("anchor.on_bottom", kWait)) return false;
    drill.grip(0.4);
    drill.run(2);
    if (!drill.run_until(slower(0.1), kWait)) return false;
    for (int shackle = 2; shackle <= shackles; ++shackle) {
        // A ship that lies to what is out already, so that it grows no more, is given the rest all the same.
        if (shackle > 2) drill.run_until([&] { return drill.windlass().gypsy_load > growing; }, kWait);
        drill.grip(0);
        for (const double check :
             {0.75, 0.4}) { // shackles before the mark at which she is checked on the run
            if (drill.shackles() >= shackle - check) continue;
            if (!drill.run_until(out(shackle - check), kWait)) return false;
            drill.grip(0.1);
            if (!drill.run_until(slower(kEaseOff), kWait)) return false;
            drill.grip(0);
        }
        const bool last = shackle == shackles;
        if (!drill.run_until(out(shackle - (last ? 0.06 : 0.12)), kWait)) return false;
        drill.grip(last ? 1 : 0.4);
        drill.run(3);
        if (!drill.run_until(slower(0.02), kWait)) return false;
    }
    return true;
}

exercise::ExerciseDef steady_breeze_def() {
    exercise::ExerciseDef def = let_go_def();
    def.weather.wind_speed = 12;
    return def;
}

bool bring_home(Drill& drill) {
    constexpr double kJammed = 5e5; // N at the gypsy: five times the anchor's weight
    for (int tries = 0; tries < 4; ++tries) {
        drill.speed_lever(1);
        drill.run_until(
            [&] {
                return drill.anchor().phase == exercise::AnchorPhase::housed ||
                       drill.windlass().gypsy_load > kJammed;
            },
            120);
        if (drill.anchor().phase == exercise::AnchorPhase::housed) return true;
        drill.speed_lever(-1);
        const double in_water = drill.exercise().def().ship.hawse_height + 4;
        if (!drill.run_until([&] { return drill.chain().cable_out > in_water; }, 120)) return false;
        drill.speed_lever(0);
        drill.engine(0.5);
        drill.run(60);
        drill.engine(0);
    }
    return false;
}

bool lie_quietly(Drill& drill) {
    if (!let_go_and_pay_out(drill, 5)) return false;
    drill.run_until([&] { return drill.windlass().gypsy_load > 75e3; }, 300);
    drill.engine(0.5);
    drill.run_until([&] { return drill.now().ship.surge > -0.1; }, 400);
    drill.engine(0);
    const auto lies = [&] {
        return drill.now().model_level == physics::ModelLevel::catenary &&
               drill.count("anchor.brought_up") > 0;
    };
    return drill.run_until(lies, 900);
}

} // namespace windlass::rigs
