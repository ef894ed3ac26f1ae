#include "server/physics/holding.hpp"

#include <algorithm>
#include <array>

namespace windlass::physics {

double holding_factor(const AnchorDef& def, Soil soil) {
    switch (soil) {
    case Soil::mud:
        return def.holding_mud;
    case Soil::sand:
        return def.holding_sand;
    case Soil::clay:
        return def.holding_clay;
    case Soil::gravel:
        return def.holding_gravel;
    case Soil::rock:
    case Soil::coral: // as unreliable; tuned
        return def.holding_rock;
    case Soil::mixed:
        return 0.5 * (def.holding_mud + def.holding_sand);
    }
    return 0;
}

double uplift_share(double uplift) {
    struct Point {
        double degrees, share;
    };
    static constexpr std::array<Point, 5> kPoints{{{0, 1}, {5, 0.75}, {15, 0.5}, {30, 0.2}, {60, 0}}};
    const double degrees = degrees_from_radians(uplift);
    if (degrees <= 0) return 1;
    for (std::size_t i = 1; i < kPoints.size(); ++i) {
        const Point &a = kPoints[i - 1], &b = kPoints[i];
        if (degrees < b.degrees) {
            return a.share + (b.share - a.share) * (degrees - a.degrees) / (b.degrees - a.degrees);
        }
    }
    return 0;
}

double holding_capacity(const AnchorDef& def, Soil soil, const HoldingState& state, double uplift) {
    const double weight = def.mass * kGravity;
    const double sliding = def.bed_friction;
    const double dug_in = std::max(sliding, holding_factor(def, soil));
    // While dragging the ground gives no more than the residual, however deep the flukes are.
    const double most = state.dragging ? std::min(dug_in, def.holding_dragging) : dug_in;
    return weight * uplift_share(uplift) * (sliding + (most - sliding) * state.embedment);
}

void update_holding(const AnchorDef& def, HoldingState& state, bool on_bottom, double moved, double dt,
                    double uplift) {
    if (!on_bottom) {
        state = {};
        return;
    }
    constexpr double kStopped = 0.01;       // m/s
    constexpr double kResetEmbedment = 0.5; // a dragged anchor that stops holds, but must dig in again; tuned
    state.landed = true;
    state.dragged += moved;
    // Flukes dig in while the shank lies nearly flat, and come out as it is lifted, over the same distance.
    const double setting = def.setting_drag * def.fluke_length;
    const double sense = uplift_share(uplift) > 0.5 ? 1 : -1;
    state.embedment = std::clamp(state.embedment + sense * moved / setting, 0.0, 1.0);

    if (moved < kStopped * dt) {
        if (state.dragging) state.embedment = std::min(state.embedment, kResetEmbedment);
        state.dragging = false;
        state.overrun = 0;
    } else if (state.embedment >= 1) {
        state.overrun += moved;
        if (state.overrun > def.fluke_length) state.dragging = true;
    }
}

} // namespace windlass::physics
