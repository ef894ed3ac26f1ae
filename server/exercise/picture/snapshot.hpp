#pragma once
// The exercise as seen from outside after a tick: plain values, copied once, published by dds/.
// Names, units, frames and signs are those of idl/windlass.idl, where every field is explained. Each struct
// has its list behind it, which the check for NaN, the copy onto the wire and the dump of a fault go through.

#include "server/exercise/definition/orders.hpp"
#include "server/physics/solver/step_counts.hpp"
#include "words/rows.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace windlass::physics {

WINDLASS_FIELDS(ModelError, load, shape)
WINDLASS_FIELDS(StepCounts, steps, implicit, unsolved, friction, contacts, dropped, capped)
WINDLASS_FIELDS(WaveComponent, k_x, k_y, omega, phase, amplitude_before, amplitude_after)

} // namespace windlass::physics

namespace windlass::exercise {

enum class RunState { ready, running, paused, finished, stopped_by_fault, replay };
enum class AnchorPhase {
    housed,
    acockbill,
    hanging,
    on_bottom,
    digging_in,
    holding,
    dragging,
    aweigh,
    fouled,
    lost
};
constexpr AnchorPhase last_of(AnchorPhase) {
    return AnchorPhase::lost;
}
enum class Stay { up_and_down, short_stay, medium_stay, long_stay };
enum class ClutchState { out, engaging, in };
using words::Severity;
enum class FaultPhase { armed, active, cleared };
constexpr FaultPhase last_of(FaultPhase) {
    return FaultPhase::cleared;
}
using physics::ModelLevel;
using physics::Soil;

struct EnvironmentView {
    double depth = 0; ///< m, at the bow
    Weather now, after;
    double ramp_left = 0; ///< s
    double gust = 0;      ///< m/s, of the wind at this instant over its mean
    double swing = 0;     ///< rad, of where it blows from, clockwise
};
WINDLASS_FIELDS(EnvironmentView, depth, now, after, ramp_left, gust, swing)

/// The surface, as physics/sea/waves.hpp has it.
struct SeaView {
    double ramp_begin = 0, ramp_end = 0;       ///< s; it holds from ramp_begin on
    std::vector<physics::WaveComponent> waves; ///< none: flat
};
WINDLASS_FIELDS(SeaView, ramp_begin, ramp_end, waves)

struct ShipView {
    physics::Vec3 position = physics::Vec3::Zero();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    double heading = 0;
    physics::Vec3 velocity = physics::Vec3::Zero();
    double surge = 0, sway = 0, yaw_rate = 0;
    double engine = 0, rudder = 0, bow_thruster = 0, stern_thruster = 0;
    double engine_ordered = 0, rudder_ordered = 0, bow_thruster_ordered = 0, stern_thruster_ordered = 0;
};
WINDLASS_FIELDS(ShipView, position, attitude, heading, velocity, surge, sway, yaw_rate, engine, rudder,
                bow_thruster, stern_thruster, engine_ordered, rudder_ordered, bow_thruster_ordered,
                stern_thruster_ordered)

struct AnchorView {
    AnchorPhase phase = AnchorPhase::hanging;
    physics::Vec3 position = physics::Vec3::Zero();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    physics::Vec3 velocity = physics::Vec3::Zero();
    physics::Vec3 shackle = physics::Vec3::Zero();
    double height_above_bottom = 0;
    double holding_capacity = 0, holding_used = 0, uplift = 0, embedment = 0, dragged = 0;
    Soil soil = Soil::sand;
    double fluke_angle = 0, weight = 0, carried = 0, breakout = 0, bent = 0, fouled = 0;
};
WINDLASS_FIELDS(AnchorView, phase, position, attitude, velocity, shackle, height_above_bottom,
                holding_capacity, holding_used, uplift, embedment, dragged, soil, fluke_angle, weight,
                carried, breakout, bent, fouled)

/// A joining shackle with its marks.
struct MarkView {
    int shackle = 0;     ///< number of lengths between it and the anchor
    double outboard = 0; ///< m of cable from the lip to it; negative: inboard
    int white_links = 0; ///< on either side
    bool last = false;   ///< the length inboard of it is painted in the warning colour
    Eigen::Vector3f position = Eigen::Vector3f::Zero(); ///< m, world; the lip when it is inboard
};
WINDLASS_FIELDS(MarkView, shackle, outboard, white_links, last, position)

struct ChainView {
    double cable_out = 0, lead_clock = 0, top_angle = 0, on_bottom = 0, turns = 0;
    double largest_tension = 0, stretched = 0, stretch = 0;
    Stay stay = Stay::up_and_down;
    std::vector<Eigen::Vector3f> nodes; ///< hawse pipe lip first; capacity reserved for the full cable
    std::vector<float> tension;         ///< N, one fewer than nodes
    std::vector<MarkView> marks;        ///< nearest the anchor first
};
WINDLASS_FIELDS(ChainView, cable_out, lead_clock, top_angle, on_bottom, turns, largest_tension, stretched,
                stretch, stay, nodes, tension, marks)

struct WindlassView {
    double hawse_tension = 0, gypsy_load = 0, gypsy_load_indicated = 0;
    double brake_load = 0, stopper_load = 0, motor_load = 0;
    double shaft_brake_load = 0, bitter_end_load = 0, spurling_pipe_load = 0, locker_load = 0;
    double breaking_load = 0, brake_capacity = 0, brake_rating = 0, lining_friction = 0;
    double cable_out = 0, cable_out_indicated = 0;
    double cable_speed_indicated = 0; ///< m/s, at which the counter counts, and what ails it
    double cable_speed = 0, gypsy_speed = 0, gypsy_turn = 0;
    double brake_position = 0, brake_torque = 0, brake_power = 0, brake_energy = 0, brake_wear = 0;
    double lining_temperature = 0, drum_temperature = 0;
    double motor_torque = 0, motor_speed = 0, motor_current = 0, motor_pressure = 0, motor_temperature = 0;
    double speed_lever = 0;
    bool power = true, tripped = false, emergency_stop = false, stopper_closed = false;
    ClutchState clutch = ClutchState::out;
    double clutch_offset = 0; ///< 0..1 of the claws' pitch
    bool clutch_sheared = false, gypsy_jumping = false, stopper_sprung = false, motor_burst = false;
};
WINDLASS_FIELDS(WindlassView, hawse_tension, gypsy_load, gypsy_load_indicated, brake_load, stopper_load,
                motor_load, shaft_brake_load, bitter_end_load, spurling_pipe_load, locker_load, breaking_load,
                brake_capacity, brake_rating, lining_friction, cable_out, cable_out_indicated,
                cable_speed_indicated, cable_speed, gypsy_speed, gypsy_turn, brake_position, brake_torque,
                brake_power, brake_energy, brake_wear, lining_temperature, drum_temperature, motor_torque,
                motor_speed, motor_current, motor_pressure, motor_temperature, speed_lever, power, tripped,
                emergency_stop, stopper_closed, clutch, clutch_offset, clutch_sheared, gypsy_jumping,
                stopper_sprung, motor_burst)

struct DeckWorkView {
    DeckWork set = DeckWork::none; ///< what the men are set to
    double left = 0;               ///< s
    words::DeckHindrance waits = words::DeckHindrance::none;
};
WINDLASS_FIELDS(DeckWorkView, set, left, waits)

struct TackleView {
    Side side = Side::port;
    AnchorView anchor;
    ChainView chain;
    WindlassView windlass;
    DeckWorkView deck_work;
    physics::Vec3 hawse = physics::Vec3::Zero(); ///< m, world, lip of the hawse pipe
    physics::Vec3 force =
        physics::Vec3::Zero(); ///< N, world, of this cable on the ship, hull contact included
};
WINDLASS_FIELDS(TackleView, side, anchor, chain, windlass, deck_work, hawse, force)

struct FaultView {
    FaultOrder order;
    FaultPhase phase = FaultPhase::armed;
    double severity_now = 0; ///< 0..1, on its way to the order's
};
WINDLASS_FIELDS(FaultView, order, phase, severity_now)

enum class BridgeOrderState { given, repeated, misrepeated, not_repeated, cancelled };
constexpr BridgeOrderState last_of(BridgeOrderState) {
    return BridgeOrderState::cancelled;
}

/// Names, units and meaning as in idl BridgeOrder. repeat_by 0: it need not be repeated (a question).
struct BridgeOrderView {
    int number = 0;
    std::uint64_t tick = 0;
    double time = 0, repeat_by = 0, do_by = 0;
    BridgeOrderGiven given{};
    BridgeOrderState state = BridgeOrderState::given;
};
WINDLASS_FIELDS(BridgeOrderView, number, tick, time, repeat_by, do_by, given, state)

struct ExerciseEvent {
    std::uint64_t tick = 0;
    double time = 0;
    std::uint64_t number = 0;
    Severity severity = Severity::info;
    std::string code; ///< e.g. "anchor.let_go"
    int side = -1;
    double value = 0;
    std::string text;
};
WINDLASS_FIELDS(ExerciseEvent, tick, time, number, severity, code, side, value, text)

struct Snapshot {
    std::uint64_t tick = 0;
    double time = 0;
    std::uint64_t state_hash = 0; ///< 0: not known
    EnvironmentView environment;
    SeaView sea;
    ShipView ship;
    physics::Vec3 cable_force = physics::Vec3::Zero();  ///< N, world, of all cables on the ship
    physics::Vec3 cable_moment = physics::Vec3::Zero(); ///< N m, about midships on the waterline
    std::vector<TackleView> tackle;                     ///< one or two
    std::vector<FaultView> faults;
    std::vector<BridgeOrderView> bridge_orders; ///< of this run, in their order
    WatchCircleOrder watch_circle;
    bool outside_watch_circle = false;
    LightsAndShapes lights_and_shapes;
    std::vector<ExerciseEvent> events; ///< that happened in this tick
    ModelLevel model_level = ModelLevel::dynamic;
    physics::ModelError model_error; ///< estimated, of the worse of the cables; negative: not estimated
    unsigned model_nodes = 0, model_substeps = 0;
    physics::StepCounts model_steps; ///< of the last ten seconds
    bool model_in_doubt = false;     ///< on these counts
};
WINDLASS_FIELDS(Snapshot, tick, time, state_hash, environment, sea, ship, cable_force, cable_moment, tackle,
                faults, bridge_orders, watch_circle, outside_watch_circle, lights_and_shapes, events,
                model_level, model_error, model_nodes, model_substeps, model_steps, model_in_doubt)

} // namespace windlass::exercise
