#include "server/exercise/picture/views.hpp"

#include "server/physics/base/vectorise.hpp"
#include "server/physics/chain/shackle_marks.hpp"
#include "server/physics/sea/ground.hpp"
#include "words/words.hpp"

#include <cmath>
#include <numbers>

namespace windlass::exercise {

using physics::Vec3;

namespace {

/// Direction of a horizontal vector from the bow as a clock face reads it: 12 ahead, 3 on the starboard beam.
double clock_hours(const Vec3& direction, double heading) {
    const double bearing = std::atan2(direction.x(), direction.y()) - heading;
    const double hours = std::fmod(bearing / std::numbers::pi * 6 + 24, 12);
    return hours == 0 ? 12 : hours;
}

/// Marks of the whole cable: what lies inboard is seen from the deck.
void view_marks(const physics::GroundTackle& tackle, double cable_out, std::vector<MarkView>& marks) {
    const physics::ChainDef& def = tackle.setup().chain;
    marks.resize(static_cast<std::size_t>(physics::joining_shackles(def)));
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const physics::ShackleMark mark = physics::shackle_mark(def, static_cast<int>(i) + 1);
        const double at = physics::stretched_length(def, tackle.chain(), mark.from_anchor);
        marks[i] = {mark.shackle, cable_out - at, mark.white_links, mark.last,
                    physics::point_of_cable(def, tackle.chain(), mark.from_anchor).cast<float>()};
    }
}

} // namespace

void view_ship(const physics::ShipState& ship, const physics::Helm& ordered, const physics::Helm& answers,
               ShipView& view) {
    view.position = physics::midships(ship);
    view.attitude = physics::attitude(ship);
    view.heading = ship.heading < 0 ? ship.heading + 2 * std::numbers::pi : ship.heading;
    view.velocity = physics::ship_velocity(ship) + physics::wave_velocity(ship);
    view.surge = ship.surge, view.sway = ship.sway, view.yaw_rate = ship.yaw_rate;
    view.engine = ship.engine, view.rudder = ship.rudder;
    view.bow_thruster = answers.bow_thruster, view.stern_thruster = answers.stern_thruster;
    view.engine_ordered = ordered.engine, view.rudder_ordered = ordered.rudder;
    view.bow_thruster_ordered = ordered.bow_thruster, view.stern_thruster_ordered = ordered.stern_thruster;
}

void view_anchor(const physics::GroundTackle& tackle, AnchorPhase phase,
                 const physics::EnvironmentDef& environment, AnchorView& view) {
    const physics::Anchor& anchor = tackle.anchor();
    const physics::AnchorPose pose = anchor.pose();
    const physics::HoldingState& holding = anchor.holding();
    view.phase = phase;
    view.position = pose.position;
    view.attitude = pose.attitude;
    view.velocity = pose.velocity;
    view.shackle = anchor.shackle();
    view.height_above_bottom = anchor.clearance(environment);
    view.uplift = tackle.uplift(environment);
    view.holding_capacity =
        holding.landed ? anchor.holding_power(environment, tackle.shackle_pull(environment)) : 0;
    view.holding_used = anchor.soil_force();
    view.embedment = holding.embedment;
    view.dragged = holding.dragged;
    view.soil = anchor.soil(environment);
    view.fluke_angle = anchor.fluke_angle();
    view.weight = anchor.weight(environment);
    view.carried = anchor.load(environment);
    view.breakout = anchor.breakout(environment);
    view.bent = holding.bent;
    view.fouled = anchor.foul();
}

void view_chain(const physics::GroundTackle& tackle, double heading,
                const physics::EnvironmentDef& environment, ChainView& view) {
    const physics::ChainState& chain = tackle.chain();
    const Vec3 lead = tackle.cable_direction();
    view.cable_out = tackle.windlass().state().cable_out;
    view.top_angle = std::atan2(-lead.z(), std::hypot(lead.x(), lead.y()));
    view.stay = static_cast<Stay>(words::stay_at(physics::degrees_from_radians(view.top_angle)));
    view.lead_clock = clock_hours(lead, heading);
    view.on_bottom = 0;
    view.turns = tackle.turns();
    view.largest_tension = tackle.strain().worst;
    view.stretched = physics::grown(tackle.setup().chain, chain, 0, chain.stretched);
    view.stretch = physics::largest(chain.stretch.data(), chain.stretched);
    view_marks(tackle, view.cable_out, view.marks);
    const int n = chain.links;
    // Inside the chain is counted from the anchor; outside from the hawse pipe.
    view.nodes.reserve(chain.position.x.size()); // for the full cable, so that veering takes no memory
    view.tension.reserve(chain.tension.size());
    view.nodes.resize(n + 1);
    view.tension.resize(n);
    for (int i = 0; i <= n; ++i)
        view.nodes[n - i] = chain.position.at(i).cast<float>();
    for (int i = 0; i < n; ++i) {
        view.tension[n - 1 - i] = static_cast<float>(chain.tension[i]);
        const Vec3 middle = 0.5 * (chain.position.at(i) + chain.position.at(i + 1));
        const double height = physics::height_over_bed(environment, middle);
        if (height < tackle.setup().chain.contact_diameter) {
            view.on_bottom += physics::link_length(tackle.setup().chain, chain, i);
        }
    }
}

