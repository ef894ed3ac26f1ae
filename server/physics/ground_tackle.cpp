#include "server/physics/ground_tackle.hpp"

#include "server/physics/chain_feed.hpp"
#include "server/physics/chain_substeps.hpp"
#include "server/physics/shackle_marks.hpp"
#include "server/physics/state_fields.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::physics {

namespace {

CableLimits cable_limits(const TackleSetup& setup) {
    const WindlassDef& w = setup.windlass;
    // From the bitter end some chain stays inboard: up from the locker, through the pipe.
    const double home = home_length(setup.chain);
    return {setup.pipe ? 2 * home - w.hawse_pipe_length : home,
            setup.chain.length - w.locker_lift - w.hawse_pipe_length};
}

/// m, of the cable that is modelled at the start.
double outboard(const TackleSetup& setup) {
    return std::max(setup.cable_out, home_length(setup.chain));
}

int capacity(const TackleSetup& setup) {
    // Should the bitter end part, what hung in the locker runs out, too.
    const double most = cable_limits(setup).bitter_end + setup.windlass.locker_lift;
    return static_cast<int>(std::ceil(most / setup.chain.node_spacing)) + 2;
}

constexpr std::size_t kWeakened = 2; ///< links that the instructor weakens, behind the cable's own condition

/// Puts the anchor there with its shackle at the given point, its shank along the given direction.
void place(const Vec3& shackle, const Eigen::Quaterniond& attitude, const Vec3& shank, Anchor& anchor) {
    AnchorPose pose;
    pose.attitude = attitude;
    anchor.set_pose(pose);
    pose.position = shackle - anchor.shackle().norm() * shank;
    anchor.set_pose(pose);
}

/// Attitude of the anchor hanging, shank up, its flukes' axis fore and aft; without a pipe, and so without a
/// ship, along y.
Eigen::Quaterniond hanging(const TackleSetup& setup) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    double turned = setup.anchor_turned;
    if (setup.pipe) { // by as much as the ship from north
        const Vec3 ahead = setup.ship_attitude * Vec3::UnitX();
        turned += std::atan2(ahead.y(), ahead.x()) - kQuarter;
    }
    return Eigen::Quaterniond(Eigen::AngleAxisd(turned, Vec3::UnitZ())) *
           Eigen::Quaterniond(Eigen::AngleAxisd(-kQuarter, Vec3::UnitY()));
}

/// N, largest tension of the links that touch their own anchor.
double taut_on_anchor(const ChainState& chain, const std::vector<PairContact>& pairs) {
    double most = 0;
    for (const PairContact& pair : pairs)
        if (pair.by == Presses::anchor && pair.penetration > 0)
            most = std::max(most, chain.tension[pair.link_a]);
    return most;
}

/// Hangs the cable below the lip with the tension that its weight and the anchor's give it: no start-up jerk.
void hang_at_rest(const ChainDef& def, const EnvironmentDef& environment, double deck_length, const Vec3& lip,
                  double anchor_weight, ChainState& chain) {
    const int n = chain.links;
    // Weight first, with the nodes where unstretched chain puts them; then the stretch from the top down.
    double below = anchor_weight;
    for (int i = 0; i < n; ++i) {
        if (i > 0) below += node_weight(def, environment, node_medium(def, environment, chain, i));
        chain.set_tension(i, below);
    }
    Vec3 at = lip;
    for (int i = n - 1; i >= 0; --i) {
        const double rest = link_length(def, chain, i);
        const double stretch = (rest + (i == n - 1 ? deck_length : 0)) * chain.tension[i] / def.stiffness;
        at.z() -= rest + stretch;
        chain.position.set(i, at);
    }
}

} // namespace

