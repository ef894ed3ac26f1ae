// How much of the cable is modelled: what sleeps, what is left to the catenary, how long the steps are.

#include "server/physics/tackle/ground_tackle.hpp"

#include "server/physics/lod/catenary_spring.hpp"
#include "server/physics/sea/ground.hpp"
#include "server/physics/solver/chain_substeps.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

/// Nothing is saved: every node moves.
void GroundTackle::wake() {
    if (quiet_ && quiet_->state().active) quiet_->give_back(chain_);
    if (sleep_ && chain_.asleep > 0) sleep_->wake(chain_);
}

/// The step of a cable that is left to the catenary. False when it is not, or no longer is: the ship moves
/// too fast, the chain on the bottom would stir, or the windlass does not hold the pull; then the cable is
/// dynamic again, at the start of this step.
bool GroundTackle::lie_quietly(const EnvironmentDef& environment, const EquipmentFaults& causes, double dt,
                               const DriveLine& drive, const Vec3& lip) {
    if (!quiet_ || !quiet_->state().active) return false;
    const int foot = chain_.asleep;
    bool holds = sleep_->rest(environment, dt, chain_) &&
                 quiet_->follow(environment, chain_, dt, lip, sleep_->state().holds);
    if (chain_.asleep != foot) {
        sleep_->move_end(environment, anchor_at_rest(environment), chain_.asleep, chain_);
        holds = holds && chain_.asleep > 0;
    }
    // The windlass meets the pull as it is, as stiff as the chain itself.
    const TopLink link{.dt = dt, .pull = quiet_->tension(), .yielding = setup_.chain.stiffness};
    const DeckResult deck = drive.result(link);
    if (!holds || deck.speed != 0 || causes.cable_slipped > 0) {
        quiet_->give_back(chain_);
        return false;
    }
    windlass_.settle(dt, deck, causes, nullptr);
    follow_load(deck.hawse_tension, false, dt, recent_load_);
    pull_on_ship_ = quiet_->pull();
    hull_load_ = {};
    return true;
}

AnchorAtRest GroundTackle::anchor_at_rest(const EnvironmentDef& environment) const {
    constexpr double kStill = 2e-3; // m/s, as for the chain
    const HoldingState& holding = anchor_.holding();
    const bool still = holding.landed && !holding.dragging && anchor_.shackle_velocity().norm() < kStill;
    if (chain_.asleep == 0 && !still) return {};
    return {true, anchor_.holding_power(environment, shackle_pull(environment))};
}

/// After a dynamic step: who may sleep, and whether the catenary will do.
void GroundTackle::save_work(const EnvironmentDef& environment, double dt) {
    assert(sleep_ && quiet_ && "nothing is saved without a budget");
    const AnchorAtRest anchor = anchor_at_rest(environment);
    if (sleep_->watch(environment, anchor, dt, chain_)) anchor_.set_motion(Vector6::Zero());

    const WindlassState& windlass = windlass_.state();
    // The catenary knows a level bed only; on any other the cable stays dynamic.
    const bool at_rest =
        !environment.ground && chain_.asleep > 0 && windlass.cable_speed == 0 && hull_load_.borne == 0;
    const int foot = quiet_->agrees(environment, chain_, dt, pull_on_ship_, at_rest);
    if (foot > 0) {
        sleep_->move_end(environment, anchor, foot, chain_);
        quiet_->take_over();
    }
}

ModelLevel GroundTackle::level() const {
    if (quiet_ && quiet_->state().active) return ModelLevel::catenary;
    return chain_.asleep > 0 ? ModelLevel::dynamic_with_sleep : ModelLevel::dynamic;
}