void view_windlass(const physics::GroundTackle& tackle, const physics::WindlassLevers& levers,
                   const physics::EquipmentFaults& causes, WindlassView& view) {
    const physics::Windlass& windlass = tackle.windlass();
    const physics::WindlassDef& def = windlass.def();
    const physics::WindlassState& state = windlass.state();
    const physics::WindlassLoads& loads = windlass.loads();
    view.hawse_tension = loads.deck.hawse_tension;
    view.gypsy_load = loads.deck.gypsy_load;
    view.gypsy_load_indicated =
        loads.deck.gypsy_load * (1 - causes.load_cell_dead) * (1 + causes.load_cell_bias);
    view.brake_load = loads.brake;
    view.stopper_load = loads.stopper;
    view.motor_load = loads.deck.motor + loads.deck.gear + loads.shaft_brake;
    view.shaft_brake_load = loads.shaft_brake;
    view.bitter_end_load = loads.deck.bitter_end;
    view.spurling_pipe_load = loads.jam;
    view.locker_load = windlass.locker_weight();
    view.breaking_load = physics::breaking_load(tackle.setup().chain);
    view.brake_rating = def.brake_rating;
    view.brake_capacity = loads.brake_capacity;
    view.lining_friction = physics::lining_friction(state.brake, causes);
    view.cable_out = state.cable_out;
    view.cable_out_indicated = windlass.counter_reading();
    view.cable_speed_indicated = state.gypsy.jumping ? 0 : state.cable_speed * (1 - causes.counter_drift);
    view.cable_speed = state.cable_speed;
    const double diameter = tackle.setup().chain.diameter;
    view.gypsy_speed = physics::gypsy_speed(diameter, state.cable_speed, state.gypsy);
    view.gypsy_turn = physics::gypsy_turn(diameter, state.cable_out, state.gypsy);
    view.brake_position = state.brake.position;
    view.brake_torque = loads.brake * def.gypsy_radius;
    view.brake_power = loads.brake_power;
    view.brake_energy = state.brake.heat;
    view.brake_wear = windlass.brake_wear(causes);
    view.lining_temperature = state.brake.skin;
    view.drum_temperature = state.brake.drum;
    view.motor_torque = loads.deck.motor * def.gypsy_radius / physics::kGearRatio;
    view.motor_speed = -state.motor.speed / def.gypsy_radius * physics::kGearRatio;
    const bool hydraulic = def.drive == physics::DriveKind::hydraulic;
    const double pull = std::abs(loads.deck.motor);
    view.motor_current = hydraulic ? 0 : pull / physics::rated_motor_pull(def) * def.motor_current_rated;
    view.motor_pressure = state.motor.pressure;
    view.motor_temperature = windlass.motor_temperature();
    view.speed_lever = levers.speed;
    view.power = causes.power_lost < 1 && !state.motor.burst;
    view.tripped = state.motor.tripped || state.motor.overspeed || state.motor.cut_off;
    view.emergency_stop = levers.emergency_stop;
    view.stopper_closed = state.stopper.closed;
    view.clutch_offset = state.clutch.claw_offset / physics::claw_pitch(def);
    view.clutch_sheared = state.clutch.sheared;
    view.gypsy_jumping = state.gypsy.jumping;
    view.stopper_sprung = state.stopper.sprung;
    view.motor_burst = state.motor.burst;
    switch (state.clutch.position) {
    case physics::Clutch::out:
        view.clutch = ClutchState::out;
        break;
    case physics::Clutch::engaging:
        view.clutch = ClutchState::engaging;
        break;
    case physics::Clutch::in:
        view.clutch = ClutchState::in;
        break;
    }
}

void over_water(double level, Snapshot& snapshot) {
    if (level == 0) return;
    const auto single = static_cast<float>(level);
    snapshot.ship.position.z() -= level;
    for (TackleView& tackle : snapshot.tackle) {
        tackle.hawse.z() -= level;
        tackle.anchor.position.z() -= level, tackle.anchor.shackle.z() -= level;
        for (Eigen::Vector3f& node : tackle.chain.nodes)
            node.z() -= single;
        for (MarkView& mark : tackle.chain.marks)
            mark.position.z() -= single;
    }
}

} // namespace windlass::exercise