GroundTackle::GroundTackle(const TackleSetup& setup, const EnvironmentDef& environment, const Vec3& lip)
    : setup_(setup),
      chain_(straight_chain(setup.chain, lip - Vec3(0, 0, outboard(setup)), lip, outboard(setup),
                            capacity(setup))),
      solver_(setup.chain, capacity(setup)),
      contacts_(capacity(setup), setup.self_contact),
      windlass_(setup.windlass, setup.chain, cable_limits(setup), setup.cable_out),
      anchor_(setup.anchor, 0.5 * setup.chain.node_spacing * setup.chain.mass_per_metre, environment, {}),
      condition_(setup.condition),
      spacing_error_(spacing_error(setup.chain.node_spacing, height_over_bed(environment, lip))) {
    condition_.resize(condition_.size() + kWeakened);
    constexpr double kRounding = 1e-6; // m
    const CableLimits& limits = windlass_.limits();
    const double least = setup.pipe ? setup.pipe->cable_at_home() - kRounding : limits.home;
    if (setup.cable_out < std::max(least, limits.home) || setup.cable_out > limits.bitter_end) {
        throw std::invalid_argument("cable out at the start is not between anchor home and bitter end");
    }
    place(chain_.position.at(0), hanging(setup), Vec3::UnitZ(), anchor_);
    hang_at_rest(setup.chain, environment, setup.windlass.hawse_pipe_length, lip, anchor_.weight(environment),
                 chain_);
    place(chain_.position.at(0), hanging(setup), Vec3::UnitZ(), anchor_);
    anchor_.turn_flukes(setup.flukes_turned);
    under_way_.lip = lip;
    under_way_.ship = setup.ship_attitude;
    if (setup.pipe && windlass_.drawn_in() > 0) start_in_pipe(environment);

    if (setup.budget) {
        const ModelError share = saving_share(*setup.budget);
        sleep_.emplace(setup.chain, share);
        quiet_.emplace(setup.chain, environment, share, setup.windlass.hawse_pipe_length, capacity(setup));
    }
    WindlassState& state = windlass_.state();
    state.brake.position = setup.brake;
    state.clutch.position = setup.clutch_in ? Clutch::in : Clutch::out;
    state.stopper.closed = setup.stopper_closed;
}

void GroundTackle::step(const EnvironmentDef& environment, double dt, const WindlassLevers& levers,
                        const WindlassCauses& causes, const Vec3& lip, const HullSurface* hull) {
    if (begin(environment, dt, levers, causes, lip, hull)) finish(environment, causes);
}

bool GroundTackle::begin(const EnvironmentDef& environment, double dt, const WindlassLevers& levers,
                         const WindlassCauses& causes, const Vec3& lip, const HullSurface* hull, bool awake) {
    UnderWay& u = under_way_;
    follow_twist({.dt = dt,
                  .turned = hull != nullptr ? -hull->motion.spin.z() * dt : 0,
                  .to_anchor = chain_.position.at(0) - lip,
                  .anchored = anchor_.holding().landed && chain_.parted < 0,
                  .put_in = causes.cable_twisted},
                 twist_);
    u.drive.emplace(windlass_.prepare(dt, levers, causes, twist()));
    u.awake = awake;
    if (awake) wake();
    if (lie_quietly(environment, dt, *u.drive, lip)) return false;

    u.lip = lip;
    u.ship = setup_.ship_attitude;
    if (hull != nullptr) {
        const Vec3 turn = dt * hull->motion.spin;
        u.ship = Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * hull->motion.attitude;
    }
    u.drawn_in = setup_.pipe ? windlass_.drawn_in() : 0;
    u.lip_before = chain_.position.at(chain_.links);
    u.time = {dt, step_kick(chain_, dt)};
    u.contacts =
        &contacts_.find(setup_.chain, environment, chain_, dt, &anchor_, u.drawn_in > 0 ? nullptr : hull);
    ChainTail tail;
    u.anchor = {};
    if (chain_.asleep == 0) {
        tail = anchor_.begin(environment, u.time, shackle_pull(environment), causes, hull);
        u.anchor = anchor_.end();
    }
    solver_.predict(chain_, environment, dt, tail, *u.drive, upper_end(u.drawn_in));
    return true;
}

