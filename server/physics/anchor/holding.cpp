#include "server/physics/anchor/holding.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

/// A soil under an anchor.
struct AnchorBed {
    double setting; ///< drag until dug in, over that in sand
    double suction; ///< pull that breaks it out, over that in mud
    double sticks;  ///< weight in water of the ball of soil that comes up, over the anchor's weight
    double washes;  ///< m through the water that wash off all but 1/e of the ball
};

// Setting: 5 to 10 fluke lengths in sand, 10 to 30 and more in mud (practice); others tuned. Suction: 1 to 3
// weights in mud, less in sand (practice); the shares are tuned. The ball: tuned, clay comes home with it.
constexpr std::array<AnchorBed, 7> kBeds{{{2.5, 1.0, 0.15, 15},    // mud
                                          {1.0, 0.25, 0, 1},       // sand
                                          {1.5, 0.75, 0.30, 100},  // clay
                                          {1.25, 0.15, 0, 1},      // gravel
                                          {1.0, 0, 0, 1},          // rock
                                          {1.0, 0.1, 0, 1},        // coral
                                          {1.75, 0.6, 0.10, 10}}}; // mixed

const AnchorBed& anchor_bed(Soil soil) {
    return kBeds.at(static_cast<std::size_t>(soil));
}

constexpr double kBentLoss = 0.6; ///< of what flukes add, lost when bent all the way; tuned
/// Fluke lengths that the crown rises until the flukes are out; tuned.
constexpr double kOutOfSoil = 0.25;
/// Of the setting distance: dragged across, flukes are out after that; tuned.
constexpr double kTurnedOut = 0.5;

/// Fluke lengths slid since they were fully dug in, after which a dragging anchor holds no more than the
/// residual; tuned.
constexpr double kGivesWay = 5;

/// How far holding has gone down from its peak to the residual, 0..1.
double dragging_share(const AnchorDef& def, const HoldingState& state) {
    return std::min(1.0, state.overrun / (kGivesWay * def.fluke_length));
}

} // namespace

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
        return def.holding_rock;
    case Soil::coral:
        return def.holding_coral;
    case Soil::mixed:
        return def.holding_mixed;
    }
    return 0;
}

double setting_distance(const AnchorDef& def, Soil soil) {
    return def.setting_drag * def.fluke_length * anchor_bed(soil).setting;
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

double holding_capacity(const AnchorDef& def, Soil soil, const HoldingState& state, double uplift,
                        double poor) {
    const double weight = def.mass * kGravity;
    const double sliding = kAnchorBedFriction;
    const double dug_in = std::max(sliding, holding_factor(def, soil));
    // While dragging the ground gives no more than the residual, however deep the flukes are.
    const double residual = std::min(dug_in, std::max(sliding, def.holding_dragging));
    const double max = dug_in + (residual - dug_in) * dragging_share(def, state);
    const double sound = (1 - kBentLoss * state.bent) * (1 - poor);
    return weight * uplift_share(uplift) * (sliding + (max - sliding) * state.embedment * sound);
}

double breakout_capacity(const AnchorDef& def, Soil soil, const HoldingState& state) {
    return kAnchorSuction * anchor_bed(soil).suction * def.mass * kGravity * state.dug.norm();
}

void update_holding(const AnchorDef& def, Soil soil, const GroundMotion& motion, HoldingState& state) {
    assert(motion.dt > 0 && "a step takes time");
    const AnchorBed& bed = anchor_bed(soil);
    if (!motion.touches) {
        // What hangs on it and what is bent stays; the soil washes off on the way.
        state = {.bent = state.bent,
                 .fouled = state.fouled,
                 .ball = state.ball * std::exp(-motion.moved.norm() / bed.washes)};
        return;
    }
    constexpr double kStopped = 0.01;       // m/s
    constexpr double kDugIn = 0.99;         // as good as fully
    constexpr double kSettles = 20;         // s; tuned
    constexpr double kLostByDragging = 0.5; // of the embedment; tuned
    const Vec3 level(motion.moved.x(), motion.moved.y(), 0);
    const double way = level.norm(), setting = setting_distance(def, soil);
    state.dragged += way;

    // Flukes that point down dig in on their way ahead while the cable lies nearly flat, and come out over
    // the same distance as it is lifted or when they do not point down. Dug in across the way they turn out.
    const bool digs = motion.flukes_down && uplift_share(motion.uplift) > 0.5;
    double along = state.dug.dot(motion.shank);
    Vec3 across = state.dug - along * motion.shank;
    along += (digs ? level.dot(motion.shank) : -way) / setting;
    if (!digs) along = std::max(0.0, along);
    across *= std::max(0.0, 1 - way / (kTurnedOut * setting));
    state.dug = std::min(1.0, along) * motion.shank + across;
    // Where it digs anew it rises anew.
    if (!state.landed) state.lowest = motion.height;
    state.lowest += (motion.height - state.lowest) * std::min(1.0, way / def.fluke_length);
    state.lowest = std::min(state.lowest, motion.height);
    const double out = (motion.height - state.lowest) / (kOutOfSoil * def.fluke_length);
    const double max = std::clamp(1 - out, 0.0, 1.0);
    if (const double length = state.dug.norm(); length > max) state.dug *= max / length;
    state.embedment = std::clamp(state.dug.dot(motion.shank), 0.0, 1.0);
    state.landed = true;

    if (state.embedment > kDugIn) state.overrun += way;
    if (way < kStopped * motion.dt && state.overrun > 0) {
        // What has dragged and stops comes to hold again, but must dig in again.
        const double share = dragging_share(def, state);
        state.overrun *= std::max(0.0, 1 - motion.dt / kSettles);
        const double left = 1 - kLostByDragging * (share - dragging_share(def, state));
        state.dug *= left;
        state.embedment *= left;
    }
    state.dragging = dragging_share(def, state) > 0.5;
    state.ball = std::max(state.ball, bed.sticks * def.mass * kGravity * state.dug.norm());
}

template <class Visitor, StateOf<HoldingState> State>
void visit_state(Visitor& v, State& state) {
    auto& [landed, dug, embedment, lowest, dragged, overrun, dragging, bent, fouled, ball] = state;
    WINDLASS_STATE(v, landed, dug, embedment, lowest, dragged, overrun, dragging, bent, fouled, ball);
    WINDLASS_WITHIN(v, -1.01, 1.01, dug);
    WINDLASS_WITHIN(v, 0, 1, embedment, bent, fouled);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, lowest, dragged, overrun);
    WINDLASS_WITHIN(v, 0, kStrongest, ball);
}
WINDLASS_STATE_LISTED(HoldingState);

} // namespace windlass::physics
