#pragma once
// An exercise as data: everything that decides how it runs. Same file + same commands at the same ticks
// = the same bits.

#include "server/exercise/definition/fault_order.hpp"
#include "server/exercise/weather/weather.hpp"
#include "server/physics/anchor/anchor_def.hpp"
#include "server/physics/base/link_condition.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/contact/obstacle_mesh.hpp"
#include "server/physics/lod/model_policy.hpp"
#include "server/physics/sea/environment.hpp"
#include "server/physics/ship/hawse_pipe.hpp"
#include "server/physics/ship/ship_def.hpp"
#include "server/physics/windlass/windlass_def.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace windlass::exercise {

/// One anchor with its cable and windlass ("ground tackle"), and how it is found at the start.
struct GroundTackleDef {
    Side side = Side::port;
    physics::WindlassDef windlass;
    physics::ChainDef chain;
    physics::AnchorDef anchor;
    std::vector<physics::LinkCondition> condition; ///< of the cable, where it is not as its certificate says
    double cable_out = 5;     ///< m from the hawse pipe lip to the anchor shackle at the start
    bool anchor_home = false; ///< the anchor starts in its hawse pipe, whatever cable_out says
    double brake = 1;         ///< 0..1 lever at the start
    bool clutch_in = false;
    bool stopper_closed = false;
    /// Shackles out to an anchor that she is brought up to at the start; 0: as said above. See prelude.hpp.
    double at_anchor = 0;
};

/// Where the ship is at the start and how she moves.
struct ShipStartDef {
    double x = 0;        ///< m east, midships
    double y = 0;        ///< m north
    double heading = 0;  ///< rad clockwise from north
    double surge = 0;    ///< m/s over ground
    double sway = 0;     ///< m/s to starboard
    double yaw_rate = 0; ///< rad/s clockwise
    double turned = 0;   ///< rad clockwise, at two anchors: since she moored to them. See moor.hpp
};

/// How much the model of the cables may save.
struct ModelDef {
    bool adaptive = true; ///< links as long as the budget allows, sleeping chain, catenary; else every node
                          ///< of the chain's own node_spacing is computed in every step
};

/// Error that the model of an adaptive exercise may make: of the load, as a fraction of it, and of the
/// cable's shape, m (both root mean square). What is published of an error was measured within this budget.
inline constexpr physics::ModelError kModelBudget{.load = 0.01, .shape = 0.25};

/// What stands at the trainees' seats beside the levers, and what they are allowed to see more than on board.
struct Seats {
    // On the forecastle, of each windlass
    bool counter = true;   ///< chain counter
    bool load_cell = true; ///< gauge of the gypsy's load
    // Aids that no ship has
    bool lead_readout = false;          ///< lead and stay in figures
    bool lining_temperature = false;    ///< of the brake's lining
    bool underwater = false;            ///< a look under water
    bool alerts_without_sensor = false; ///< alerts of what no sensor of this ship measures
    bool latched_lever = false;         ///< speed lever that stays where it is put
};

/// One exercise. Plain values with working defaults.
struct ExerciseDef {
    std::string name = "let-go-port-25m";
    std::string title = "Let go the port anchor, 25 m, 6 shackles"; ///< the instructor's
    std::string title_trainee; ///< what the trainees read, which need not tell what is to come; empty: title
    int tick_rate_hz = 300;    ///< exercise steps per second; 300 gives whole ticks for 60 and 100 Hz topics
    int max_substeps = 16;     ///< of one tick, chosen from the tautest link
    ModelDef model;
    physics::EnvironmentDef environment; ///< of it, wind and current are overlaid by the weather's
    Weather weather;                     ///< at the start
    std::vector<TideRow> tide;           ///< its changes run on from the weather's; none: no tide
    Seats seats;
    physics::ShipDef ship;
    ShipStartDef ship_start;
    std::vector<GroundTackleDef> tackle{GroundTackleDef{}}; ///< one or two, different sides
    std::vector<FaultOrder> faults; ///< armed, or there, at the start; none of them clears one
    int chance_seed = 1;            ///< of the moments that are drawn for faults with a window
    /// The state that a prelude comes to, as Exercise keeps it in a checkpoint, where somebody has played it
    /// already; not part of the definition, which it follows from. Null: played when an exercise is set up.
    std::shared_ptr<const std::vector<std::uint8_t>> settled;
    /// What is seen round the anchorage, as the JSON text of the file's section (perceive reads it): it goes
    /// with the exercise wherever that goes, and nothing in a tick looks at it. Empty: open sea.
    std::string landmarks;
    /// What is taught and judged, as the JSON text of the file's section (server/assess reads it): goes as
    /// landmarks does. Empty: no lesson.
    std::string lesson;
};

/// The title that trainees read.
const std::string& title_for_trainees(const ExerciseDef& def);

/// m, by which the hull's side passes inside the hawse pipe lips: they stand out by a link's width, so that
/// chain hanging from them is clear also where the bow's side runs aslant.
double lip_clearance(const ExerciseDef& def);

/// -1 to port, 1 to starboard.
double outboard(Side side);

/// The hawse pipe of one of the tackles; hull: its ship's.
physics::HawsePipe hawse_pipe(const ExerciseDef& def, const GroundTackleDef& tackle,
                              const physics::ObstacleMesh& hull);

/// m, of water over the level bed at the start: what the waves' lengths are of.
double water_depth(const ExerciseDef& def);

/// m, of water under the bow at the start.
double depth_at_bow(const ExerciseDef& def);

/// Lays out what files do not say: of the chain from diameter and grade, of the anchor from type and mass, of
/// the bed from the soil. For a definition that comes without it.
void lay_out(ExerciseDef& def);

/// The tackle's chain with the links that the exercise computes: its own, or as long as the budget allows.
physics::ChainDef modelled_chain(const ExerciseDef& def, const GroundTackleDef& tackle);

} // namespace windlass::exercise
