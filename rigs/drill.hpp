#pragma once
// A drill: one exercise worked by hand from a test, without topics or clocks. Keeps the log and the extremes.

#include "server/exercise/exercise.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace windlass::rigs {

/// Let go the port anchor in 25 m, as config/exercises/let_go_port_25m.json has it.
exercise::ExerciseDef let_go_def();

/// A still ship in still water, cable up and down: the machine alone. cable_out: m, from lip to anchor
/// shackle.
exercise::ExerciseDef quiet_def(double depth, double cable_out);

/// The same with the anchor home in its hawse pipe, and the ship heading as given (rad).
exercise::ExerciseDef anchor_home_def(double depth, double heading);

/// An order and when it was given: after which tick, and, if the cable was running, at what mark.
struct GivenOrder {
    std::uint64_t tick = 0;
    double cable_speed = 0; ///< m/s
    double cable_out = 0;   ///< m
    exercise::Order command;
};

/// One exercise and the hands on its levers.
class Drill {
public:
    explicit Drill(const exercise::ExerciseDef& def);

    /// Moves the port levers; they stay until moved again.
    void brake(double position);
    /// The brake by the share (0..1) of its rating that it then grips with; 0: the lining just clear of the
    /// drum.
    void grip(double share);
    void speed_lever(double position);
    void clutch(bool in);
    void stopper(bool closed);
    void emergency_stop(bool pressed);

    void engine(double order);
    void helm(double engine, double bow_thruster, double stern_thruster);
    /// From where it blew; m/s. The current stays.
    void wind(double speed);
    /// Where it blows from, rad clockwise from north.
    void wind_shifts(double from);
    /// m/s, and rad clockwise from north.
    void current(double speed, double towards);
    void fault(exercise::FaultCode code, double severity = 1,
               exercise::FaultTrigger trigger = exercise::FaultTrigger::now, double value = 0);
    void clear(exercise::FaultCode code);
    /// Any order at all.
    void give(const exercise::Order& command);

    /// Every order so far, to be given again in another run.
    const std::vector<GivenOrder>& orders() const { return orders_; }

    /// One tick. Returns what Exercise::step returned.
    bool tick();
    /// Seconds of exercise time.
    void run(double seconds);
    /// Until the condition holds; false when it did not within the given seconds.
    bool run_until(const std::function<bool()>& done, double seconds);
    /// Until an event of this code is called; false when it was not within the given seconds.
    bool run_until_event(const std::string& code, double seconds);

    const exercise::Snapshot& now() const { return snapshot_; }
    const exercise::WindlassView& windlass() const { return snapshot_.tackle[0].windlass; }
    const exercise::ChainView& chain() const { return snapshot_.tackle[0].chain; }
    const exercise::AnchorView& anchor() const { return snapshot_.tackle[0].anchor; }
    /// Mass of the port anchor over that of let_go_def(): loads go with it.
    double anchor_size() const { return exercise_.def().tackle[0].anchor.mass / 9900; }
    double shackles() const { return physics::shackles_from_metres(chain().cable_out); }
    const exercise::Exercise& exercise() const { return exercise_; }
    /// To take it on by hand, beside a branch of it: the drill hears nothing of that.
    exercise::Exercise& exercise() { return exercise_; }

    /// Events since the start.
    const std::vector<exercise::ExerciseEvent>& log() const { return log_; }
    int count(const std::string& code) const;
    /// First event of a code, if any.
    std::optional<exercise::ExerciseEvent> first(const std::string& code) const;
    /// Codes in the order in which they were first called.
    std::vector<std::string> story() const;

    double largest_tension() const { return largest_tension_; } ///< N, at the hawse pipe, since the start
    double fastest_payout() const { return fastest_payout_; }   ///< m/s, since the start

private:
    exercise::Exercise exercise_;
    exercise::WindlassOrder levers_;
    exercise::Snapshot snapshot_;
    std::vector<GivenOrder> orders_;
    std::vector<exercise::ExerciseEvent> log_;
    double largest_tension_ = 0, fastest_payout_ = 0;
};

/// Lets go and pays out to the given shackles as config/scripts/let_go_port_25m.json does: a shackle at a
/// time as the cable grows, checked on the brake. False when a part took longer than ten minutes.
bool let_go_and_pay_out(Drill& drill, int shackles);

/// Heaves the anchor home with the motor, clutch in. Should its flukes come up inboard, walks it back into
/// the water, gives her a little way to turn it and heaves again, three times at most. False when it is not
/// home.
bool bring_home(Drill& drill);

/// Lets go, is brought up to five shackles in a fresh breeze and lies until the model leaves her cable to the
/// catenary. The drill must be of steady_breeze_def(). False when it took longer than fifteen minutes.
bool lie_quietly(Drill& drill);
exercise::ExerciseDef steady_breeze_def();

} // namespace windlass::rigs
