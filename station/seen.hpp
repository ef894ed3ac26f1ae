#pragma once
// Words for what the views say, and for what the instructor has beside them.

#include "station/picture.hpp"

#include <string>

namespace windlass::station {

/// Who looks: one at a seat, who has its view, or the instructor, who has the truth.
enum class Onlooker { seat, instructor };

/// What eyes and nose say of the brake's lining, for no ship has a thermometer there: "cool" .. "FLAMES".
const char* words(LiningSeen lining);

/// m/s, paying out positive: by the counter, by eye where none is fitted.
double cable_speed_told(const ForecastleView& view);

/// Of the cable's breaking load.
double load_used(const ForecastleView& view);
double load_used(const WindlassLoad& load);

/// "11 o'clock, medium stay"; a cable up and down leads nowhere: "up and down".
std::string lead_and_stay(const ChainState& chain);
std::string lead_and_stay(const ForecastleView& view);

/// Whether the cable leads anywhere: with the anchor at the hawse there is none outboard to look at.
bool leads(const TacklePicture& tackle);

} // namespace windlass::station
