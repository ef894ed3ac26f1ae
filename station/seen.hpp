#pragma once
// What can be told of cable, windlass and anchor, by who looks: on the forecastle the counter, the marks and
// the load cell, all of which may deceive, and eyes and nose; the instructor has the truth beside them.

#include "station/picture.hpp"

#include <optional>
#include <string>

namespace windlass::station {

enum class Onlooker { forecastle, instructor };

/// m of cable out: the counter's reading on the forecastle, the truth for the instructor. Nothing before it
/// was heard.
std::optional<double> cable_out(const TacklePicture& tackle, Onlooker who);
/// N: what the load cell shows at the gypsy, or the pull just outboard of the lip.
double cable_load(const WindlassLoad& load, Onlooker who);
/// Of the cable's breaking load.
double load_used(const WindlassLoad& load, Onlooker who);

/// K, from which a lining smokes: where it begins to fade (practice).
inline constexpr double kSmoking = 523.15;
/// What eyes and nose say of the brake's lining, for no ship has a thermometer there: "cool" .. "FLAMES".
const char* lining_seen(const WindlassLoad& load);

/// The painted marks in sight, as they are called: "2 shackles in the water, 3 on deck (white 3+3)".
std::string marks_in_sight(const ChainState& chain);
/// Whether the length behind the innermost mark in sight has the warning colour of the last ones.
bool last_lengths_in_sight(const ChainState& chain);

/// Where the anchor is and what it does: on the forecastle as far as it is in sight, "housed", "a'cockbill",
/// "under water", "in sight, foul"; what it does on the bottom only lead and pull of the cable tell there.
std::string anchor_seen(const AnchorState& anchor, Onlooker who);

/// Whether the cable leads anywhere: with the anchor at the hawse there is none outboard to look at.
bool leads(const TacklePicture& tackle);

/// Whether an event is seen, heard or felt there. On the forecastle these are not: what the anchor does under
/// water, faults as such (what comes of them is), and what only a survey or the instructor's desk would tell.
bool noticed(const Event& event, const Picture& picture, Onlooker who);

/// "flukes 45 deg, 80 % in, sand; breaks out with 20 t; BENT 30 %".
std::string in_the_ground(const AnchorState& anchor);

} // namespace windlass::station