void GroundTackle::finish(const EnvironmentDef& environment, const WindlassCauses& causes,
                          const Vector6& pushed) {
    UnderWay& u = under_way_;
    DriveLine& drive = *u.drive;
    ContactSet& contacts = *u.contacts;
    const StepTime time = u.time;
    const double dt = time.dt;
    const bool anchor_sleeps = chain_.asleep > 0;
    EnergyLedger* ledger = ledger_kept_ ? &ledger_ : nullptr;

    u.anchor.motion += pushed;
    last_ = solver_.solve(chain_, environment, drive, ledger, &contacts, &u.anchor);
    const DeckResult deck = drive.result(last_.top);
    windlass_.settle(dt, deck, ledger, stretch_on_gypsy());
    if (!anchor_sleeps) {
        anchor_.push(pushed + contacts.pushed_anchor(), taut_on_anchor(chain_, contacts.pair_contacts()));
        anchor_.finish(environment, time, chain_.velocity.at(0), ledger);
        // The anchor turned on its arc: the chain's lower end is where the shackle is.
        chain_.position.set(0, anchor_.shackle());
        chain_.velocity.set(0, anchor_.shackle_velocity());
    }
    hull_load_ = contacts.empty() ? ContactLoad{} : contacts.settle(chain_, anchor_.motion());
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

/// Hove in so far, the anchor lies with its shank along the bore and its flukes turned outboard.
void GroundTackle::start_in_pipe(const EnvironmentDef& environment) {
    const Vec3 bore = under_way_.ship * setup_.pipe->bore, end = upper_end(windlass_.drawn_in());
    const double pull = bore.z() * anchor_.weight(environment);
    chain_.set_tension(0, pull);
    const double stretch =
        (chain_.top_length + setup_.windlass.hawse_pipe_length) * pull / setup_.chain.stiffness;
    chain_.position.set(chain_.links, end);
    chain_.position.set(0, end - (chain_.top_length + stretch) * bore);
    place(chain_.position.at(0), Eigen::Quaterniond(anchor_axes(bore, bore)), bore, anchor_);
    anchor_.turn_flukes(-setup_.anchor.fluke_angle);
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

/// Nothing is saved: every node moves.
void GroundTackle::wake() {
    if (quiet_ && quiet_->state().active) quiet_->give_back(chain_);
    if (sleep_ && chain_.asleep > 0) sleep_->wake(chain_);
}

/// What the instructor weakens is found when the fault comes up, and is that link from then on.
void GroundTackle::weaken_links(const WindlassCauses& causes) {
    const double lip = new_length(setup_.chain, chain_, windlass_.state().cable_out);
    const auto weaken = [](double share, double place, double& at, LinkCondition& link) {
        if (share == 0)
            at = -1;
        else if (at < 0)
            at = place;
        link = {.begins = at, .ends = at, .defect = share};
    };
    LinkCondition* link = &*(condition_.end() - kWeakened);
    weaken(causes.link_weak, lip, strain_.weak_at, link[0]);
    weaken(causes.shackle_open, joining_shackle_within(setup_.chain, lip), strain_.open_at, link[1]);
}

void GroundTackle::strain_cable(const WindlassCauses& causes, const DeckResult& deck, EnergyLedger* ledger) {
    weaken_links(causes);
    const Strained strained =
        strain_links(setup_.chain, condition_, setup_.windlass.hawse_pipe_length, chain_, strain_);
    windlass_.lengthen(strained.longer);
    if (ledger != nullptr) ledger->stretching += strained.work;
    const bool parts = strained.parting.link >= 0 || windlass_.state().chain_gone;
    if (chain_.parted < 0 && parts) part(strained.parting, deck, ledger);
}

void GroundTackle::part(const Parting& parting, const DeckResult& deck, EnergyLedger* ledger) {
    const bool run_out = windlass_.state().chain_gone;
    const double out = windlass_.state().cable_out;
    strain_.parted_by = run_out ? out : parting.tension;
    const double stored = link_energy(setup_.chain, chain_, run_out ? chain_.links - 1 : parting.link,
                                      setup_.windlass.hawse_pipe_length);
    // What ran with the chain stands once the end has passed.
    const double running = run_out ? 0.5 * running_mass() * deck.speed * deck.speed : 0;
    if (ledger != nullptr) ledger->parting += stored + running;
    chain_.parted = run_out ? chain_.links - 1 : parting.link;
    chain_.set_tension(chain_.parted, 0);
    chain_.asleep = 0;
    const bool end_in_pipe = chain_.parted == chain_.links - 1;
    // The bare end can be hove in as far as the lip; an end in the pipe stays there.
    const double last_node =
        stretched_length(setup_.chain, chain_, (chain_.parted + 1) * setup_.chain.node_spacing);
    const double home = end_in_pipe ? out : std::min(out, last_node + 0.5 * setup_.chain.node_spacing);
    windlass_.limit({home, end_in_pipe ? out - setup_.windlass.locker_lift : bitter_end()});
}

/// The step of a cable that is left to the catenary. False when it is not, or no longer is: the ship moves
/// too fast, the chain on the bottom would stir, or the windlass does not hold the pull; then the cable is
/// dynamic again, at the start of this step.
bool GroundTackle::lie_quietly(const EnvironmentDef& environment, double dt, const DriveLine& drive,
                               const Vec3& lip) {
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
    if (!holds || deck.speed != 0) {
        quiet_->give_back(chain_);
        return false;
    }
    windlass_.settle(dt, deck, nullptr);
    pull_on_ship_ = quiet_->pull();
    hull_load_ = {};
    return true;
}

AnchorAtRest GroundTackle::anchor_at_rest(const EnvironmentDef& environment) const {
    constexpr double kStill = 2e-3; // m/s, as for the chain
    const HoldingState& holding = anchor_.holding();
    const bool still = holding.landed && !holding.dragging && anchor_.shackle_velocity().norm() < kStill;
    return {chain_.asleep > 0 || still, anchor_.holding_power(environment, shackle_pull(environment))};
}

/// After a dynamic step: who may sleep, and whether the catenary will do.
void GroundTackle::save_work(const EnvironmentDef& environment, double dt) {
    const AnchorAtRest anchor = anchor_at_rest(environment);
    if (sleep_->watch(environment, anchor, dt, chain_)) anchor_.rest();

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

ModelError GroundTackle::error(const EnvironmentDef& environment) const {
    if (!sleep_) return spacing_error_;
    const bool quiet = quiet_->state().active;
    return together(quiet ? quiet_->state().error : spacing_error_, sleep_->error(environment, chain_));
}

int GroundTackle::substeps(double dt, int most) const {
    if (level() == ModelLevel::catenary) return 1;
    return chain_substeps(setup_.chain, chain_, dt, most);
}

int GroundTackle::stride(double dt) const {
    constexpr double kLongest = 0.01; // s; the load is published a hundred times a second
    constexpr double kRuns = 0.5;     // m/s; cable that runs is looked at in every tick
    constexpr double kSure = 0.7;     // of the step that the waves allow, to begin with longer steps
    const int most = std::max(1, static_cast<int>(kLongest / dt + 1e-6));
    if (!setup_.budget || std::abs(windlass_.state().cable_speed) > kRuns) return 1;
    if (level() == ModelLevel::catenary) return most;
    // An anchor that lies awake on the bottom is stepped as finely as the ground's hard contact wants.
    if (chain_.asleep == 0 && anchor_.holding().landed) return 1;
    const bool long_now = chain_.last_step > 1.5 * dt;
    return chain_substeps(setup_.chain, chain_, most * dt / (long_now ? 1 : kSure), 2) == 1 ? most : 1;
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
    return piece < chain_.stretched ? chain_.stretch[static_cast<int>(piece)] : 0;
}

Vec3 GroundTackle::cable_direction() const {
    const int n = chain_.links;
    return (chain_.position.at(n - 1) - chain_.position.at(n)).normalized();
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
    const WindlassState& w = windlass_.state();
    double sum = w.cable_speed + w.cable_out + w.brake.skin + w.brake.drum;
    for (int i = 0; i <= chain_.links; ++i) {
        sum += chain_.position.at(i).sum() + chain_.velocity.at(i).sum();
    }
    for (int i = 0; i < chain_.links; ++i)
        sum += chain_.tension[i];
    const AnchorPose pose = anchor_.pose();
    sum += pose.position.sum() + pose.velocity.sum() + pose.spin.sum();
    return std::isfinite(sum);
}

void GroundTackle::visit_state(StateVisitor& v) {
    WINDLASS_STATE(v, chain_, strain_, twist_, windlass_, anchor_);
    if (sleep_) v.field({"sleep"}, sleep_->state());
    if (!quiet_) return;
    v.enter({"quiet"});
    quiet_->visit_state(v, static_cast<std::size_t>(chain_.links) + 1);
    v.leave();
}

} // namespace windlass::physics
