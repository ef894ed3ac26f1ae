#include "server/exercise/tick/deck.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>

namespace windlass::exercise {

using namespace physics;

namespace {

/// Cables nearer to each other than this (m) are stepped together; how near they are is looked at every so
/// many ticks, in which nothing of a cable comes so far at 300 ticks a second (30 m/s).
constexpr double kNear = 1.5;
constexpr int kLook = 15;

/// m, significant: in a sea from this height on cables are computed in full. Below, and in no swell, a hawse
/// moves by millimetres.
constexpr double kRestless = 0.3;

/// m, between the end of the cable outboard and the place in the hawse pipe where it belongs, in a state that
/// is brought back.
constexpr double kGap = 1;

constexpr double kFarthestInATick = 5; ///< m, that a hawse pipe moves while its cable waits

TackleSetup setup(const ExerciseDef& exercise, const GroundTackleDef& def, const ObstacleMesh& hull,
                  const ShipState& ship) {
    const HawsePipe pipe = hawse_pipe(exercise, def, hull);
    return {.windlass = def.windlass,
            .chain = modelled_chain(exercise, def),
            .anchor = def.anchor,
            .cable_out = def.anchor_home ? pipe.cable_at_home() : def.cable_out,
            .clutch_in = def.clutch_in,
            .stopper_closed = def.stopper_closed,
            .brake = def.brake,
            .condition = def.condition,
            .budget = exercise.model.adaptive ? std::optional(kModelBudget) : std::nullopt,
            .pipe = pipe,
            .ship_attitude = attitude(ship)};
}

/// Takes over what a cable that lies against the hull does to it.
void add_hull_load(const ShipState& ship, const ContactLoad& load, CablePull& pull) {
    const Vec3 midships = physics::midships(ship);
    pull.force -= load.impulse;
    pull.moment +=
        (load.moment - midships.cross(load.impulse)).z(); // clockwise, and on the ship: twice turned
}

/// The whole moment (N m, world, about midships on the waterline) of a force at the hawse pipe lip (N) and of
/// what the hull does to the cable. The ship's step takes no more of it than pull has: she does not roll.
Vec3 moment_on_ship(const ShipState& ship, const Vec3& lip, const Vec3& force, const ContactLoad& load) {
    const Vec3 midships = physics::midships(ship);
    return (lip - midships).cross(force) - (load.moment - midships.cross(load.impulse));
}

} // namespace

ShipState ship_start(const ShipStartDef& def, double level) {
    ShipState ship;
    ship.level = level;
    ship.x = def.x, ship.y = def.y, ship.heading = def.heading;
    ship.surge = def.surge, ship.sway = def.sway, ship.yaw_rate = def.yaw_rate;
    return ship;
}

EquipmentFaults causes(const Bower& bower, const FaultBook& faults) {
    EquipmentFaults causes = faults.causes(bower.side);
    bower.party.lay(bower.tackle.setup().windlass, faults.causes(other(bower.side)), causes);
    return causes;
}

Bower::Bower(const ExerciseDef& exercise, const GroundTackleDef& def, const ObstacleMesh& hull,
             const ShipState& ship)
    : side(def.side),
      tackle(setup(exercise, def, hull, ship), exercise.environment,
             hawse_position(exercise.ship, ship, outboard(def.side))),
      event_detector(def.side, tackle),
      levers{def.brake, 0, def.clutch_in, def.stopper_closed, false},
      party{},
      from(ship) {
    HullSurface surface{&hull, hull_motion(from, from, 0, 1), {}, &*tackle.setup().pipe};
    surface.motion.velocity = ship_velocity(from) + wave_velocity(from) + from.rise * Vec3::UnitZ();
    surface.motion.spin = spin(from);
    tackle.start_aboard(exercise.environment, surface);
}

Deck::Deck(const ExerciseDef& def, const ShipState& ship)
    : ship_(def.ship), max_substeps_(def.max_substeps), hull_(hull_mesh(def.ship, lip_clearance(def))) {
    if (def.tackle.empty() || def.tackle.size() > 2)
        throw std::invalid_argument("an exercise has one or two cables");
    if (def.tackle.size() == 2 && def.tackle[0].side == def.tackle[1].side)
        throw std::invalid_argument("the two cables of an exercise are on different sides");
    bowers_.reserve(def.tackle.size());
    for (const GroundTackleDef& tackle : def.tackle)
        bowers_.emplace_back(def, tackle, hull_, ship);
    if (bowers_.size() == 2) crossing_.emplace(bowers_[0].tackle, bowers_[1].tackle);
}

template <class Visitor, physics::StateOf<Bower> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.tackle, self.event_detector, self.levers, self.party, self.from, self.pull,
                   self.moment, self.waited, self.touched);
    v.within({"waited"}, self.waited, 0, Bower::kMaxWaited);
    WINDLASS_WITHIN(v, -physics::kStrongest, physics::kStrongest, self.moment);
}
WINDLASS_STATE_LISTED(Bower);

