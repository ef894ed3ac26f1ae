#pragma once
// Which field of a file stands for which member: one list for each kind, used to read and to write.
// A visitor has number, degrees (file in degrees, member in radians), hours (member in seconds), integer,
// flag, text and choice.

#include "server/exercise/definition/exercise_def.hpp"
#include "server/exercise/weather/weather_table.hpp"
#include "server/physics/sea/ground.hpp"
#include "words/words.hpp"

#include <array>

namespace windlass::exercise {

inline constexpr std::array kSideNames{"port", "starboard"}; ///< in the order of Side
inline constexpr std::array kGradeNames{"k1", "k2", "k3"};   ///< of physics::Grade
inline constexpr std::array kDriveNames{"electric_vfd", "electric_pole_changing", "hydraulic"}; ///< DriveKind
inline constexpr std::array kAnchorNames{"hall", "spek", "ac14", "hhp", "shhp", "stock"}; ///< AnchorType
inline constexpr std::array kStopperNames{"bar", "pawl"};                                 ///< StopperKind

template <class Visitor>
void visit_fields(Visitor& field, physics::ShipDef& def) {
    field.number("length_overall", def.length_overall);
    field.number("length_pp", def.length_pp);
    field.number("beam", def.beam);
    field.number("draught", def.draught);
    field.number("trim", def.trim);
    field.number("displacement", def.displacement);
    field.number("gyration_radius", def.gyration_radius);
    field.number("lateral_windage", def.lateral_windage);
    field.number("frontal_windage", def.frontal_windage);
    field.number("windage_lever", def.windage_lever);
    field.number("wind_across", def.wind_across);
    field.number("wind_ahead", def.wind_ahead);
    field.number("wind_astern", def.wind_astern);
    field.number("wind_crossing", def.wind_crossing);
    field.number("thrust_ahead", def.thrust_ahead);
    field.number("thrust_astern", def.thrust_astern);
    field.number("propeller_diameter", def.propeller_diameter);
    field.number("paddle_wheel", def.paddle_wheel);
    field.number("engine_time", def.engine_time);
    field.number("engine_start_time", def.engine_start_time);
    field.number("rudder_area", def.rudder_area);
    field.degrees("rudder_max_deg", def.rudder_max);
    field.degrees("rudder_rate_deg", def.rudder_rate);
    field.number("bow_thruster", def.bow_thruster);
    field.number("stern_thruster", def.stern_thruster);
    field.number("metacentric_height", def.metacentric_height);
    field.number("roll_damping", def.roll_damping);
    field.number("hawse_forward", def.hawse_forward);
    field.number("hawse_outboard", def.hawse_outboard);
    field.number("hawse_height", def.hawse_height);
}

template <class Visitor>
void visit_fields(Visitor& field, physics::ChainDef& def) {
    field.number("diameter", def.diameter);
    field.choice("grade", def.grade, kGradeNames);
    field.number("length", def.length);
    field.number("node_spacing", def.node_spacing);
}

template <class Visitor>
void visit_fields(Visitor& field, physics::LinkCondition& condition) {
    field.number("begins", condition.begins);
    field.number("ends", condition.ends);
    field.number("wear", condition.wear);
    field.number("defect", condition.defect);
}

template <class Visitor>
void visit_fields(Visitor& field, physics::AnchorDef& def) {
    field.choice("type", def.type, kAnchorNames);
    field.number("mass", def.mass);
    field.number("shank_length", def.shank_length);
    field.number("fluke_length", def.fluke_length);
    field.number("crown_width", def.crown_width);
    field.number("drag_area", def.drag_area);
}

template <class Visitor>
void visit_fields(Visitor& field, physics::WindlassDef& def) {
    field.number("hawse_pipe_height", def.hawse_pipe_height);
    field.number("hawse_pipe_length", def.hawse_pipe_length);
    field.number("locker_lift", def.locker_lift);
    field.number("bitter_end_strength", def.bitter_end_strength);
    field.number("gypsy_radius", def.gypsy_radius);
    field.number("gypsy_inertia", def.gypsy_inertia);
    field.number("gypsy_grip", def.gypsy_grip);
    field.number("counter_offset", def.counter_offset);
    field.number("brake_rating", def.brake_rating);
    field.number("brake_free_play", def.brake_free_play);
    field.number("brake_stiffening", def.brake_stiffening);
    field.number("brake_travel_time", def.brake_travel_time);
    field.number("brake_track_area", def.brake_track_area);
    field.number("drum_heat_capacity", def.drum_heat_capacity);
    field.number("drum_cooling", def.drum_cooling);
    field.choice("stopper", def.stopper, kStopperNames);
    field.number("stopper_rating", def.stopper_rating);
    field.choice("drive", def.drive, kDriveNames);
    field.number("rated_pull", def.rated_pull);
    field.number("rated_speed", def.rated_speed);
    field.number("stall_pull", def.stall_pull);
    field.number("light_line_speed", def.light_line_speed);
    field.number("motor_inertia", def.motor_inertia);
    field.number("shaft_brake_rating", def.shaft_brake_rating);
    field.number("motor_current_rated", def.motor_current_rated);
    field.integer("hydraulic_pumps", def.hydraulic_pumps);
    field.number("hydraulic_pump_flow", def.hydraulic_pump_flow);
    field.number("hydraulic_relief", def.hydraulic_relief);
    field.number("hydraulic_counterbalance", def.hydraulic_counterbalance);
    field.number("hydraulic_displacement", def.hydraulic_displacement);
    field.number("hydraulic_leakage", def.hydraulic_leakage);
    field.number("clutch_rating", def.clutch_rating);
}

template <class Visitor>
void visit_fields(Visitor& field, physics::CurrentLayer& layer) {
    field.number("depth", layer.depth);
    field.number("share", layer.share);
    field.degrees("turn_deg", layer.turn);
}

/// The ground's own fields; its heights and soils are rows beside them.
template <class Visitor>
void visit_fields(Visitor& field, physics::GroundDef& def) {
    field.degrees("slope_deg", def.slope);
    field.degrees("slope_towards_deg", def.slope_towards);
    field.number("west", def.west);
    field.number("south", def.south);
    field.number("spacing", def.spacing);
}

/// The environment's own fields; ground is a part of it.
template <class Visitor>
void visit_fields(Visitor& field, physics::EnvironmentDef& def) {
    field.number("depth", def.depth);
    field.number("water_density", def.water_density);
    field.choice("soil", def.soil, words::kSoilNames);
}

template <class Visitor>
void visit_fields(Visitor& field, TideRow& row) {
    field.hours("time_h", row.time);
    field.number("height", row.height);
    field.number("current_speed", row.current_speed);
    field.degrees("current_towards_deg", row.current_towards);
}

/// What a file may say of the weather, beside the environment's own fields; current_profile and tide are
/// parts of it.
template <class Visitor>
void visit_fields(Visitor& field, Weather& weather) {
    for_each_field<Weather>([&](auto member) {
        auto& value = member.of(weather);
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
            constexpr WeatherRow kRow = weather_row(member.name);
            if constexpr (kRow.unit() == kRow.file_unit && std::is_same_v<decltype(value), double&>) {
                field.number(kRow.file_name.data(), value);
            } else if constexpr (kRow.file_unit == "h") {
                field.hours(kRow.file_name.data(), value);
            } else if constexpr (std::is_same_v<decltype(value), double&>) {
                field.degrees(kRow.file_name.data(), value);
            } else {                                   // the seed
                auto number = static_cast<int>(value); // the schema keeps it below what an int holds
                field.integer(kRow.file_name.data(), number);
                value = static_cast<std::decay_t<decltype(value)>>(number);
            }
        }
    });
}

