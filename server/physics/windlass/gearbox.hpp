#pragma once
// The gear between prime mover and gypsy: teeth and bearings take a share of what goes through, whichever way
// it goes. Pulls in N at the gypsy's pitch line, heaving positive.

namespace windlass::physics {

inline constexpr double kGearRatio = 100;       ///< motor revolutions to one of the gypsy
inline constexpr double kGearEfficiency = 0.88; ///< -, motor drives: four steps of spur gear at 0.97; tuned
inline constexpr double kGearEfficiencyBack = 0.85; ///< -, chain drives; tuned

/// Shares of the pull that come through.
struct Gearbox {
    double efficiency = 1;      ///< prime mover drives the gypsy
    double efficiency_back = 1; ///< chain drives the prime mover

    /// Pull at the gypsy while chain runs out, from the prime mover's: it is driven when it pulls back.
    double paying_out(double motor) const { return motor > 0 ? motor / efficiency_back : motor * efficiency; }
    /// Pull at the gypsy while chain comes in.
    double heaving_in(double motor) const { return motor > 0 ? motor * efficiency : motor / efficiency_back; }
};

} // namespace windlass::physics
