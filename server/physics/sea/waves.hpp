#pragma once
// Long-crested waves that add up to a sea: what a spectrum is cut into.

#include <cstdint>
#include <span>

namespace windlass::physics {

/// One of them, as on the wire: eta = a cos(k_x x + k_y y - omega t + phase), m above z = 0, at x, y (m,
/// world) and t (s, exercise time); a goes from before to after in a straight line while the sea changes.
struct WaveComponent {
    double k_x = 0, k_y = 0;     ///< rad/m
    double omega = 0;            ///< rad/s
    double phase = 0;            ///< rad, at t = 0
    double amplitude_before = 0; ///< m
    double amplitude_after = 0;  ///< m
};

/// What wind raises on the spot, or what came from elsewhere: how narrow it is in period and direction.
enum class WaveKind { wind_sea, swell };

/// One train of waves, without its height.
struct WaveTrain {
    WaveKind kind = WaveKind::wind_sea;
    double period = 6;      ///< s, of the spectrum's peak
    double from = 0;        ///< rad clockwise from north, where it comes from
    std::uint32_t seed = 1; ///< of the phases, and of nothing else
};

/// How many components a train is cut into. Twice both, for a sea that gives way to another, is what a sample
/// of the surface takes: 64.
inline constexpr int kSeaComponents = 18, kSwellComponents = 14;
constexpr int components_of(WaveKind kind) {
    return kind == WaveKind::swell ? kSwellComponents : kSeaComponents;
}

/// rad/m, of a wave of so many rad/s in water of a depth (m): omega^2 = g k tanh k h.
double wave_number(double omega, double depth);

/// m2 s, spectral density of the elevation at omega (rad/s) of a train of significant height 1 m: JONSWAP,
/// with gamma 3.3 for a wind sea and 7 for a swell.
double spectral_density(const WaveTrain& train, double omega);

/// The components of a train of significant height 1 m in water of a depth (m), components_of(train.kind) of
/// them: amplitude_before and amplitude_after both the amplitude. Their variance is that of the height,
/// exactly.
void cut_into_components(const WaveTrain& train, double depth, std::span<WaveComponent> components);

} // namespace windlass::physics
