#pragma once
// Wind about its mean: gusts of speed and swings of direction, by a spectrum.

#include <array>
#include <cstdint>

namespace windlass::physics {

/// The wind of ten minutes.
struct WindDef {
    double speed = 0;       ///< m/s, mean
    double from = 0;        ///< rad clockwise from north, where it blows from
    double gust_factor = 1; ///< largest of 3 s over the mean, in the mean of many ten minutes; 1: no gusts
    double gust_period = 0; ///< s, of the spectrum's peak (of f S over log f); 0: the spectrum's own
    std::uint32_t seed = 1; ///< of the phases
    bool operator==(const WindDef&) const = default;
};

/// As it blows at an instant.
struct WindNow {
    double speed = 0; ///< m/s
    double from = 0;  ///< rad
};

/// A function of wind and time alone; what it keeps follows from them. Takes no memory.
///
/// Spectrum: NPD (ISO 19901-1, annex A), from ten minutes to 10 s: faster gusts are smaller than a ship. As
/// strong as the gust factor asks. The direction swings with 3/4 of the intensity, at other phases: crosswise
/// turbulence over that along the wind (practice).
class Gusts {
public:
    WindNow wind(const WindDef& mean, double t);

private:
    static constexpr std::size_t kWaves = 24;
    void make(const WindDef& mean);

    WindDef made_of_;
    std::array<double, kWaves> omega_{}, along_{}, phase_{}, phase_across_{}; ///< along: m/s
};

} // namespace windlass::physics
