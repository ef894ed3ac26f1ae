#include "server/perceive/scene.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/definition/def_fields.hpp"
#include "server/perceive/senses.hpp"
#include "server/physics/anchor/anchor_shape.hpp"
#include "server/physics/sea/ground.hpp"
#include "server/physics/ship/hull_surface.hpp"
#include "server/physics/windlass/gypsy.hpp"

#include <map>
#include <stdexcept>

namespace windlass::perceive {

namespace {

static_assert(static_cast<int>(physics::Soil::mixed) == SOIL_MIXED);

// Bounds of the IDL.
constexpr std::size_t kCorners = 4096, kTriangleCorners = 24576, kGridPoints = 16384, kSoundings = 1024;

constexpr double kSounding = 50; ///< m, between soundings, where their number allows
constexpr double kWaters = 750;  ///< m, of the start, that the chart shows to every side at least

template <class FixedString>
void name(const char* text, FixedString& to) {
    to = std::string(text);
}

void put(const physics::Vec3& from, Vec3& to) {
    to.x(from.x());
    to.y(from.y());
    to.z(from.z());
}

/// Triangles as contact has them, each corner once.
void put(const physics::ObstacleMesh& mesh, SceneDescription& to) {
    std::map<std::array<double, 3>, std::uint32_t> number;
    to.hull_corners().clear();
    to.hull_triangles().clear();
    for (int t = 0; t < mesh.triangles(); ++t) {
        for (const physics::Vec3& corner : mesh.triangle(t).corner) {
            const auto next = static_cast<std::uint32_t>(to.hull_corners().size());
            const auto [known, fresh] = number.try_emplace({corner.x(), corner.y(), corner.z()}, next);
            to.hull_triangles().push_back(known->second);
            if (!fresh) continue;
            Point3f& point = to.hull_corners().emplace_back();
            point.x(static_cast<float>(corner.x()));
            point.y(static_cast<float>(corner.y()));
            point.z(static_cast<float>(corner.z()));
        }
    }
    if (to.hull_corners().size() > kCorners || to.hull_triangles().size() > kTriangleCorners)
        throw std::length_error("a hull of more triangles than the wire takes");
}

void describe_tackle(const exercise::ExerciseDef& def, const exercise::GroundTackleDef& tackle,
                     const physics::ObstacleMesh& hull, const SeatAids& aids, SceneTackle& to) {
    const physics::WindlassDef& windlass = tackle.windlass;
    to.side(static_cast<int>(tackle.side));
    to.chain_diameter(tackle.chain.diameter);
    to.chain_length(tackle.chain.length);
    to.gypsy_radius(windlass.gypsy_radius);
    to.pockets(physics::kGypsyPockets);
    const physics::HawsePipe pipe = exercise::hawse_pipe(def, tackle, hull);
    put(pipe.lip, to.lip());
    put(pipe.mouth, to.mouth());
    put(pipe.bore, to.bore());
    to.bend(pipe.bend);
    to.seat(pipe.seat);
    to.pipe_length(windlass.hawse_pipe_length);
    name(exercise::kDriveNames.at(static_cast<std::size_t>(windlass.drive)), to.drive());
    name(exercise::kStopperNames.at(static_cast<std::size_t>(windlass.stopper)), to.stopper());
    name(exercise::kAnchorNames.at(static_cast<std::size_t>(tackle.anchor.type)), to.anchor());
    to.anchor_mass(tackle.anchor.mass);
    to.shank_length(tackle.anchor.shank_length);
    to.fluke_length(tackle.anchor.fluke_length);
    const physics::FlukeShape flukes = physics::anchor_shape(tackle.anchor).flukes;
    to.fluke_limit(flukes.hinged ? flukes.limit : 0);
    to.brake_travel_time(windlass.brake_travel_time);
    to.brake_rating(windlass.brake_rating);
    to.breaking_load(physics::breaking_load(tackle.chain));
    to.rated_pull(windlass.rated_pull);
    to.rated_speed(windlass.rated_speed);
    to.rated_current(windlass.drive == physics::DriveKind::hydraulic ? 0 : windlass.motor_current_rated);
    to.counter_fitted(aids.counter);
    to.load_cell_fitted(aids.load_cell);
}

/// m, a rectangle of the world.
struct Waters {
    double west, south, east, north;
};

Waters charted(const exercise::ExerciseDef& def) {
    const exercise::ShipStartDef& ship = def.ship_start;
    Waters waters{ship.x - kWaters, ship.y - kWaters, ship.x + kWaters, ship.y + kWaters};
    if (def.environment.ground == nullptr || !def.environment.ground->has_grid()) return waters;
    const physics::GroundDef& grid = def.environment.ground->def();
    waters.west = std::min(waters.west, grid.west);
    waters.south = std::min(waters.south, grid.south);
    waters.east = std::max(waters.east, grid.west + (grid.columns - 1) * grid.spacing);
    waters.north = std::max(waters.north, grid.south + (grid.rows - 1) * grid.spacing);
    return waters;
}

/// Soundings lie at whole steps of the world, so that a chart of the same waters has the same ones.
struct Steps {
    double first;
    std::size_t count;
};
Steps steps(double from, double to, double step) {
    const double first = std::ceil(from / step), last = std::floor(to / step);
    return {first * step, last < first ? 0 : static_cast<std::size_t>(last - first) + 1};
}

} // namespace

void describe_scene(const exercise::ExerciseDef& def, const SeatAids& aids, SceneDescription& to) {
    const physics::ObstacleMesh hull = physics::hull_mesh(def.ship, exercise::lip_clearance(def));
    to.definition_hash(exercise::definition_hash(def));
    to.length_overall(def.ship.length_overall);
    to.beam(def.ship.beam);
    to.draught(def.ship.draught);
    to.rudder_max(def.ship.rudder_max);
    put(hull, to);
    to.tackle().resize(def.tackle.size());
    for (std::size_t i = 0; i < def.tackle.size(); ++i)
        describe_tackle(def, def.tackle[i], hull, aids, to.tackle()[i]);
    to.underwater_camera(aids.underwater);
}

void describe_seabed(const exercise::ExerciseDef& def, SeabedDescription& to) {
    to = {};
    to.definition_hash(exercise::definition_hash(def));
    to.depth(def.environment.depth);
    to.soil(static_cast<Soil>(def.environment.soil));
    if (def.environment.ground == nullptr) return;
    const physics::GroundDef& ground = def.environment.ground->def();
    to.slope(ground.slope);
    // A file says where the bed goes down, the wire where it rises.
    to.slope_towards(round_the_compass(ground.slope_towards + std::numbers::pi));
    if (!def.environment.ground->has_grid()) return;
    to.origin_x(ground.west);
    to.origin_y(ground.south);
    to.spacing(ground.spacing);
    to.columns(static_cast<std::uint32_t>(ground.columns));
    to.rows(static_cast<std::uint32_t>(ground.rows));
    // A grid without heights is one of soils on an even bed.
    const std::size_t points =
        static_cast<std::size_t>(ground.columns) * static_cast<std::size_t>(ground.rows);
    if (points > kGridPoints) throw std::length_error("a ground of more points than the wire takes");
    to.heights().assign(points, 0);
    std::ranges::transform(ground.heights, to.heights().begin(),
                           [](double height) { return static_cast<float>(height); });
    to.soils().resize(ground.soils.size());
    std::ranges::transform(ground.soils, to.soils().begin(),
                           [](physics::Soil soil) { return static_cast<std::uint8_t>(soil); });
}

void draw_chart(const exercise::ExerciseDef& def, Chart& to) {
    const Waters waters = charted(def);
    double step = kSounding;
    while (steps(waters.west, waters.east, step).count * steps(waters.south, waters.north, step).count >
           kSoundings)
        step += 0.5 * kSounding;
    const Steps across = steps(waters.west, waters.east, step), up = steps(waters.south, waters.north, step);
    to.definition_hash(exercise::definition_hash(def));
    to.soundings().clear();
    for (std::size_t row = 0; row < up.count; ++row) {
        for (std::size_t column = 0; column < across.count; ++column) {
            const double x = across.first + static_cast<double>(column) * step;
            const double y = up.first + static_cast<double>(row) * step;
            Sounding& sounding = to.soundings().emplace_back();
            sounding.x(static_cast<float>(x));
            sounding.y(static_cast<float>(y));
            sounding.depth(static_cast<float>(in_steps(-physics::bed_height(def.environment, x, y), 0.1)));
            sounding.soil(static_cast<Soil>(physics::soil_at(def.environment, x, y)));
        }
    }
}

void describe_sea(const exercise::Snapshot& from, SeaState& to) {
    to.time(from.sea.ramp_begin);
    to.ramp_begin(from.sea.ramp_begin);
    to.ramp_end(from.sea.ramp_end);
    to.tide_height(from.environment.now.tide_height);
    to.components().resize(from.sea.waves.size());
    for (std::size_t i = 0; i < from.sea.waves.size(); ++i) {
        const physics::WaveComponent& wave = from.sea.waves[i];
        WaveComponent& out = to.components()[i];
        out.k_x(wave.k_x);
        out.k_y(wave.k_y);
        out.omega(wave.omega);
        out.phase(wave.phase);
        out.amplitude_before(wave.amplitude_before);
        out.amplitude_after(wave.amplitude_after);
    }
}

} // namespace windlass::perceive