namespace {

// Measured as the constants of recent_load.cpp, on the same anchorings.
constexpr double kPlacePerHeight = 0.0065; ///< m, where the anchor comes to lie, for each m it is lowered
constexpr double kPlacePerDragged = 0.015; ///< m, the shape for each m that it has dragged

/// What it makes that the anchor lies elsewhere than it would with finer links and steps: the pull answers by
/// the catenary's spring. As far as it drags, the soil decides the pull, and the shape alone differs more.
ModelError place_error(const ChainDef& chain, const EnvironmentDef& environment, const Vec3& lip,
                       double dragged, double pull) {
    const double height = height_over_bed(environment, lip);
    const double w = weight_in_water(chain, environment.water_density);
    const double place = kPlacePerHeight * height;
    return {place * catenary_spring(w, height, pull) / std::max(pull, w * height),
            std::hypot(place, kPlacePerDragged * dragged)};
}

} // namespace

ModelError GroundTackle::error(const EnvironmentDef& environment) const {
    // The further it drags the less it holds, and whether it stops in this swell or the next is decided by
    // what no two computations share. On the brake they meet again when it holds (no worse covered than the
    // rest of the run, docs/physics.md); while the cable comes in they do not. Nor do they where cable over
    // it pulls it crown first: when it turns round is not shared either, and it comes to lie metres
    // elsewhere.
    if (luck_decides_) return kNotEstimated;
    ModelError full = together(spacing_error_, unsteady_error(recent_load_));
    const HoldingState& holding = anchor_.holding();
    if (holding.landed && chain_.parted < 0)
        full = together(full, place_error(setup_.chain, environment, chain_.position.at(chain_.links),
                                          holding.dragged, recent_load_.mean));
    if (!sleep_) return full;
    const ModelError lying = sleep_->error(environment, chain_);
    return together(full, quiet_->state().active ? together(quiet_->state().error, lying) : lying);
}

int GroundTackle::substeps(double dt, int max) {
    assert(dt > 0 && max >= 1 && "some time, in one substep at least");
    if (level() == ModelLevel::catenary) return 1;
    const Substeps steps = chain_substeps(setup_.chain, chain_, dt, max);
    too_long_ = !steps.enough;
    if (too_long_) counts_.capped += static_cast<std::uint64_t>(steps.count);
    return steps.count;
}

void GroundTackle::hurry() {
    too_long_ = true;
    ++counts_.capped;
}

int GroundTackle::stride(double dt) const {
    assert(dt > 0 && "a tick takes time");
    constexpr double kLongest = 0.01; // s; the load is published a hundred times a second
    constexpr double kRuns = 0.5;     // m/s; cable that runs is looked at in every tick
    constexpr double kSure = 0.7;     // of the step that the waves allow, to begin with longer steps
    // m/s, of an anchor that may touch ship or bottom: one that falls over or runs is stepped as finely as
    // the ground's hard contact wants. Error of the load over the whole with 2, 16 and 60 cm/s: 0.76, 0.49
    // and 0.67 % in 25 m of sand, 0.58, 0.60 and 1.63 in 18 m of gravel, 0.69, 0.67 and 0.88 in 35 m of sand.
    // One that knocks against the ship's side came to lie 3.5 m elsewhere with long steps, on its other side.
    constexpr double kAnchorMoves = 0.16;
    const int max = std::max(1, static_cast<int>(kLongest / dt + 1e-6));
    if (!setup_.budget || std::abs(windlass_.state().cable_speed) > kRuns) return 1;
    if (level() == ModelLevel::catenary) return max;
    const bool may_touch = windlass_.drawn_in() == 0 && anchor_.may_touch();
    const double moves = may_touch ? anchor_.fastest() : 0;
    for (int ticks = moves > kAnchorMoves ? 1 : max; ticks > 1; --ticks) {
        const bool as_long_now = chain_.last_step > (ticks - 0.5) * dt;
        const double step = ticks * dt / (as_long_now ? 1 : kSure);
        if (chain_substeps(setup_.chain, chain_, step, 2).count == 1) return ticks;
    }
    return 1;
}

} // namespace windlass::physics
