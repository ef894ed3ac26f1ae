#include "server/physics/lod/catenary.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

Catenary::Catenary(const ChainDef& chain, const EnvironmentDef& environment)
    : water_(weight_in_water(chain, environment.water_density)),
      air_(weight_in_air(chain)),
      stiffness_(chain.stiffness),
      friction_(environment.bed_friction * water_),
      // The chain lies as deep in the bed as bears its weight.
      bed_(environment.depth + water_ / (environment.bed_stiffness * chain.contact_diameter)) {}

/// Tension where the height times the weight of a metre is so many newtons above a point with the given one.
double Catenary::tension_above(double tension, double weight) const {
    const double energy = tension + tension * tension / (2 * stiffness_) + weight;
    return stiffness_ * (std::sqrt(1 + 2 * energy / stiffness_) - 1);
}

Catenary::Reach Catenary::reach(double h) {
    h_ = h;
    t_surface_ = tension_above(h, water_ * depth());
    t_lip_ = tension_above(t_surface_, air_ * lip_height_);
    const auto vertical = [h](double t) { return std::sqrt(std::max(0.0, t * t - h * h)); };
    v_surface_ = vertical(t_surface_);
    v_lip_ = vertical(t_lip_);
    lying_ = length_ - v_surface_ / water_ - (v_lip_ - v_surface_) / air_;

    // How H moves the vertical pulls, then the reach of both hanging parts.
    const auto lifted = [&](double t, double v) {
        return (t * (1 + h / stiffness_) / (1 + t / stiffness_) - h) / v;
    };
    const double rise_surface = lifted(t_surface_, v_surface_), rise_lip = lifted(t_lip_, v_lip_);
    const auto sag = [&](double t, double v, double rise) {
        const double bow = std::asinh(v / h);
        return Reach{h * bow + h * v / stiffness_, bow + (rise * h - v) / t + (v + h * rise) / stiffness_};
    };
    const Reach low = sag(t_surface_, v_surface_, rise_surface), high = sag(t_lip_, v_lip_, rise_lip);

    // What lies is stretched by what friction leaves of H.
    const double pulled = std::clamp(h / friction_, 0.0, std::max(0.0, lying_));
    lying_reach_ = lying_ + (h - 0.5 * friction_ * pulled) * pulled / stiffness_;
    const double lies_less = rise_surface / water_ + (rise_lip - rise_surface) / air_;
    return {low.excess / water_ + (high.excess - low.excess) / air_ + lying_reach_ - span_,
            low.slope / water_ + (high.slope - low.slope) / air_ - lies_less + pulled / stiffness_};
}

bool Catenary::solve(double length, double span, double lip_height, double level) {
    constexpr int kMaxIterations = 60;
    constexpr double kTolerance = 1e-9; // of the span
    const Catenary last = *this;
    length_ = length, span_ = span, lip_height_ = lip_height, level_ = level;
    if (lip_height > 0 && span > 0) {
        // The reach grows with H: between slack (too short) and taut (too long) there is one root. In the
        // logarithm of H, which spans decades, it is nearly straight.
        double min = 1e-4 * water_ * depth(), max = stiffness_;
        double h = std::clamp(last.h_, min, max);
        for (int k = 0; k < kMaxIterations; ++k) {
            const Reach r = reach(h);
            if (std::abs(r.excess) < kTolerance * span) {
                if (lying_ > 0) return true;
                break;
            }
            (r.excess < 0 ? min : max) = h;
            const double next = h * std::exp(-r.excess / (r.slope * h));
            h = next > min && next < max ? next : std::sqrt(min * max);
            if (max - min < 1e-12 * max) break;
        }
    }
    *this = last;
    return false;
}

std::pair<double, double> Catenary::place_at(double s) const {
    if (s <= lying_) return {s * lying_reach_ / lying_, 0};
    const auto bow = [this](double v) { return h_ * std::asinh(v / h_) + h_ * v / stiffness_; };
    const auto energy = [this](double v) {
        const double t = std::hypot(h_, v);
        return t + t * t / (2 * stiffness_);
    };
    const double v = water_ * (s - lying_);
    if (v <= v_surface_) return {lying_reach_ + bow(v) / water_, (energy(v) - energy(0)) / water_};
    const double above = v_surface_ + air_ * (s - lying_ - v_surface_ / water_);
    return {lying_reach_ + bow(v_surface_) / water_ + (bow(above) - bow(v_surface_)) / air_,
            depth() + (energy(above) - energy(v_surface_)) / air_};
}

double Catenary::tension_at(double s) const {
    if (s <= lying_) return std::max(0.0, h_ - friction_ * (lying_ - s));
    const double v = water_ * (s - lying_);
    if (v <= v_surface_) return std::hypot(h_, v);
    return std::hypot(h_, v_surface_ + air_ * (s - lying_ - v_surface_ / water_));
}

} // namespace windlass::physics
