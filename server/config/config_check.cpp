#include "server/config/config_check.hpp"

#include "common/json_file.hpp"
#include "server/assess/lesson.hpp"
#include "server/config/config_faults.hpp"
#include "server/config/config_ground.hpp"
#include "server/config/config_landmarks.hpp"
#include "server/config/field_json.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/moor.hpp"
#include "server/physics/ship/hull_surface.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace windlass::config {
namespace {

/// Nodes of one cable that a ChainState sample can carry (bound in windlass.idl).
constexpr double kNodesOnTheWire = 2048;

/// Pitch radius of a gypsy for chain of diameter d: five pockets, 40 d a revolution, so 6.37 d. Makers differ
/// by a few per cent; outside these bounds the links do not sit in the pockets.
constexpr double kGypsyRadiusMin = 5.7, kGypsyRadiusMax = 7.2;

constexpr double kRounding = 1e-6; ///< m

class Faults {
public:
    void require(bool holds, const std::string& pointer, double value, const std::string& allowed) {
        if (!holds) lines.push_back(fmt::format("{}: {} is not allowed: {}", pointer, value, allowed));
    }
    std::vector<std::string> lines;
};

/// m, under the keel's line at the start.
double min_depth_under(const exercise::ExerciseDef& def) {
    const physics::Vec3 ahead = physics::compass(def.ship_start.heading);
    double min = 1e300;
    constexpr int kHalf = 10; // places on either side of midships
    for (int k = -kHalf; k <= kHalf; ++k) {
        const physics::Vec3 at = 0.5 * k / kHalf * def.ship.length_overall * ahead;
        min = std::min(
            min, -physics::bed_height(def.environment, def.ship_start.x + at.x(), def.ship_start.y + at.y()));
    }
    return min + def.weather.tide_height;
}

void check_ship(const exercise::ExerciseDef& def, Faults& faults) {
    const physics::ShipDef& ship = def.ship;
    const double depth = min_depth_under(def);
    faults.require(std::abs(ship.trim) <= ship.draught, "/ship/trim", ship.trim,
                   fmt::format("within the draught, {} m", ship.draught));
    const double deepest = ship.draught + 0.5 * std::abs(ship.trim);
    faults.require(depth > deepest, def.environment.ground ? "/environment/ground" : "/environment/depth",
                   depth, fmt::format("above the ship's draught, {} m: she would be aground", deepest));
    faults.require(ship.length_pp <= ship.length_overall, "/ship/length_pp", ship.length_pp,
                   fmt::format("at most length_overall, {} m", ship.length_overall));
    const double box = physics::kSeaWaterDensity * ship.length_pp * ship.beam * ship.draught;
    constexpr double kFinest = 0.35, kFullest = 0.95; // block coefficients of ships
    faults.require(ship.displacement >= kFinest * box && ship.displacement <= kFullest * box,
                   "/ship/displacement", ship.displacement,
                   fmt::format("from {:.4g} to {:.4g} kg: {} to {} of length_pp x beam x draught",
                               kFinest * box, kFullest * box, kFinest, kFullest));
    faults.require(ship.hawse_forward <= ship.length_overall / 2, "/ship/hawse_forward", ship.hawse_forward,
                   fmt::format("at most half the ship's length, {} m", ship.length_overall / 2));
    faults.require(ship.hawse_outboard <= ship.beam / 2, "/ship/hawse_outboard", ship.hawse_outboard,
                   fmt::format("at most half the ship's beam, {} m", ship.beam / 2));
    const double clearance = exercise::lip_clearance(def);
    const double min = physics::side_at_lip(ship, clearance) + clearance;
    faults.require(ship.hawse_outboard >= min - kRounding, "/ship/hawse_outboard", ship.hawse_outboard,
                   fmt::format("at least {:.2f} m, {} m forward of midships: inside the hull's side the lip "
                               "would be in the ship",
                               std::ceil(100 * min) / 100, ship.hawse_forward));
}

void check_current(const exercise::ExerciseDef& def, Faults& faults) {
    const auto& profile = def.weather.current_profile;
    for (std::size_t i = 1; i < profile.size(); ++i)
        faults.require(
            profile[i].depth > profile[i - 1].depth, fmt::format("/environment/current_profile/{}/depth", i),
            profile[i].depth,
            fmt::format("below the layer before it, {} m: the list goes down", profile[i - 1].depth));
}

void check_weather(const exercise::ExerciseDef& def, Faults& faults) {
    const exercise::Weather& weather = def.weather;
    for (std::size_t i = 1; i < def.tide.size(); ++i)
        faults.require(def.tide[i].time > def.tide[i - 1].time, fmt::format("/environment/tide/{}/time_h", i),
                       def.tide[i].time / kHour,
                       fmt::format("after the row before it, {} h", def.tide[i - 1].time / kHour));
    // What the schema sees to in a file; a definition may come from elsewhere.
    faults.require(weather.tide_height >= exercise::kTideMin && weather.tide_height <= exercise::kTideMax,
                   "/environment/tide_height", weather.tide_height,
                   fmt::format("from {} to {} m", exercise::kTideMin, exercise::kTideMax));
    const auto waves = [&](const std::string& name, double height, double period) {
        const double least = exercise::least_wave_period(height);
        faults.require(period >= least, "/environment/" + name + "_period", period,
                       fmt::format("at least {:.1f} s for a height of {} m: steeper waves break",
                                   std::ceil(10 * least) / 10, height));
        constexpr double kBreaks = 0.5; // of the depth, significant
        faults.require(
            height <= kBreaks * exercise::water_depth(def), "/environment/" + name + "_height", height,
            fmt::format("at most half the depth, {} m: higher waves break", exercise::water_depth(def)));
    };
    waves("wave", weather.wave_height, weather.wave_period);
    waves("swell", weather.swell_height, weather.swell_period);
}

void check_windlass(const physics::WindlassDef& windlass, const std::string& at, Faults& faults) {
    faults.require(windlass.stall_pull >= windlass.rated_pull, at + "/stall_pull", windlass.stall_pull,
                   fmt::format("at least rated_pull, {} N", windlass.rated_pull));
    faults.require(windlass.light_line_speed >= windlass.rated_speed, at + "/light_line_speed",
                   windlass.light_line_speed,
                   fmt::format("at least rated_speed, {} m/s", windlass.rated_speed));
    if (windlass.drive == physics::DriveKind::electric_pole_changing) {
        faults.require(windlass.light_line_speed > 2 * windlass.rated_speed, at + "/light_line_speed",
                       windlass.light_line_speed,
                       fmt::format("above {} m/s, twice rated_speed: the middle winding turns at half of it",
                                   2 * windlass.rated_speed));
    }
}

void check_condition(const exercise::GroundTackleDef& tackle, const std::string& at, Faults& faults) {
    for (std::size_t i = 0; i < tackle.condition.size(); ++i) {
        const physics::LinkCondition& piece = tackle.condition[i];
        const std::string here = fmt::format("{}/condition/{}", at, i);
        faults.require(piece.ends >= piece.begins, here + "/ends", piece.ends,
                       fmt::format("at least begins, {} m: counted from the anchor shackle", piece.begins));
        faults.require(piece.ends <= tackle.chain.length, here + "/ends", piece.ends,
                       fmt::format("at most the chain's length, {} m", tackle.chain.length));
    }
}

void check_tackle(const exercise::GroundTackleDef& tackle, const std::string& at, Faults& faults) {
    const physics::ChainDef& chain = tackle.chain;
    check_windlass(tackle.windlass, at + "/windlass", faults);
    check_condition(tackle, at, faults);
    const double min = kGypsyRadiusMin * chain.diameter, max = kGypsyRadiusMax * chain.diameter;
    faults.require(
        tackle.windlass.gypsy_radius >= min && tackle.windlass.gypsy_radius <= max,
        at + "/windlass/gypsy_radius", tackle.windlass.gypsy_radius,
        fmt::format("from {:.3g} to {:.3g} m, to fit chain of {} m diameter", min, max, chain.diameter));
    faults.require(chain.length / chain.node_spacing + 2 <= kNodesOnTheWire, at + "/chain/node_spacing",
                   chain.node_spacing,
                   fmt::format("at least {:.3g} m for a chain of {} m: no more than {} nodes",
                               chain.length / (kNodesOnTheWire - 2), chain.length, kNodesOnTheWire));
    const double inboard = tackle.windlass.hawse_pipe_length + tackle.windlass.locker_lift;
    faults.require(tackle.cable_out <= chain.length - inboard, at + "/cable_out", tackle.cable_out,
                   fmt::format("at most {} m: the chain's length, {} m, less {} m between hawse pipe lip and "
                               "locker",
                               chain.length - inboard, chain.length, inboard));
}

/// Cable drawn up the pipe by more than the anchor, home, lets it.
void check_stowage(const exercise::ExerciseDef& def, const exercise::GroundTackleDef& tackle,
                   const std::string& at, Faults& faults) {
    if (tackle.anchor_home || tackle.cable_out > 0) return;
    const physics::ObstacleMesh hull = physics::hull_mesh(def.ship, exercise::lip_clearance(def));
    const double home = exercise::hawse_pipe(def, tackle, hull).cable_at_home();
    faults.require(tackle.cable_out >= home - kRounding, at + "/cable_out", tackle.cable_out,
                   fmt::format("at least {:.2f} m: there the anchor is home, {} m of its shank up the pipe",
                               std::ceil(100 * home) / 100, std::floor(-100 * home) / 100));
}

/// An anchor that starts below the lip hangs there: cable that lies on the bottom comes of at_anchor alone.
void check_hang(const exercise::ExerciseDef& def, const exercise::GroundTackleDef& tackle,
                const std::string& at, Faults& faults) {
    if (tackle.anchor_home || tackle.at_anchor > 0) return;
    const double height = exercise::depth_at_bow(def) + def.ship.hawse_height;
    const double clear = height - tackle.anchor.shank_length;
    faults.require(
        tackle.cable_out <= clear, at + "/cable_out", tackle.cable_out,
        fmt::format("at most {:.1f} m: there the anchor hangs clear of the bottom, {:.1f} m below the lip; "
                    "a ship that lies to her cable has at_anchor",
                    std::floor(10 * clear) / 10, height));
}

/// She lies to one cable or two, which something holds, and which are long enough to lie on the bottom.
void check_start_at_anchor(const exercise::ExerciseDef& def, Faults& faults) {
    constexpr double kScope = 2;   ///< cable over the height from lip to bottom, at least
    constexpr double kHolds = 0.9; ///< lever of a brake that holds
    const double height = exercise::depth_at_bow(def) + def.ship.hawse_height;
    for (std::size_t i = 0; i < def.tackle.size(); ++i) {
        const exercise::GroundTackleDef& tackle = def.tackle[i];
        if (tackle.at_anchor == 0) continue;
        const std::string at = fmt::format("/tackle/{}", i), here = at + "/at_anchor";
        const double out = physics::metres_from_shackles(tackle.at_anchor),
                     inboard = tackle.windlass.hawse_pipe_length + tackle.windlass.locker_lift;
        faults.require(out >= kScope * height, here, tackle.at_anchor,
                       fmt::format("at least {:.1f} shackles: twice the {} m from lip to bottom",
                                   physics::shackles_from_metres(kScope * height), height));
        faults.require(out <= tackle.chain.length - inboard, here, tackle.at_anchor,
                       fmt::format("at most {:.1f} shackles: the cable on board",
                                   physics::shackles_from_metres(tackle.chain.length - inboard)));
        faults.require(!tackle.clutch_in, at + "/clutch_in", 1, "false: she lies to brake or stopper");
        faults.require(!tackle.anchor_home, at + "/anchor_home", 1, "false: the anchor is on the bottom");
        faults.require(tackle.stopper_closed || tackle.brake >= kHolds, at + "/brake", tackle.brake,
                       fmt::format("at least {}, or stopper_closed: something holds the cable", kHolds));
    }
    if (!exercise::moored(def)) {
        faults.require(def.ship_start.turned == 0, "/ship_start/turned_deg",
                       physics::degrees_from_radians(def.ship_start.turned),
                       "0: she has turned between two anchors only, where both cables have at_anchor");
        return;
    }
    const exercise::GroundTackleDef& first = def.tackle[0];
    const double second = def.tackle[1].at_anchor;
    const double on_board = physics::shackles_from_metres(
        first.chain.length - first.windlass.hawse_pipe_length - first.windlass.locker_lift);
    faults.require(first.at_anchor <= on_board - second, "/tackle/0/at_anchor", first.at_anchor,
                   fmt::format("at most {:.1f} shackles: she moors by the first cable, veered over its own "
                               "length and the second one's, {}",
                               on_board - second, second));
}

/// Texts that no checkpoint could keep.
void check_texts(const exercise::ExerciseDef& def, Faults& faults) {
    for (const auto& [at, text] :
         {std::pair("/landmarks", &def.landmarks), std::pair("/lesson", &def.lesson)})
        faults.require(text->size() <= exercise::kMaxText, at, static_cast<double>(text->size()),
                       fmt::format("at most {} bytes of JSON", exercise::kMaxText));
}

/// Names that lead nowhere, figures that do not go together: what the lesson's schema cannot say.
void check_lesson(const exercise::ExerciseDef& def, Faults& faults) {
    if (def.lesson.empty()) return;
    std::vector<int> sides;
    for (const exercise::GroundTackleDef& tackle : def.tackle)
        sides.push_back(static_cast<int>(tackle.side));
    try {
        assess::read_lesson(def.lesson, sides);
    } catch (const ConfigError& error) {
        std::istringstream lines(error.what());
        for (std::string line; std::getline(lines, line);)
            faults.lines.push_back(line);
    }
}

} // namespace

