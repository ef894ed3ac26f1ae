#include "server/assess/quantities.hpp"

#include "server/assess/hawse.hpp"
#include "server/physics/base/units.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::assess {

namespace {

using exercise::Snapshot;
using exercise::TackleView;

/// m, over the ground, from the hawse pipe's lip to the anchor.
double anchor_distance(const TackleView& tackle) {
    return (tackle.anchor.position - tackle.hawse).head<2>().norm();
}

double anchors_apart(const Snapshot& seen) {
    if (seen.tackle.size() < 2) return 0;
    return (seen.tackle[0].anchor.position - seen.tackle[1].anchor.position).head<2>().norm();
}

double difference_of_cables(const Snapshot& seen) {
    if (seen.tackle.size() < 2) return 0;
    return std::abs(seen.tackle[0].chain.cable_out - seen.tackle[1].chain.cable_out);
}

/// Whether the straight leads from the two pipes to their anchors cross, seen from above: a cross in the
/// hawse.
bool leads_crossed(const Snapshot& seen) {
    if (seen.tackle.size() < 2) return false;
    const auto plan = [](const physics::Vec3& place) { return Eigen::Vector2d(place.head<2>()); };
    const Eigen::Vector2d a = plan(seen.tackle[0].hawse), b = plan(seen.tackle[0].anchor.position);
    const Eigen::Vector2d c = plan(seen.tackle[1].hawse), d = plan(seen.tackle[1].anchor.position);
    const auto left_of = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                            const Eigen::Vector2d& at) {
        return (to - from).x() * (at - from).y() - (to - from).y() * (at - from).x() > 0;
    };
    return left_of(a, b, c) != left_of(a, b, d) && left_of(c, d, a) != left_of(c, d, b);
}

/// Half turns in the hawse (hawse.hpp); 0 with one cable.
double half_turns_in_hawse(const Snapshot& seen) {
    const TackleView* port = tackle_of(seen, static_cast<int>(exercise::Side::port));
    const TackleView* starboard = tackle_of(seen, static_cast<int>(exercise::Side::starboard));
    if (port == nullptr || starboard == nullptr) return 0;
    return turns_in_hawse(port->chain.nodes, starboard->chain.nodes);
}

/// m, from the anchor to the centre of the bridge's watch circle; far off while none is kept.
double circle_from_anchor(const Snapshot& seen, const TackleView& tackle) {
    constexpr double kNone = 1e6;
    const exercise::WatchCircleOrder& circle = seen.watch_circle;
    if (!circle.kept) return kNone;
    return std::hypot(circle.x - tackle.anchor.position.x(), circle.y - tackle.anchor.position.y());
}

/// Cable that lies on the bottom over the way that it could lie along: above 1 it lies in a heap. 1 m is the
/// least way, since an anchor lies somewhere else than under the lip.
double piled(const TackleView& tackle) {
    return tackle.chain.on_bottom / std::max(1.0, anchor_distance(tackle));
}

#define WINDLASS_OF(expression)                                                                              \
    [](const Snapshot& s, const TackleView& t) -> double {                                                   \
        static_cast<void>(s);                                                                                \
        static_cast<void>(t);                                                                                \
        return expression;                                                                                   \
    }

