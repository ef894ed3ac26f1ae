#pragma once
// The sea that belongs to a wind: what an instructor is offered beside the wind that he sets.

namespace windlass::station {

/// A wind sea, to tenths as it is typed: significant height m, period of the spectrum's peak s.
struct WindSea {
    double height = 0, period = 0;
};

/// The sea that a wind raises that has blown long enough over a fetch, in water of one depth.
///
/// wind_speed: m/s, mean at 10 m, from 0; fetch: m, above 0; depth: m, above 0. Source: US Army Corps of
/// Engineers, Shore Protection Manual, 4th ed. 1984, eq. 3-28a (wind-stress factor), 3-39 and 3-40 (growth
/// with the fetch in water of a depth). No sea is steeper than 1/14, at which it breaks, nor shorter than 2
/// s; one of less than 5 cm is none.
WindSea wind_sea(double wind_speed, double fetch, double depth);

} // namespace windlass::station