std::vector<std::string> physical_faults(const exercise::ExerciseDef& def) {
    Faults faults;
    check_ship(def, faults);
    check_current(def, faults);
    check_weather(def, faults);
    for (const std::string& fault : ground_faults(def.environment))
        faults.lines.push_back(fault);
    check_texts(def, faults);
    for (const std::string& fault : landmark_faults(def.landmarks))
        faults.lines.push_back(fault);
    for (const std::string& fault : order_faults(def))
        faults.lines.push_back(fault);
    check_start_at_anchor(def, faults);
    for (std::size_t i = 0; i < def.tackle.size(); ++i) {
        const std::string at = "/tackle/" + std::to_string(i);
        check_tackle(def.tackle[i], at, faults);
        check_stowage(def, def.tackle[i], at, faults);
        check_hang(def, def.tackle[i], at, faults);
        const double depth = exercise::depth_at_bow(def);
        faults.require(depth < def.tackle[i].chain.length, "/environment/depth", depth,
                       fmt::format("less than the chain of {}, {} m: the anchor could not reach the bottom",
                                   at, def.tackle[i].chain.length));
    }
    check_lesson(def, faults);
    if (def.tackle.size() == 2 && def.tackle[0].side == def.tackle[1].side)
        faults.lines.push_back(
            "/tackle/1/side: the same as /tackle/0/side is not allowed: one entry for each "
            "side, \"port\" and \"starboard\"");
    return faults.lines;
}

} // namespace windlass::config
