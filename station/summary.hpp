#pragma once
// What a run came to at one windlass: for the end of a script and for the log.

#include "station/picture.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace windlass::station {

/// SI. The largest values are those of the samples that came, 100 a second.
struct Summary {
    int side = SIDE_PORT;
    double time = 0; ///< s
    AnchorPhase anchor = ANCHOR_HOUSED;
    double cable_out = 0; ///< m
    double cable_out_shackles = 0;
    double largest_load = 0;            ///< N, at the hawse pipe
    double largest_load_time = 0;       ///< s
    double breaking_load = 0;           ///< N
    double largest_brake_load = 0;      ///< N
    double brake_rating = 0;            ///< N
    double largest_pay_out_speed = 0;   ///< m/s
    double brake_energy = 0;            ///< J
    double peak_lining_temperature = 0; ///< K
    double stretched = 0;               ///< m, by which the cable has become longer for good
    double stretch = 0;                 ///< 0..1, of the link that is stretched most
};

/// Of what has been heard so far; zeros for what has not.
Summary summarise(const Picture& picture, int side);

/// The same as far as a seat can tell, by its view.
struct SeatSummary {
    int side = SIDE_PORT;
    double time = 0;     ///< s
    ForecastleView view; ///< the last one
    SeenExtremes seen;
};
SeatSummary summarise_seat(const Picture& picture, int side);

/// Some lines for people.
std::string to_text(const Summary& summary);
std::string to_text(const SeatSummary& summary);
nlohmann::json to_json(const Summary& summary);
nlohmann::json to_json(const SeatSummary& summary);

} // namespace windlass::station
