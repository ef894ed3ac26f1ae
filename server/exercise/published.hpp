#pragma once
// One list of the fields of each part of a snapshot, gone through by whoever checks or compares what is
// published. A list is the structured binding itself: a field that is added to a struct and not to its list
// does not compile, so none goes out unchecked.

#include "server/exercise/snapshot.hpp"

#include <concepts>
#include <string_view>
#include <type_traits>

namespace windlass::exercise {

/// Whether every number that would be published is finite. The last gate: NaN never goes out.
bool is_finite(const Snapshot& snapshot);

namespace published {

template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

template <class T>
concept Leaf = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::same_as<T, std::string>;

template <class T>
inline constexpr bool kIsList = false;
template <class T, class Allocator>
inline constexpr bool kIsList<std::vector<T, Allocator>> = true;

/// "a, b, c": the k-th name of a list.
std::string name_in(std::string_view list, int index);

template <class Visitor, class Value>
void visit(Visitor& visitor, const std::string& name, Value& value);

template <class Visitor, class... Fields>
void visit_all(Visitor& visitor, std::string_view names, Fields&... fields) {
    int index = 0;
    (visit(visitor, visitor.kNamed ? name_in(names, index++) : std::string(), fields), ...);
}

/// Binds every field of a struct and goes through them under the names that they have here.
#define WINDLASS_PUBLISHED(Struct, ...)                                                                      \
    template <class Visitor, Is<Struct> View>                                                                \
    void each_field(Visitor& visitor, View& view) {                                                          \
        auto& [__VA_ARGS__] = view;                                                                          \
        visit_all(visitor, #__VA_ARGS__, __VA_ARGS__);                                                       \
    }

WINDLASS_PUBLISHED(physics::CurrentLayer, depth, share, turn)
WINDLASS_PUBLISHED(physics::ModelError, load, shape)
WINDLASS_PUBLISHED(Weather, wind_speed, wind_from, gust_factor, gust_period, veering, wave_height,
                   wave_period, wave_from, swell_height, swell_period, swell_from, wave_seed, current_speed,
                   current_towards, current_profile, tide_height, visibility, time_of_day)
WINDLASS_PUBLISHED(EnvironmentView, depth, now, after, ramp_left, gust, swing)
WINDLASS_PUBLISHED(physics::WaveComponent, k_x, k_y, omega, phase, amplitude_before, amplitude_after)
WINDLASS_PUBLISHED(SeaView, ramp_begin, ramp_end, waves)
WINDLASS_PUBLISHED(ShipView, position, attitude, heading, velocity, surge, sway, yaw_rate, engine, rudder,
                   bow_thruster, stern_thruster)
WINDLASS_PUBLISHED(AnchorView, phase, position, attitude, velocity, shackle, height_above_bottom,
                   holding_capacity, holding_used, uplift, embedment, dragged, soil, fluke_angle, weight,
                   carried, breakout, bent, fouled)
WINDLASS_PUBLISHED(MarkView, shackle, outboard, white_links, last, position)
WINDLASS_PUBLISHED(ChainView, cable_out, lead_clock, top_angle, on_bottom, turns, largest_tension, stretched,
                   stretch, stay, nodes, tension, marks)
WINDLASS_PUBLISHED(WindlassView, hawse_tension, gypsy_load, gypsy_load_indicated, brake_load, stopper_load,
                   motor_load, shaft_brake_load, bitter_end_load, spurling_pipe_load, locker_load,
                   breaking_load, brake_capacity, brake_rating, lining_friction, cable_out,
                   cable_out_indicated, cable_speed_indicated, cable_speed, gypsy_speed, gypsy_turn,
                   brake_position, brake_torque, brake_power, brake_energy, brake_wear, lining_temperature,
                   drum_temperature, motor_torque, motor_speed, motor_current, motor_pressure,
                   motor_temperature, speed_lever, power, tripped, emergency_stop, stopper_closed, clutch,
                   clutch_offset, clutch_sheared, gypsy_jumping, stopper_sprung, motor_burst)
WINDLASS_PUBLISHED(TackleView, side, anchor, chain, windlass, hawse, force)
WINDLASS_PUBLISHED(FaultOrder, code, side, severity, ramp, lasts, trigger, trigger_value, trigger_until,
                   trigger_event, trigger_order, target, clear)
WINDLASS_PUBLISHED(FaultView, order, phase, severity_now)
WINDLASS_PUBLISHED(BridgeOrderGiven, code, side, value, text, by, repeat_within, do_within, cancels)
WINDLASS_PUBLISHED(BridgeOrderView, number, tick, time, repeat_by, do_by, given, state)
WINDLASS_PUBLISHED(WatchCircleOrder, kept, x, y, radius)
WINDLASS_PUBLISHED(LightsAndShapes, anchor_ball, anchor_lights)
WINDLASS_PUBLISHED(ExerciseEvent, tick, time, number, severity, code, side, value, text)
WINDLASS_PUBLISHED(physics::StepCounts, steps, implicit, unsolved, friction, contacts, dropped, capped)
WINDLASS_PUBLISHED(Snapshot, tick, time, state_hash, environment, sea, ship, cable_force, cable_moment,
                   tackle, faults, bridge_orders, watch_circle, outside_watch_circle, lights_and_shapes,
                   events, model_level, model_error, model_nodes, model_substeps, model_steps, model_in_doubt)
#undef WINDLASS_PUBLISHED

/// A visitor has kNamed (whether it wants names; they cost), field(name, leaf) for numbers, enumerators,
/// flags and texts, and numbers(name, first, count) for vectors of numbers, double or float.
template <class Visitor, class Value>
void visit(Visitor& visitor, const std::string& name, Value& value) {
    using Plain = std::remove_const_t<Value>;
    if constexpr (Leaf<Plain>) {
        visitor.field(name, value);
    } else if constexpr (std::same_as<Plain, Eigen::Quaterniond>) {
        visitor.numbers(name, value.coeffs().data(), 4);
    } else if constexpr (std::same_as<Plain, physics::Vec3> || std::same_as<Plain, Eigen::Vector3f>) {
        visitor.numbers(name, value.data(), 3);
    } else if constexpr (std::same_as<Plain, std::vector<float>>) {
        visitor.numbers(name, value.data(), value.size());
    } else if constexpr (kIsList<Plain>) {
        for (std::size_t k = 0; k < value.size(); ++k)
            visit(visitor, visitor.kNamed ? name + '[' + std::to_string(k) + ']' : std::string(), value[k]);
    } else {
        if constexpr (requires { visitor.enter(name); }) visitor.enter(name);
        each_field(visitor, value);
        if constexpr (requires { visitor.leave(); }) visitor.leave();
    }
}

} // namespace published

/// Every field of a snapshot, in an order that does not change while the program runs.
template <class Visitor, published::Is<Snapshot> View>
void visit_published(Visitor& visitor, View& snapshot) {
    published::each_field(visitor, snapshot);
}

} // namespace windlass::exercise
