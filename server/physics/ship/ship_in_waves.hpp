#pragma once
// A ship in a sea: the sum of what its waves do to her, where she is and as she heads.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/base/vec3.hpp"
#include "server/physics/sea/sea_surface.hpp"
#include "server/physics/ship/ship_def.hpp"

#include <array>

namespace windlass::physics {

/// What waves add at an instant to a ship's place in the plane, in her own axes, and the drift that they push
/// her with. All 0 in still water.
struct WaveMotion {
    double surge = 0, sway = 0, heave = 0;                   ///< m, forward, to starboard, up
    double roll = 0, pitch = 0;                              ///< rad, starboard down, bow up
    double surge_speed = 0, sway_speed = 0, heave_speed = 0; ///< m/s
    double roll_rate = 0, pitch_rate = 0;                    ///< rad/s
    double drift_ahead = 0, drift_abeam = 0;                 ///< N, forward, to starboard
};
template <class Visitor, StateOf<WaveMotion> State>
void visit_state(Visitor& v, State& motion);

/// A place in the plane for ShipInWaves: m, world; m/s over ground, world; rad clockwise from north.
struct ShipPlace {
    double x = 0, y = 0, heading = 0;
    double east = 0, north = 0; ///< m/s
};

/// Adds up responses. Those of the headings next to hers are kept, and gone between in straight lines: a
/// function of sea, time, place and heading alone, so that nothing of it is state. Takes no memory.
///
/// Drift, mean and slowly varying: J. N. Newman (1974), of the products of two waves the mean of what each
/// does alone, in the form that has no waves of the sum's frequency: a sum's square, by directions ahead,
/// astern, port and starboard.
class ShipInWaves {
public:
    ShipInWaves(const ShipDef& def, double depth) : def_(def), depth_(depth) {}

    /// Of a ship at a place at t (s). Of one sea, always the same.
    WaveMotion motion(const SeaSurface& sea, const ShipPlace& ship, double t);

private:
    /// Of one heading, all waves: in ship's axes, starboard positive.
    struct Responses {
        std::array<double, kMaxWaveComponents> surge, sway, heave, pitch, roll, roll_behind, ahead, abeam;
    };
    void respond(const SeaSurface& sea, double heading, Responses& to) const;

    ShipDef def_;
    double depth_;
    unsigned made_ = 0; ///< the sea's, of which the responses are; 0: none yet
    int cell_ = 0;      ///< of the headings between which hers is
    Responses low_{}, high_{};
};

} // namespace windlass::physics
