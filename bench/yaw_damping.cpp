#include "bench/yaw_damping.hpp"

#include "server/config/config.hpp"
#include "server/physics/lod/catenary.hpp"
#include "server/physics/ship/ship_dynamics.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace windlass::bench {

namespace {

using namespace physics;

constexpr double kCable = 247; // m

/// One thing that is otherwise.
struct Change {
    const char* what;
    const char* source;
    double round = 1;         ///< drag of the hull's turning, over the server's
    double across = 1;        ///< drag of its drifting, likewise
    double straightening = 1; ///< N_r
    double drift_moment = 1;  ///< N_v
    bool strips = false;      ///< the wind blows on each part of her as that moves
    double windage = 0;       ///< m, by which the centre of her windage is farther forward
    double astern = 0; ///< N, that push her astern in her own axis, as the drift of a sea from ahead does
    double trim = 2.5; ///< m, by the stern
};

constexpr std::array kChanges{
    Change{"as she is", ""},
    Change{.what = "on an even keel", .source = "", .trim = 0},
    Change{.what = "drag of turning x 1.7", .source = "C_D 0.967 as identified: Miyauchi 2022", .round = 1.7},
    Change{.what = "drag of turning x 3", .source = "more than any source has", .round = 3},
    Change{.what = "all cross-flow drag x 1.5",
           .source = "Hooft 1994: ends of the hull",
           .round = 1.5,
           .across = 1.5},
    Change{.what = "N_r x 3", .source = "more than any source has", .straightening = 3},
    Change{.what = "no N_v", .source = "no moment of drift at all", .drift_moment = 0},
    Change{.what = "wind on a side that turns", .source = "strips", .strips = true},
    Change{.what = "windage 15 m farther aft", .source = "a longer house", .windage = -15},
    Change{.what = "100 kN from ahead", .source = "a sea of some 2.5 m from ahead", .astern = 1e5},
    Change{.what = "200 kN from ahead", .source = "a sea of some 3.5 m from ahead", .astern = 2e5},
};

struct Yaw {
    double degrees = 0, period = 0; ///< to either side; s
};

Yaw lie(const exercise::ExerciseDef& exercise, const Change& change, double wind) {
    ShipDef def = exercise.ship;
    def.windage_lever += change.windage, def.trim = change.trim;
    HullCoefficients hull = hull_coefficients(def);
    hull.turn_yaw *= change.straightening, hull.turn_drift *= change.drift_moment;
    ShipDynamics ship(def, hull, propulsion_coefficients(def));
    EnvironmentDef sea = exercise.environment;
    HullCoefficients cross_flow_alone = in_depth(hull, sea.depth);
    cross_flow_alone.side_drift = cross_flow_alone.side_yaw = 0;
    cross_flow_alone.turn_drift = cross_flow_alone.turn_yaw = 0;
    sea.wind_speed = wind, sea.wind_from = 0, sea.current_speed = 0;
    Catenary cable(exercise.tackle[0].chain, sea);

    ShipState state; // she lies to leeward of the anchor, which is at the origin
    state.heading = 5 * std::numbers::pi / 180;
    state.y = -(kCable - 20) - def.hawse_forward;
    constexpr double kStep = 0.1, kHour = 3600;
    double span = 0, pull = 0, first = 0, last = 0;
    int crossings = -1, side = 0;
    Yaw found;
    for (double time = 0; time < 2 * kHour; time += kStep) {
        const Vec3 lip = midships(state) + def.hawse_forward * forward(state);
        const double now = std::hypot(lip.x(), lip.y());
        if (cable.solve(kCable, now, def.hawse_height))
            span = now, pull = cable.horizontal();
        else // it is taut, or hangs plumb
            pull = std::max(0.0, pull + exercise.tackle[0].chain.stiffness / kCable * (now - span)),
            span = now;
        CablePull on_ship;
        const Vec3 force = -pull / now * Vec3(lip.x(), lip.y(), 0);
        on_ship.force = force - change.astern * forward(state);
        const double r = state.yaw_rate;
        const PlanarForce drag = hull_force(cross_flow_alone, sea.water_density, 0, state.sway, r);
        on_ship.force += (change.across - 1) * drag.y * starboard(state);
        on_ship.moment = force.dot(starboard(state)) * def.hawse_forward + (change.round - 1) * drag.moment;
        if (change.strips) { // V of the wind over a side: rho A C V r L^2 / 12
            const double length = def.length_overall;
            on_ship.moment -=
                kAirDensity * def.lateral_windage * def.wind_across * wind * r * length * length / 12;
        }
        ship.step(sea, {}, {}, on_ship, kStep, state);
        if (time < kHour) continue;
        const double off = std::remainder(state.heading, 2 * std::numbers::pi) * 180 / std::numbers::pi;
        found.degrees = std::max(found.degrees, std::abs(off));
        const int to = off > 3 ? 1 : off < -3 ? -1 : side; // deg, that count as a side
        if (to == side) continue;
        if (side != 0) {
            if (++crossings == 0) first = time;
            last = time;
        }
        side = to;
    }
    if (crossings > 0) found.period = 2 * (last - first) / crossings;
    return found;
}

} // namespace

void table_of_dampings(std::ostream& table, std::span<const double> winds) {
    const exercise::ExerciseDef exercise = config::parse_exercise(
        R"({"environment": {"depth": 30}, "ship": {"from": "panamax_ballast"},
            "tackle": [{"side": "port", "windlass": {"from": "electric_78mm"},
                        "chain": {"from": "stud_link_78mm_k3"}, "anchor": {"from": "stockless_9900"}}]})",
        "panamax_ballast", WINDLASS_CONFIG_DIR);
    fmt::print(table, "wind_m_per_s,otherwise,source,yaw_deg,period_min\n");
    for (const double wind : winds)
        for (const Change& change : kChanges) {
            const Yaw found = lie(exercise, change, wind);
            fmt::print(table, "{},{},{},{:.0f},{:.1f}\n", wind, change.what, change.source, found.degrees,
                       found.period / 60);
            table.flush();
        }
}

} // namespace windlass::bench