template <class Visitor, physics::StateOf<Deck> Self>
void visit_state(Visitor& v, Self& self) {
    for (auto& bower : self.bowers_) {
        const char* side = bower.side == Side::port ? "port" : "starboard";
        v.field({side}, bower);
        if constexpr (Visitor::kRestores) {
            // The cable ends in the hawse pipe of a ship that is where it left her.
            const ChainState& chain = bower.tackle.chain();
            const Vec3 lip = hawse_position(self.ship_, bower.from, outboard(bower.side));
            const HawsePipe& pipe = *bower.tackle.setup().pipe;
            const double drawn_in = bower.tackle.windlass().drawn_in();
            const Vec3 up_the_pipe = drawn_in > 0 ? Vec3(pipe.chain_at(drawn_in) - pipe.lip) : Vec3::Zero();
            v.within(
                {"gap between cable and hawse pipe (position_x position_y position_z from.x from.y heading "
                 "level surge sway heave roll pitch heel trim cable_out)"},
                (chain.position.at(chain.links) - lip - attitude(bower.from) * up_the_pipe).norm(), 0, kGap);
        }
    }
    if (self.crossing_) v.field({"cables_near"}, self.near_);
}
WINDLASS_STATE_LISTED(Deck);

void Deck::hold_together(const StateVisitor& v, const ShipState& now, const ShipState& next) const {
    for (const Bower& bower : bowers_) {
        const double side = outboard(bower.side);
        const Vec3 from = hawse_position(ship_, bower.from, side);
        for (const ShipState* at : {&now, &next})
            v.within({"way of a hawse pipe while its cable waits (x y heading level surge sway heave roll "
                      "pitch heel trim place tick has)"},
                     (hawse_position(ship_, *at, side) - from).norm(), 0, kFarthestInATick);
    }
}

/// Moves each ground tackle whose turn it is, and two that lie near each other together. False when something
/// ceased to be finite.
bool Deck::step(const DeckTick& tick) {
    substeps_ = 1;
    visits_before_ = all_visits();
    if (crossing_ && tick.number % kLook == 0)
        near_ = crossing_->near(bowers_[0].tackle, bowers_[1].tackle, kNear);
    bool level = true; // none is behind
    for (Bower& bower : bowers_)
        level = ++bower.waited == 1 && level;
    if (near_ && level) return work(bowers_, tick.dt, tick);
    for (Bower& bower : bowers_) {
        const bool due = near_ || bower.touched || bower.waited >= bower.tackle.stride(tick.dt);
        if (due && !work({&bower, 1}, tick.dt * bower.waited, tick)) return false;
    }
    return true;
}

/// Since the deck was made.
std::int64_t Deck::all_visits() const {
    std::int64_t sum = crossing_ ? crossing_->visits() : 0;
    for (const Bower& bower : bowers_)
        sum += bower.tackle.visits();
    return sum;
}

void Deck::catch_up(const DeckTick& tick) {
    for (Bower& bower : bowers_)
        if (bower.waited > 0) work({&bower, 1}, tick.dt * bower.waited, tick);
}

