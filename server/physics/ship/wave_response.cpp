#include "server/physics/ship/wave_response.hpp"

#include "server/physics/base/units.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// sin(x) / x.
double sinc(double x) {
    return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x;
}

/// 3 (sin x - x cos x) / x^3: the share of a wave's slope in that of a line as long as its ends are x off.
double slope_share(double x) {
    return std::abs(x) < 1e-2 ? 1 - x * x / 10 : 3 * (std::sin(x) - x * std::cos(x)) / (x * x * x);
}

double bump(double x, double middle, double width) {
    const double off = (x - middle) / width;
    return std::exp(-off * off);
}

double power(double x, int n) {
    double product = 1;
    for (int i = 0; i < n; ++i)
        product *= x;
    return product;
}

/// Shares of rho g a^2 / 2 on the beam (ahead) and the length (abeam): short waves are thrown back, long ones
/// pass, and between them the motions throw the most. Of a panel code's tanker (246 m, 10 m draught).
double drift_share_ahead(double wave_over_length) {
    return 0.5 / (1 + power(wave_over_length, 6)) + 0.65 * bump(wave_over_length, 0.72, 0.16);
}
double drift_share_abeam(double wave_over_heave) {
    return 0.75 / (1 + power(wave_over_heave / 1.4, 8)) + 0.35 * bump(wave_over_heave, 1.08, 0.18);
}

} // namespace

double roll_period(const ShipDef& def) {
    const double c =
        0.373 + 0.023 * def.beam / def.draught - 0.043 * std::min(def.length_overall, 400.0) / 100;
    return 2 * c * def.beam / std::sqrt(def.metacentric_height);
}

WaveResponse wave_response(const ShipDef& def, double omega, double k, double depth, double towards) {
    using Complex = std::complex<double>;
    constexpr double kPi = std::numbers::pi;
    const double length = def.length_overall, draught = def.draught;
    const double along = std::cos(towards), across = std::sin(towards);
    const double half = 0.5 * k * length * along, half_beam = 0.5 * k * def.beam * across;
    WaveResponse response;

    // Heave and pitch of a box of her displacement.
    const double deep = omega * omega / kGravity; // k in deep water: what mass and damping go by
    const double box = def.displacement / (kSeaWaterDensity * length * draught); // m, its beam
    const double radiated = 2 * std::sin(0.5 * deep * box) * std::exp(-deep * draught);
    const double damping = radiated * radiated / (deep * box), heavy = deep * draught;
    const double forcing = std::hypot(1 - heavy, damping);
    const double answer = 1 / std::hypot(1 - 2 * heavy, damping);
    // How the water's motion falls off below the surface: along the hull at the rate of the wave's length
    // along it, abeam at the wave's own.
    const double k_along = std::abs(k * along);
    const double depth_share = std::exp(-0.5 * draught * (k_along + (k - k_along) * power(across, 8)));
    const double vertical = answer * depth_share * forcing;
    response.heave = vertical * sinc(half);
    response.pitch = Complex(0, vertical * k * along * slope_share(half));

    // Surge and sway: as far as the water moves, longer in shallow water.
    const double mean_over_draught = k * draught > 1e-6 ? (1 - std::exp(-k * draught)) / (k * draught) : 1;
    const double level = mean_over_draught * sinc(half) * sinc(half_beam) / std::tanh(k * depth);
    response.surge = Complex(0, along * level);
    response.sway = Complex(0, across * level);

    // Roll: turned by the slope of the water at half draught, in the mean over the hull.
    const double tuning = omega * roll_period(def) / (2 * kPi);
    const Complex resists(1 - tuning * tuning, -2 * def.roll_damping * tuning);
    response.roll =
        Complex(0, k * across * std::exp(-0.5 * k * draught) * sinc(half) * sinc(half_beam)) / resists;

    const double wave = 2 * kPi / k, weight = 0.5 * kSeaWaterDensity * kGravity; // N/m3
    const double ahead = weight * def.beam * drift_share_ahead(wave / length);
    const double abeam = weight * length * drift_share_abeam(wave / (4 * kPi * draught));
    response.drift_surge = along * std::sqrt(ahead);
    response.drift_sway = across * std::sqrt(abeam);
    return response;
}

} // namespace windlass::physics