constexpr std::array kQuantities{
    Quantity{"cable_out", "m", "cable out from the lip, to the anchor shackle",
             WINDLASS_OF(t.chain.cable_out)},
    Quantity{"shackles", "shackles", "cable out from the lip, lengths of 27.5 m",
             WINDLASS_OF(t.chain.cable_out / physics::kShackleLength)},
    Quantity{"cable_speed", "m/s", "cable's speed, paying out positive", WINDLASS_OF(t.windlass.cable_speed)},
    Quantity{"cable_on_bottom", "m", "cable that lies on the seabed", WINDLASS_OF(t.chain.on_bottom)},
    Quantity{"piled", "m", "cable on the bottom for each metre from the bow to the anchor",
             WINDLASS_OF(piled(t))},
    Quantity{"lead_clock", "h", "where the cable leads, 12 ahead", WINDLASS_OF(t.chain.lead_clock), 12},
    Quantity{"top_angle_deg", "deg", "cable below the horizontal at the lip",
             WINDLASS_OF(physics::degrees_from_radians(t.chain.top_angle))},
    Quantity{"turns", "turns", "turns in the cable", WINDLASS_OF(t.chain.turns)},
    Quantity{"tension", "N", "tension at the hawse pipe's lip", WINDLASS_OF(t.windlass.hawse_tension)},
    Quantity{"tension_rise", "N/s", "rise of the tension at the lip, from second to second", nullptr},
    Quantity{"tension_share", "", "tension over the breaking load",
             WINDLASS_OF(t.windlass.hawse_tension / t.windlass.breaking_load)},
    Quantity{"gypsy_load", "N", "cable's pull at the gypsy", WINDLASS_OF(t.windlass.gypsy_load)},
    Quantity{"brake_load", "N", "held or dragged by the band brake", WINDLASS_OF(t.windlass.brake_load)},
    Quantity{"motor_load", "N", "through the clutch", WINDLASS_OF(t.windlass.motor_load)},
    Quantity{"stopper_load", "N", "held by the stopper", WINDLASS_OF(t.windlass.stopper_load)},
    Quantity{"brake_position", "", "brake hand-wheel (0 open, 1 hard on)",
             WINDLASS_OF(t.windlass.brake_position)},
    Quantity{"speed_lever", "", "speed lever (-1 lower, 1 heave)", WINDLASS_OF(t.windlass.speed_lever)},
    Quantity{"lining_temperature", "K", "skin of the brake's lining",
             WINDLASS_OF(t.windlass.lining_temperature)},
    Quantity{"motor_speed", "rad/s", "motor's speed, heaving positive", WINDLASS_OF(t.windlass.motor_speed)},
    Quantity{"clutch_in", "yes", "clutch in",
             WINDLASS_OF(t.windlass.clutch == exercise::ClutchState::in ? 1 : 0), 0, "clutch not in"},
    Quantity{"clutch_out", "yes", "clutch out",
             WINDLASS_OF(t.windlass.clutch == exercise::ClutchState::out ? 1 : 0), 0, "clutch not out"},
    Quantity{"stopper_on", "yes", "stopper closed", WINDLASS_OF(t.windlass.stopper_closed ? 1 : 0), 0,
             "stopper open"},
    Quantity{"power", "yes", "the motor has power", WINDLASS_OF(t.windlass.power ? 1 : 0), 0,
             "the motor has no power"},
    Quantity{"tripped", "yes", "the motor has tripped", WINDLASS_OF(t.windlass.tripped ? 1 : 0), 0,
             "the motor has not tripped"},
    Quantity{"emergency_stop", "yes", "emergency stop pressed",
             WINDLASS_OF(t.windlass.emergency_stop ? 1 : 0), 0, "emergency stop not pressed"},
    Quantity{"motor_burst", "yes", "the motor has burst", WINDLASS_OF(t.windlass.motor_burst ? 1 : 0), 0,
             "the motor has not burst"},
    Quantity{"clutch_sheared", "yes", "clutch or shaft has sheared",
             WINDLASS_OF(t.windlass.clutch_sheared ? 1 : 0), 0, "clutch and shaft are whole"},
    Quantity{"height_above_bottom", "m", "anchor's lowest point over the seabed",
             WINDLASS_OF(t.anchor.height_above_bottom)},
    Quantity{"embedment", "", "how far the flukes have dug in, 0 to 1", WINDLASS_OF(t.anchor.embedment)},
    Quantity{"dragged", "m", "anchor's way on the bottom since it landed", WINDLASS_OF(t.anchor.dragged)},
    Quantity{"fouled", "", "how foul the anchor is, 0 to 1", WINDLASS_OF(t.anchor.fouled)},
    Quantity{"anchor_depth", "m", "anchor below the surface", WINDLASS_OF(-t.anchor.position.z())},
    Quantity{"anchor_distance", "m", "way over the ground from the bow to the anchor",
             WINDLASS_OF(anchor_distance(t))},
    Quantity{"anchors_apart", "m", "distance between the two anchors", WINDLASS_OF(anchors_apart(s))},
    Quantity{"cable_difference", "m", "difference of the two cables' lengths",
             WINDLASS_OF(difference_of_cables(s))},
    Quantity{"leads_crossed", "yes", "the two cables' leads cross, seen from above",
             WINDLASS_OF(leads_crossed(s) ? 1 : 0), 0, "the two cables' leads do not cross"},
    Quantity{"turns_in_hawse", "half turns",
             "turns of the cables about each other (0 open, 1 a cross, 2 an elbow, 3 a round turn; made by "
             "turning "
             "to starboard positive, to port negative)",
             WINDLASS_OF(half_turns_in_hawse(s))},
    Quantity{"ship_speed", "m/s", "ship's speed over the ground",
             WINDLASS_OF(s.ship.velocity.head<2>().norm())},
    Quantity{"surge", "m/s", "ship's speed ahead over the ground, astern negative",
             WINDLASS_OF(s.ship.surge)},
    Quantity{"ship_x", "m", "her easting, midships", WINDLASS_OF(s.ship.position.x())},
    Quantity{"ship_y", "m", "her northing, midships", WINDLASS_OF(s.ship.position.y())},
    Quantity{"bow_x", "m", "hawse pipe's lip east", WINDLASS_OF(t.hawse.x())},
    Quantity{"bow_y", "m", "hawse pipe's lip north", WINDLASS_OF(t.hawse.y())},
    Quantity{"anchor_x", "m", "anchor east", WINDLASS_OF(t.anchor.position.x())},
    Quantity{"anchor_y", "m", "anchor north", WINDLASS_OF(t.anchor.position.y())},
    Quantity{"heading_deg", "deg", "ship's head, clockwise from north, 0 to 360",
             WINDLASS_OF(physics::degrees_from_radians(s.ship.heading)), 360},
    Quantity{"engine", "", "engine (-1 astern, 1 ahead)", WINDLASS_OF(s.ship.engine)},
    Quantity{"anchor_ball", "yes", "anchor ball shown", WINDLASS_OF(s.lights_and_shapes.anchor_ball ? 1 : 0),
             0, "no anchor ball shown"},
    Quantity{"anchor_lights", "yes", "anchor lights shown",
             WINDLASS_OF(s.lights_and_shapes.anchor_lights ? 1 : 0), 0, "no anchor lights shown"},
    Quantity{"circle_radius", "m", "radius of the bridge's watch circle, 0 while none is kept",
             WINDLASS_OF(s.watch_circle.kept ? s.watch_circle.radius : 0)},
    Quantity{"circle_from_anchor", "m", "anchor to the watch circle's centre",
             WINDLASS_OF(circle_from_anchor(s, t))},
    Quantity{"wind_speed", "m/s", "mean wind", WINDLASS_OF(s.environment.now.wind_speed)},
};

#undef WINDLASS_OF

} // namespace

std::span<const Quantity> quantities() {
    return kQuantities;
}

double one_of(const std::string& unit, const Quantity& quantity) {
    struct Other {
        std::string_view unit, of;
        double one;
    };
    constexpr std::array kOthers{Other{"kN", "N", words::units::kilonewton},
                                 Other{"t", "N", words::units::tonne}, Other{"kn", "m/s", words::units::knot},
                                 Other{"shackles", "m", words::units::shackle}};
    if (unit == quantity.unit) return 1;
    const auto other = std::ranges::find_if(
        kOthers, [&](const Other& one) { return one.unit == unit && one.of == quantity.unit; });
    return other == kOthers.end() ? 0 : other->one;
}

int quantity_of(const std::string& name) {
    const auto found = std::find_if(kQuantities.begin(), kQuantities.end(),
                                    [&](const Quantity& quantity) { return name == quantity.name; });
    return found == kQuantities.end() ? -1 : static_cast<int>(found - kQuantities.begin());
}

const TackleView* tackle_of(const Snapshot& seen, int side) {
    for (const TackleView& tackle : seen.tackle)
        if (static_cast<int>(tackle.side) == side) return &tackle;
    return nullptr;
}

} // namespace windlass::assess