/// What a cable does, and what it would have to do alone with the ship at rest: the other one helps.
CableStrain Deck::strain(const Bower& bower, const DeckTick& tick) const {
    const Eigen::Vector2d pull = bower.pull.force.head<2>();
    const double level = pull.norm();
    if (!(level > 0)) return {0, 0, tick.wave_period};
    Vec3 rest = tick.force_at_rest;
    for (const Bower& other : bowers_)
        if (&other != &bower) rest += other.pull.force;
    return {level, std::max(0.0, -rest.head<2>().dot(pull) / level), tick.wave_period};
}

/// Moves one side's ground tackle, or both together, by so many seconds, up to where the ship is now. False
/// when one ceased to be finite.
bool Deck::work(std::span<Bower> gang, double seconds, const DeckTick& tick) {
    assert(!gang.empty() && gang.size() <= 2 && "one side, or both");
    const bool together = gang.size() == 2, restless = tick.wave_height >= kRestless;
    int steps = 1;
    for (Bower& bower : gang) {
        if (together) bower.tackle.wake();
        steps = std::max(steps, bower.tackle.substeps(seconds, max_substeps_));
    }
    std::array<Vec3, 2> force{Vec3::Zero(), Vec3::Zero()};
    std::array<ContactLoad, 2> hull_load;
    for (int done = 0, taken = 1; done < steps; done += taken) {
        if (visits() > kMaxTickVisits) {
            taken = steps - done;
            for (Bower& bower : gang)
                bower.tackle.hurry();
        }
        std::array<TackleStep, 2> order;
        for (std::size_t i = 0; i < gang.size(); ++i) {
            const Bower& bower = gang[i];
            const double side = outboard(bower.side), share = static_cast<double>(done + taken) / steps;
            const Vec3 from = hawse_position(ship_, bower.from, side);
            order[i] = {bower.party.acting(bower.levers),
                        causes(bower, tick.faults),
                        from + (hawse_position(ship_, tick.ship, side) - from) * share,
                        {&hull_,
                         hull_motion(bower.from, tick.ship, static_cast<double>(done) / steps, seconds),
                         {},
                         &*bower.tackle.setup().pipe}};
        }
        const double dt = seconds / steps * taken;
        if (together)
            crossing_->step(gang[0].tackle, gang[1].tackle, tick.environment, dt, order[0], order[1]);
        else if (gang[0].tackle.begin(tick.environment, dt, order[0].levers, order[0].causes, order[0].lip,
                                      &order[0].hull, restless))
            gang[0].tackle.finish(tick.environment, order[0].causes);
        const auto is_lost = [](const Bower& bower) { return !bower.tackle.finite(); };
        if (steps > 1 && std::ranges::any_of(gang, is_lost)) return false; // nothing is to be had of the rest
        for (std::size_t i = 0; i < gang.size(); ++i) {
            force[i] += gang[i].tackle.pull_on_ship() / steps * taken;
            hull_load[i].impulse += gang[i].tackle.hull_load().impulse / steps * taken;
            hull_load[i].moment += gang[i].tackle.hull_load().moment / steps * taken;
        }
    }
    substeps_ = std::max(substeps_, static_cast<unsigned>(steps));
    bool finite = true;
    for (std::size_t i = 0; i < gang.size(); ++i) {
        Bower& bower = gang[i];
        const double side = outboard(bower.side);
        bower.pull = {};
        add_pull(ship_, tick.ship, side, force[i], bower.pull);
        add_hull_load(tick.ship, hull_load[i], bower.pull);
        bower.moment =
            moment_on_ship(tick.ship, hawse_position(ship_, tick.ship, side), force[i], hull_load[i]);
        bower.from = tick.ship;
        bower.waited = 0;
        bower.touched = false;
        bower.event_detector.watch(seconds, bower.tackle, tick.environment, strain(bower, tick), tick.log);
        finite = finite && bower.tackle.finite();
    }
    return finite;
}

} // namespace windlass::exercise
