#pragma once
// An exercise as data: everything that decides how it runs. Same file + same commands at the same ticks
// = the same bits.

#include "server/physics/anchor_def.hpp"
#include "server/physics/chain_def.hpp"
#include "server/physics/environment.hpp"
#include "server/physics/ship_def.hpp"
#include "server/physics/windlass_def.hpp"

#include <string>
#include <vector>

namespace windlass::exercise {

/// Which cable.
enum class Side { port = 0, starboard = 1 };

/// One anchor with its cable and windlass ("ground tackle"), and how it is found at the start.
struct GroundTackleDef {
    Side side = Side::port;
    physics::WindlassDef windlass;
    physics::ChainDef chain;
    physics::AnchorDef anchor;
    double cable_out = 5; ///< m from the hawse pipe lip to the anchor shackle at the start
    double brake = 1;     ///< 0..1 lever at the start
    bool clutch_in = false;
    bool stopper_closed = false;
};

/// Where the ship is at the start and how she moves.
struct ShipStartDef {
    double x = 0;        ///< m east, midships
    double y = 0;        ///< m north
    double heading = 0;  ///< rad clockwise from north
    double surge = 0;    ///< m/s over ground
    double sway = 0;     ///< m/s to starboard
    double yaw_rate = 0; ///< rad/s clockwise
};

/// One exercise. Plain values with working defaults.
struct ExerciseDef {
    std::string name = "let-go-port-25m";
    std::string title = "Let go the port anchor, 25 m, 6 shackles";
    int tick_rate_hz = 300; ///< exercise steps per second; 300 gives whole ticks for 60 and 100 Hz topics
    int max_substeps = 16;  ///< of one tick, chosen from the tautest link
    physics::EnvironmentDef environment;
    physics::ShipDef ship;
    ShipStartDef ship_start;
    std::vector<GroundTackleDef> tackle{GroundTackleDef{}}; ///< one or two, different sides
};

} // namespace windlass::exercise
