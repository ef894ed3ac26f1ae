#pragma once
// What a seat is given of the exercise: the views and events of idl/windlass.idl. docs/who_knows_what.md has
// the rules as a table.
//
// Pure functions: the same state makes the same bytes, and a state that differs only in what is hidden from a
// seat makes the same bytes, too.

#include "idl/types.hpp"
#include "server/exercise/picture/snapshot.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace windlass::perceive {

/// What an exercise fits on deck, and which aids it allows that no ship has.
struct SeatAids {
    bool counter = true, load_cell = true;               ///< fitted
    bool lining_temperature = false, underwater = false; ///< aids
};

SeatAids seat_aids(const exercise::ExerciseDef& def);

/// What gauges and ears measure against; does not change in an exercise.
struct SeatShip {
    double draught = 0;                       ///< m
    double sounder = 0;                       ///< m, echo sounder forward of midships
    double draught_at_sounder = 0;            ///< m
    std::array<double, 2> motor_full_speed{}; ///< rad/s at the shaft, by side; 0: no windlass there
};
SeatShip seat_ship(const exercise::ExerciseDef& def);

/// Fills in every field of the view. Takes memory only the first time.
void perceive_forecastle(const exercise::Snapshot& from, const exercise::TackleView& tackle,
                         const SeatShip& ship, const SeatAids& aids, ForecastleView& to);

/// What the camera on the foremast shows the bridge of one windlass: cable from spurling pipe to hawse pipe,
/// gypsy, hand-wheel, lever, clutch, stopper, smoke and flames. No gauge, no sound, nothing outboard, and not
/// where the ship is: those fields are 0. false: it shows nothing, and the view is left as it was.
bool perceive_camera(const exercise::Snapshot& from, const exercise::TackleView& tackle, ForecastleView& to);

/// Fills in every field of the view. Takes no memory.
void perceive_bridge(const exercise::Snapshot& from, const SeatShip& ship, BridgeView& to);

/// Of the model's hands beside a trainee who practises, what that seat's levers and gauges show in their
/// exercise; every other field is 0.
void perceive_forecastle_ghost(const exercise::Snapshot& hands, const exercise::TackleView& tackle,
                               const SeatShip& ship, const SeatAids& aids, ForecastleView& to);
void perceive_bridge_ghost(const exercise::Snapshot& hands, const SeatShip& ship, BridgeView& to);

/// What everybody sees of the hour and the air: the time to the minute, the visibility in two figures.
void perceive_daylight(const exercise::Snapshot& from, Daylight& to);

/// What she shows to all around her.
void perceive_lights_and_shapes(const exercise::Snapshot& from, LightsAndShapes& to);

/// The event as the seats notice it, not numbered yet; nothing when none does: a code that is not in
/// words.json is noticed by nobody.
std::optional<SeatEvent> perceive_event(const exercise::ExerciseEvent& event,
                                        const exercise::Snapshot& snapshot);

/// Whether the event is told to one seat alone, and so on that seat's topic: its briefing, its hints.
bool is_instruction(const exercise::ExerciseEvent& event);

} // namespace windlass::perceive
