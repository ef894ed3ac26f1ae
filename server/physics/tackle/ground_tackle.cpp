#include "server/physics/tackle/ground_tackle.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/base/vectorise.hpp"
#include "server/physics/chain/chain_feed.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

namespace windlass::physics {

namespace {

constexpr double kMinTop = 1e-6; ///< m, of the top link in a state that is brought back

/// N, largest tension of the links that touch their own anchor.
double taut_on_anchor(const ChainState& chain, const std::vector<PairContact>& pairs) {
    double max = 0;
    for (const PairContact& pair : pairs)
        if (pair.body_b == Body::anchor && pair.penetration > 0)
            max = std::max(max, chain.tension[pair.link_a]);
    return max;
}

/// What belongs together is together: a step would have to close any gap, at the price of all its iterations.
void hold_together(const StateVisitor& v, const ChainDef& def, const ChainState& chain,
                   const Anchor& anchor) {
    constexpr double kGap = 1; // m
    for (int i = 0; i < chain.links; ++i) {
        const double length = (chain.position.at(i + 1) - chain.position.at(i)).norm();
        if (i != chain.parted)
            v.within({"length of a link (position_x position_y position_z top_length stretch parted)"},
                     length, 0, 2 * link_length(def, chain, i) + kGap);
    }
    v.within({"gap between cable and anchor (position_x position_y position_z axes)"},
             (anchor.shackle() - chain.position.at(0)).norm(), 0, kGap);
}

} // namespace

bool GroundTackle::begin(const EnvironmentDef& environment, double dt, const WindlassLevers& levers,
                         const EquipmentFaults& causes, const Vec3& lip, const HullSurface* hull,
                         bool awake) {
    assert(dt > 0 && "a step takes time");
    UnderWay& u = under_way_;
    u.contacts = nullptr; // no second half before there was a first
    follow_twist({.dt = dt,
                  .turned = hull != nullptr ? -hull->motion.spin.z() * dt : 0,
                  .to_anchor = chain_.position.at(0) - lip,
                  .anchored = anchor_.holding().landed && chain_.parted < 0,
                  .put_in = causes.cable_twisted},
                 twist_);
    const Eigen::Quaterniond& ship = hull != nullptr ? hull->motion.attitude : setup_.ship_attitude;
    u.drive.emplace(windlass_.prepare(dt, levers, causes, {bend_in_pipe(ship), twist()}));
    u.awake = awake;
    // Of every step, of one that is left to the catenary too: who asks where the anchor lies against the pipe
    // asks of now, and of a state that was brought back nothing else is known.
    u.lip = lip;
    u.ship = ship;
    if (hull != nullptr) {
        const Vec3 turn = dt * hull->motion.spin;
        u.ship = Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * ship;
    }
    if (awake) wake();
    if (lie_quietly(environment, causes, dt, *u.drive, lip)) return false;

    u.drawn_in = setup_.pipe ? windlass_.drawn_in() : 0;
    u.lip_before = chain_.position.at(chain_.links);
    u.time = {dt, step_kick(chain_, dt)};
    u.contacts =
        &contacts_.find(setup_.chain, environment, chain_, dt, &anchor_, u.drawn_in > 0 ? nullptr : hull);
    ChainTail tail;
    u.anchor = {};
    u.anchor_after.setZero();
    if (chain_.asleep == 0) {
        tail = anchor_.begin(environment, u.time, shackle_pull(environment), causes, hull);
        u.anchor = anchor_.end();
    }
    u.cable = solver_.predict(chain_, environment, dt, tail, *u.drive, upper_end(u.drawn_in));
    u.cable.anchor = &u.anchor;
    return true;
}

void GroundTackle::finish(const EnvironmentDef& environment, const EquipmentFaults& causes,
                          const Vector7& pushed, bool left_out) {
    UnderWay& u = under_way_;
    assert(u.contacts != nullptr && "begin() comes first, and once, and says that there is more to do");
    DriveLine& drive = *u.drive;
    ContactSet& contacts = *std::exchange(u.contacts, nullptr);
    const StepTime time = u.time;
    const double dt = time.dt;
    const bool anchor_sleeps = chain_.asleep > 0;
    EnergyLedger* ledger = ledger_kept_ ? &ledger_ : nullptr;

    u.anchor.motion += pushed;
    last_ = solver_.solve(chain_, environment, drive, ledger, &contacts, &u.anchor);
    visits_ += (chain_.links - chain_.asleep + static_cast<std::int64_t>(contacts.pair_contacts().size()) +
                static_cast<std::int64_t>(contacts.node_contacts().size())) *
               last_.iterations;
    const DeckResult deck = drive.result(last_.top);
    windlass_.settle(dt, deck, causes, ledger, stretch_on_gypsy());
    if (!anchor_sleeps) {
        anchor_.push(pushed + contacts.pushed_anchor(), taut_on_anchor(chain_, contacts.pair_contacts()));
        u.anchor_after = anchor_.finish(environment, time, chain_.velocity.at(0), ledger);
        // The anchor turned on its arc: the chain's lower end is where the shackle is.
        chain_.position.set(0, anchor_.shackle());
        chain_.velocity.set(0, anchor_.shackle_velocity());
        const bool gives_way = anchor_.holding().dragging && deck.speed < 0;
        const bool pulled_over = anchor_.holding().landed && anchor_.wound();
        luck_decides_ = gives_way || pulled_over || (luck_decides_ && !home());
    }
    const bool poor =
        count_step(left_out || contacts.dropped() > 0 || (!anchor_sleeps && anchor_.touches_left_out()));
    follow_load(deck.hawse_tension, poor, dt, recent_load_);
    hull_load_ = contacts.empty() ? ContactLoad{} : contacts.settle(chain_, u.anchor_after);
    if (!anchor_sleeps) hull_load_ += anchor_.hull_load();
    if (ledger != nullptr) ledger->contact += hull_load_.work;
    feed_chain(setup_.chain, chain_, deck.speed, setup_.windlass.hawse_pipe_length);

    strain_cable(causes, deck, ledger);

    pull_on_ship_ = last_.hawse_impulse / time.kick;
    pull_on_ship_.z() -= 0.5 * chain_.top_length * weight_in_air(setup_.chain);
    hull_load_.impulse /= time.kick;
    hull_load_.moment /= time.kick;
    // The pull counts as one at the lip; further up the pipe it has another moment.
    if (u.drawn_in > 0) hull_load_.moment -= (upper_end(u.drawn_in) - u.lip).cross(pull_on_ship_);
    if (ledger != nullptr)
        ledger->hull += last_.hawse_impulse.dot(chain_.position.at(chain_.links) - u.lip_before) / dt;
    draw_in(ledger);
    if (sleep_ && chain_.parted < 0 && !u.awake) save_work(environment, dt);
}

/// Adds the step that was just taken to the counts. left_out: not every contact was kept. True when it was
/// not what it should be.
bool GroundTackle::count_step(bool left_out) {
    ++counts_.steps;
    counts_.implicit += last_.implicit ? 1 : 0;
    counts_.unsolved += last_.unsolved ? 1 : 0;
    counts_.friction += last_.friction_given_up ? 1 : 0;
    counts_.contacts += last_.contacts_unsettled ? 1 : 0;
    counts_.dropped += left_out ? 1 : 0;
    return last_.implicit || last_.unsolved || last_.friction_given_up || last_.contacts_unsettled ||
           left_out || too_long_;
}

/// m along the bore, from the pipe's mouth to the shackle.
double GroundTackle::up_the_pipe() const {
    const Vec3 at = under_way_.ship.conjugate() * (anchor_.shackle() - under_way_.lip) + setup_.pipe->lip;
    return setup_.pipe->bore.dot(at - setup_.pipe->mouth);
}

bool GroundTackle::home() const {
    constexpr double kHome = 0.1; // m short of it
    if (!setup_.pipe) return windlass_.state().cable_out < home_length(setup_.chain) + kHome;
    return chain_.parted < 0 && up_the_pipe() > setup_.pipe->seat - kHome;
}

bool GroundTackle::at_hawse() const {
    const double from_lip = (anchor_.shackle() - under_way_.lip).norm();
    return chain_.parted < 0 && !home() && from_lip < 2 * setup_.anchor.shank_length;
}

bool GroundTackle::flukes_inboard() const {
    constexpr double kAtTheSide = 0.7; // cosine: within 45 degrees of level and square to the plating
    if (!setup_.pipe || chain_.parted >= 0 || up_the_pipe() < 0) return false;
    const Vec3 bore = under_way_.ship * setup_.pipe->bore;
    return Vec3(bore.x(), bore.y(), 0).normalized().dot(anchor_.flukes()) > kAtTheSide;
}

/// Where the cable outboard ends: at the lip, or, m, world, drawn in so far up the pipe.
Vec3 GroundTackle::upper_end(double drawn_in) const {
    if (drawn_in == 0) return under_way_.lip;
    return under_way_.lip + under_way_.ship * (setup_.pipe->chain_at(drawn_in) - setup_.pipe->lip);
}

/// What was hove in or veered with the cable's end in the pipe was taken from the top link, or given to it;
/// instead its end moves along the pipe. Where that is not the link's direction, at the lip's bend, the lip
/// takes the difference.
void GroundTackle::draw_in(EnergyLedger* ledger) {
    const double before = under_way_.drawn_in, now = setup_.pipe ? windlass_.drawn_in() : 0;
    if (before == now) return;
    const int top = chain_.links;
    const auto span = [&] { return (chain_.position.at(top) - chain_.position.at(top - 1)).norm(); };
    const double straight = span();
    chain_.top_length += now - before;
    chain_.position.set(top, upper_end(now));
    if (ledger != nullptr) ledger->hawse += chain_.tension[top - 1] * (now - before - span() + straight);
}

double GroundTackle::energy(const EnvironmentDef& environment) const {
    const double deck_length = setup_.windlass.hawse_pipe_length;
    const double weight = weight_in_air(setup_.chain);
    const double inboard =
        setup_.chain.length -
        new_length(setup_.chain, chain_, windlass_.state().cable_out + windlass_.drawn_in());
    const double top = chain_.position.z[chain_.links], half_link = 0.5 * chain_.top_length;
    const double lip =
        top - (setup_.pipe ? (setup_.pipe->chain_at(windlass_.drawn_in()) - setup_.pipe->lip).z() : 0);
    const double speed = windlass_.state().cable_speed;
    return chain_energy(setup_.chain, environment, chain_, deck_length).total() + anchor_.kinetic_energy() +
           anchor_.potential_energy(environment) + windlass_.inboard_potential() +
           weight * (inboard * lip + half_link * top) + 0.5 * running_mass() * speed * speed;
}

/// kg at the pitch line, of all that has the gypsy's speed: half of the top link, too.
double GroundTackle::running_mass() const {
    return windlass_.turning_mass() + windlass_.inboard_mass() +
           0.5 * chain_.top_length * setup_.chain.mass_per_metre;
}

/// Permanent, of the links in the gypsy's pockets: fewer of them pass in a metre.
double GroundTackle::stretch_on_gypsy() const {
    if (chain_.stretched == 0) return 0;
    const double at = windlass_.state().cable_out + setup_.windlass.hawse_pipe_length;
    const double piece = new_length(setup_.chain, chain_, at) / setup_.chain.node_spacing;
    return piece >= 0 && piece < chain_.stretched ? chain_.stretch[static_cast<int>(piece)] : 0;
}

Vec3 GroundTackle::cable_direction() const {
    const int n = chain_.links;
    return (chain_.position.at(n - 1) - chain_.position.at(n)).normalized();
}

/// rad, of the cable in the hawse pipe of a ship with these axes. Its lead is that of its pull on the ship:
/// along the top link, with the half of this one's weight that is above its middle; slack cable hangs.
double GroundTackle::bend_in_pipe(const Eigen::Quaterniond& ship) const {
    if (!setup_.pipe) return kBendToPlumb;
    const auto pull = [&]() -> Vec3 {
        if (quiet_ && quiet_->state().active) return quiet_->pull();
        const double half_link = 0.5 * chain_.top_length * weight_in_air(setup_.chain);
        return chain_.tension[chain_.links - 1] * cable_direction() - half_link * Vec3::UnitZ();
    };
    return setup_.pipe->bent(ship.conjugate() * pull().normalized());
}

double GroundTackle::uplift(const EnvironmentDef& environment) const {
    const Vec3 at = chain_.position.at(0), link = chain_.position.at(1) - at;
    if (chain_.tension[0] <= 0) return 0; // slack cable does not lift
    const Vec3 up = bed_normal(environment, at.x(), at.y());
    const double rise = link.dot(up);
    return std::atan2(rise, (link - rise * up).norm());
}

ShacklePull GroundTackle::shackle_pull(const EnvironmentDef& environment) const {
    const Vec3 up = bed_normal(environment, chain_.position.x[0], chain_.position.y[0]);
    const Vec3 pull = chain_.tension[0] * (chain_.position.at(1) - chain_.position.at(0)).normalized();
    const double lift = pull.dot(up), level = (pull - lift * up).norm();
    return {std::atan2(lift, std::max(level, anchor_.bed_friction(environment))), lift};
}

bool GroundTackle::finite() const {
    // Counted, which vectorises; a maximum does not. Squares, which a number that is none fails too.
    std::int64_t fit = 0;
    const Field &x = chain_.position, &v = chain_.velocity;
    constexpr double kFar = kFarthest * kFarthest, kFast = kFastest * kFastest;
    WINDLASS_VECTORISE
    for (int i = 0; i <= chain_.links; ++i) {
        const double place = x.x[i] * x.x[i] + x.y[i] * x.y[i] + x.z[i] * x.z[i];
        const double speed = v.x[i] * v.x[i] + v.y[i] * v.y[i] + v.z[i] * v.z[i];
        const double near = place < kFar ? 1 : 0, slow = speed < kFast ? near : 0;
        fit += slow > 0 ? 1 : 0;
    }
    std::int64_t pulls = 0;
    WINDLASS_VECTORISE
    for (int i = 0; i < chain_.links; ++i)
        pulls += chain_.tension[i] < kStrongest ? 1 : 0;
    const WindlassState& w = windlass_.state();
    const AnchorPose pose = anchor_.pose();
    return fit == chain_.links + 1 && pulls == chain_.links && std::abs(w.cable_speed) < kFastest &&
           std::isfinite(w.cable_out + w.brake.skin + w.brake.shell + w.brake.drum) &&
           pose.position.squaredNorm() < kFar && pose.velocity.squaredNorm() < kFast &&
           pose.spin.squaredNorm() < kFastestTurn * kFastestTurn;
}

template <class Visitor, StateOf<GroundTackle> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.chain_, self.strain_, self.twist_, self.windlass_, self.anchor_, self.counts_,
                   self.recent_load_, self.luck_decides_);
    const double cable = self.setup_.chain.length; // as the files have it; what is outboard is of it
    v.within({"chain.top_length"}, self.chain_.top_length, kMinTop, cable);
    v.within({"windlass.state.cable_out"}, self.windlass_.state().cable_out, -cable, 2 * cable);
    v.within({"windlass.limits.bitter_end"}, self.windlass_.limits().bitter_end,
             -self.windlass_.def().locker_lift, 2 * cable);
    if constexpr (Visitor::kRestores) hold_together(v, self.setup_.chain, self.chain_, self.anchor_);
    if (self.sleep_) {
        v.field({"sleep"}, self.sleep_->state());
        // Of the last look: links may have been hove in since, and neither is used beyond those that are
        // left.
        const int room = self.chain_.position.size() - 1;
        v.within({"sleep.still_links"}, self.sleep_->state().still_links, 0, room);
        v.within({"sleep.weakest"}, self.sleep_->state().weakest, 0, room);
    }
    if (!self.quiet_) return;
    v.enter({"quiet"});
    v.fields_of(*self.quiet_);
    if (Visitor::kRestores && self.quiet_->state().active) { // then it is the cable
        constexpr double kSlackest = 1e-3;                   // N
        v.within({"pull of the catenary (active h v_lip toward)"}, self.quiet_->pull().norm(), kSlackest,
                 kStrongest);
        v.within({"links asleep under the catenary (active asleep)"}, self.chain_.asleep, 1,
                 self.chain_.links - 1);
    }
    v.leave();
}
WINDLASS_STATE_LISTED(GroundTackle);

} // namespace windlass::physics
