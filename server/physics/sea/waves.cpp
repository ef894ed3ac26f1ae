#include "server/physics/sea/waves.hpp"

#include "server/physics/base/units.hpp"
#include "server/physics/sea/chance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

Chance phases_of(WaveKind kind) {
    return kind == WaveKind::swell ? Chance::swell : Chance::wind_sea;
}

/// What tells a wind sea from a swell. gamma: DNV-RP-C205 gives 3.3 for the mean of the North Sea's wind
/// seas; swell is narrower, 5 to 10 (practice). Spreading cos^n about the direction, n 2 to 4 for wind sea
/// (same source), swell 6 and more: 20 leaves it 12 degrees, root mean square.
struct Figures {
    double gamma;
    int spreading;
};
constexpr Figures figures_of(WaveKind kind) {
    return kind == WaveKind::swell ? Figures{7, 20} : Figures{3.3, 2};
}

/// Of the peak's frequency: what lies outside is 0.3 % of the energy.
constexpr double kLowest = 0.4, kHighest = 4;
constexpr int kSlices = 720; ///< of the spectrum, in the sums that cut it

/// JONSWAP's shape over frequency by the peak's, without its height.
double shape(double gamma, double x) {
    const double width = x < 1 ? 0.07 : 0.09, off = (x - 1) / width;
    const double x4 = x * x * x * x;
    return std::exp(-1.25 / x4) / (x4 * x) * std::pow(gamma, std::exp(-0.5 * off * off));
}

/// 0..1, as evenly spread, and another number than golden(): so that neither knows of the other.
double silver(int number) {
    const double x = number * (std::numbers::sqrt2 - 1);
    return x - std::floor(x);
}

/// rad off the direction, below which a share (0..1) of the energy of cos^n spreading lies.
double spread_angle(int n, double share) {
    constexpr int kSteps = 180;
    constexpr double kStep = std::numbers::pi / kSteps;
    const auto density = [=](int k) {
        double power = 1;
        for (int i = 0; i < n; ++i)
            power *= std::cos((k + 0.5) * kStep - 0.5 * std::numbers::pi);
        return power;
    };
    double whole = 0;
    for (int k = 0; k < kSteps; ++k)
        whole += density(k);
    double below = 0;
    for (int k = 0; k < kSteps; ++k) {
        const double here = density(k);
        if (below + here >= share * whole)
            return (k + (share * whole - below) / here) * kStep - 0.5 * std::numbers::pi;
        below += here;
    }
    return 0.5 * std::numbers::pi;
}

} // namespace

double wave_number(double omega, double depth) {
    const double deep = omega * omega / kGravity;
    if (deep == 0) return 0;
    // J. Guo (2002), Coastal Engineering 45, 71-74: 0.75 % off at most; Newton's method does the rest.
    const double x = omega * std::sqrt(depth / kGravity);
    double kh = x * x * std::pow(1 - std::exp(-std::pow(x, 2.4908)), -0.4015);
    for (int i = 0; i < 3; ++i) {
        const double tanh = std::tanh(kh);
        kh -= (kh * tanh - x * x) / (tanh + kh * (1 - tanh * tanh));
    }
    return kh / depth;
}

double spectral_density(const WaveTrain& train, double omega) {
    const double gamma = figures_of(train.kind).gamma;
    const double peak = 2 * std::numbers::pi / train.period;
    // Normed for 1 m to 1 % (DNV-RP-C205); the components are normed by themselves.
    return (1 - 0.287 * std::log(gamma)) * 5.0 / 16 / peak * shape(gamma, omega / peak);
}

void cut_into_components(const WaveTrain& train, double depth, std::span<WaveComponent> components) {
    const Figures figures = figures_of(train.kind);
    const double peak = 2 * std::numbers::pi / train.period;
    const auto count = static_cast<int>(components.size());
    const auto begins = [](double slice) { return kLowest + slice * (kHighest - kLowest) / kSlices; };

    // Bins of equal sums of the density's root: between equal energies, which leave nothing for the flanks
    // that a long ship answers to, and equal widths, which leave little for the peak.
    std::array<double, kSlices> density{};
    double roots = 0, energy = 0;
    for (int k = 0; k < kSlices; ++k) {
        density[static_cast<std::size_t>(k)] = shape(figures.gamma, begins(k + 0.5));
        roots += std::sqrt(density[static_cast<std::size_t>(k)]);
        energy += density[static_cast<std::size_t>(k)];
    }
    double root = 0;
    for (int i = 0, slice = 0; i < count; ++i) {
        const int first = slice;
        double of_bin = 0;
        for (; slice < kSlices && (root < (i + 1) * roots / count || i + 1 == count); ++slice) {
            root += std::sqrt(density[static_cast<std::size_t>(slice)]);
            of_bin += density[static_cast<std::size_t>(slice)];
        }
        // Somewhere about the middle of the bin's energy, so that no two periods fit into each other: no
        // record comes back. The directions are even over the spreading, whatever part of the spectrum one
        // looks at.
        double left = (0.3 + 0.4 * golden(i + 1)) * of_bin;
        int middle = first;
        while (left > density[static_cast<std::size_t>(middle)] && middle + 1 < slice)
            left -= density[static_cast<std::size_t>(middle++)];
        const double omega = peak * begins(middle + left / density[static_cast<std::size_t>(middle)]);
        const double towards = train.from + std::numbers::pi + spread_angle(figures.spreading, silver(i + 1));
        const double k = wave_number(omega, depth);
        WaveComponent& c = components[static_cast<std::size_t>(i)];
        c.k_x = k * std::sin(towards), c.k_y = k * std::cos(towards);
        c.omega = omega;
        c.phase = 2 * std::numbers::pi * chance(train.seed, phases_of(train.kind), i);
        // H = 4 sqrt(m0), and a component of amplitude a has a^2 / 2 of it.
        c.amplitude_before = c.amplitude_after = std::sqrt(2 * of_bin / energy) / 4;
    }
}

} // namespace windlass::physics
