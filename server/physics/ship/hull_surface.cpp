#include "server/physics/ship/hull_surface.hpp"

#include "server/physics/base/turn.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kStations = 14;         ///< along the entrance
constexpr double kEntrance = 0.2;     ///< of the length, over which a full ship's bow is drawn in
constexpr double kRake = 0.5;         ///< of the height: the stem leans forward above the water (27 deg)
constexpr double kDeckAboveLip = 2.5; ///< m

/// Waterlines y = B/2 (1 - s^p), s from the start of the entrance (0) to the stem (1).
struct Bow {
    double entrance, deck, stem_at_deck, half_beam, power;

    explicit Bow(const ShipDef& def, double clearance)
        : entrance((0.5 - kEntrance) * def.length_overall),
          deck(def.hawse_height + kDeckAboveLip),
          stem_at_deck(0.5 * def.length_overall),
          half_beam(0.5 * def.beam),
          power(2) {
        // The power that brings the side through the lip.
        const double s = station(def.hawse_forward, def.hawse_height);
        const double share = std::clamp((def.hawse_outboard - clearance) / half_beam, 0.02, 0.98);
        if (s > 0.05 && s < 0.99) power = std::clamp(std::log(1 - share) / std::log(s), 1.0, 12.0);
    }
    double stem(double z) const { return stem_at_deck - kRake * (deck - std::max(0.0, z)); }
    double station(double x, double z) const { return (x - entrance) / (stem(z) - entrance); }
    Vec3 point(double s, double z) const {
        return {entrance + s * (stem(z) - entrance), half_beam * (1 - std::pow(s, power)), z};
    }
};

} // namespace

ObstacleMesh hull_mesh(const ShipDef& def, double clearance) {
    const Bow bow(def, clearance);
    const std::array levels{-def.draught, 0.0, def.hawse_height, bow.deck};
    std::vector<double> stations;
    for (int k = 0; k <= kStations; ++k) // closer together towards the stem
        stations.push_back(std::sin(0.5 * std::numbers::pi * k / kStations));
    const double at_lip = bow.station(def.hawse_forward, def.hawse_height);
    if (at_lip > 0 && at_lip < 1) stations.push_back(at_lip);
    std::sort(stations.begin(), stations.end());
    stations.erase(
        std::unique(stations.begin(), stations.end(), [](double a, double b) { return b - a < 1e-3; }),
        stations.end());
    stations.back() = 1;

    // Columns from the stern along the port side to the stem and back along starboard.
    std::vector<Vec3> corners;
    std::vector<std::array<int, 3>> triangles;
    const int rows = static_cast<int>(levels.size());
    const auto column = [&](double s, bool stern, double side) {
        for (const double z : levels) {
            Vec3 p = stern ? Vec3(-0.5 * def.length_overall, bow.half_beam, z) : bow.point(s, z);
            p.y() = s == 1 && !stern ? 0 : side * p.y();
            if (corners.size() % levels.size() == 0) p.z() = -def.draught_at(p.x()); // the keel
            corners.push_back(p);
        }
    };
    column(0, true, 1);
    for (const double s : stations)
        column(s, false, 1);
    for (auto s = stations.rbegin() + 1; s != stations.rend(); ++s)
        column(*s, false, -1);
    column(0, true, -1);
    const int columns = static_cast<int>(corners.size()) / rows;
    const auto quad = [&](int a, int b, int c, int d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    for (int c = 0; c < columns; ++c) { // the last one closes the transom
        const int here = c * rows, next = (c + 1) % columns * rows;
        for (int r = 0; r + 1 < rows; ++r)
            quad(here + r, here + r + 1, next + r + 1, next + r);
    }
    for (int c = 0; 2 * c + 2 < columns; ++c) { // bottom and deck, from side to side
        const int port = c * rows, starboard = (columns - 1 - c) * rows, top = rows - 1;
        const int port_next = port + rows, starboard_next = starboard - rows;
        if (port_next == starboard_next) { // at the stem
            triangles.push_back({port, port_next, starboard});
            triangles.push_back({port + top, starboard + top, port_next + top});
        } else {
            quad(port, port_next, starboard_next, starboard);
            quad(port + top, starboard + top, starboard_next + top, port_next + top);
        }
    }
    return {corners, triangles};
}

double side_at_lip(const ShipDef& def, double clearance) {
    const Bow bow(def, clearance);
    const double station = std::clamp(bow.station(def.hawse_forward, def.hawse_height), 0.0, 1.0);
    return bow.point(station, def.hawse_height).y();
}

BodyMotion hull_motion(const ShipState& before, const ShipState& after, double share, double dt) {
    const double turn = remainder_of_turn(after.heading - before.heading, 2 * std::numbers::pi);
    const double heading = before.heading + share * turn;
    const auto between = [=](double a, double b) { return a + share * (b - a); };
    ShipState now;
    now.x = between(before.x, after.x), now.y = between(before.y, after.y), now.heading = heading;
    now.waves.pitch = between(pitch(before), pitch(after));
    now.waves.roll = between(roll(before), roll(after));
    const Vec3 from = midships(before), to = midships(after);
    BodyMotion motion;
    motion.position = from + share * (to - from);
    motion.attitude = attitude(now);
    motion.velocity = (to - from) / dt;
    // Yaw about the plumb line, pitch about the axis to port as she heads, roll about her own fore-and-aft
    // axis.
    const Vec3 ahead = motion.attitude * Vec3::UnitX();
    motion.spin = Vec3(0, 0, -turn / dt) + (pitch(after) - pitch(before)) / dt * starboard(now) +
                  (roll(after) - roll(before)) / dt * ahead;
    return motion;
}

} // namespace windlass::physics