/// What is fitted at the forecastle, and what is allowed there: names of a file's two lists.
template <class Visitor>
void visit_fitted(Visitor& field, Seats& seats) {
    field.flag("counter", seats.counter);
    field.flag("load_cell", seats.load_cell);
}
template <class Visitor>
void visit_aids(Visitor& field, Seats& seats) {
    field.flag("lead_readout", seats.lead_readout);
    field.flag("lining_temperature", seats.lining_temperature);
    field.flag("underwater", seats.underwater);
    field.flag("alerts_without_sensor", seats.alerts_without_sensor);
    field.flag("latched_lever", seats.latched_lever);
}

template <class Visitor>
void visit_fields(Visitor& field, ShipStartDef& def) {
    field.number("x", def.x);
    field.number("y", def.y);
    field.degrees("heading_deg", def.heading);
    field.number("surge", def.surge);
    field.number("sway", def.sway);
    field.degrees("yaw_rate_deg", def.yaw_rate);
    field.degrees("turned_deg", def.turned);
}

/// The tackle's own fields; windlass, chain, anchor and condition are parts of it.
template <class Visitor>
void visit_fields(Visitor& field, GroundTackleDef& def) {
    field.choice("side", def.side, kSideNames);
    field.number("cable_out", def.cable_out);
    field.flag("anchor_home", def.anchor_home);
    field.number("brake", def.brake);
    field.flag("clutch_in", def.clutch_in);
    field.flag("stopper_closed", def.stopper_closed);
    field.number("at_anchor", def.at_anchor);
}

template <class Visitor>
void visit_fields(Visitor& field, ModelDef& def) {
    field.flag("adaptive", def.adaptive);
}

/// The exercise's own fields; model, environment, seats, ship, ship_start, tackle and faults are objects
/// inside it.
template <class Visitor>
void visit_fields(Visitor& field, ExerciseDef& def) {
    field.text("name", def.name);
    field.text("title", def.title);
    field.text("title_trainee", def.title_trainee);
    field.integer("tick_rate_hz", def.tick_rate_hz);
    field.integer("max_substeps", def.max_substeps);
    field.integer("chance_seed", def.chance_seed);
}

} // namespace windlass::exercise
