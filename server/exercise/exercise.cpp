#include "server/exercise/exercise.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/picture/views.hpp"
#include "server/exercise/prelude.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/exercise/talk/lights_and_shapes.hpp"
#include "server/exercise/talk/line.hpp"
#include "server/exercise/tick/deck.hpp"
#include "server/exercise/tick/own_ship.hpp"
#include "server/exercise/watch/ground_watch.hpp"
#include "server/exercise/watch/model_watch.hpp"
#include "server/exercise/watch/watch_circle.hpp"
#include "server/exercise/weather/surroundings.hpp"
#include "server/physics/sea/chance.hpp"
#include "server/physics/sea/ground.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace windlass::exercise {

using namespace physics;

namespace {

/// The weather has the say over what the model is given of it.
ExerciseDef with_weather(ExerciseDef def) {
    lay_weather(def.weather, def.environment);
    return def;
}

} // namespace

struct Exercise::World {
    ExerciseDef def;
    Surroundings surroundings;
    OwnShip own_ship;
    FaultBook faults;
    BridgeOrders orders;
    AnchorWatch anchor_watch;
    LightsAndShapes lights_and_shapes; ///< as shown
    ModelWatch model_watch;
    GroundWatch ground_watch;
    Deck deck;
    std::uint64_t tick = 0, events_called = 0;
    unsigned substeps = 1;
    std::vector<ExerciseEvent> events, waiting; ///< of the last tick; called between ticks

    explicit World(const ExerciseDef& d) : World(d, with_weather(before_prelude(d))) {}

    /// before: as the definition, or as it is before its prelude.
    World(const ExerciseDef& d, const ExerciseDef& before)
        : def(with_weather(d)),
          surroundings(before.environment, before.weather, before.tide, water_depth(def)),
          own_ship(def.ship, ship_start(before.ship_start, before.environment.level), surroundings.sea(),
                   water_depth(def)),
          deck(before, own_ship.state()) {}

    /// Tick 0 with the ship as a prelude has left her, and the weather of the definition: its sea comes up.
    void leave_prelude() {
        tick = events_called = 0;
        events.clear();
        waiting.clear();
        surroundings.begin_anew(def.weather, def.tide, water_depth(def));
        own_ship.meet_sea(water_depth(def));
        lights_and_shapes = at_anchor_by(def.weather.time_of_day);
    }

    /// The faults of the definition, with the moments that are drawn for them.
    void arm() {
        for (std::size_t k = 0; k < def.faults.size(); ++k) {
            faults.order(def.faults[k], time(), log_to(waiting));
            const auto seed = static_cast<std::uint32_t>(def.chance_seed);
            if (def.faults[k].trigger == FaultTrigger::at_chance)
                faults.draw({chance(seed, Chance::fault, static_cast<int>(k))});
        }
    }

    double time() const { return static_cast<double>(tick) / def.tick_rate_hz; }
    BridgeOrders::When now() const { return {tick, time()}; }
    Talk talk() const { return talk_of(faults.list(), surroundings.weather().now().visibility); }

    /// The men at each windlass. What they have slipped from an anchor hangs there no more.
    void men_work(double dt, const EventLog& log) {
        for (Bower& bower : deck.bowers()) {
            const physics::EquipmentFaults other_ails = faults.causes(other(bower.side));
            const DeckWork done = bower.party.work(
                {bower.side, bower.tackle, bower.levers, surroundings.environment().level, other_ails}, dt,
                log);
            if (done != DeckWork::none) bower.touched = true;
            if (done == DeckWork::clear_anchor)
                faults.order(
                    {.code = FaultCode::anchor_fouled, .side = bower.side, .severity = 0, .clear = true},
                    time(), log);
        }
    }

    template <class Visitor, StateOf<World> Self>
    static void list_state(Visitor& v, Self& self) {
        constexpr std::uint64_t kMaxCount = 1ULL << 40; // of ticks: a century
        constexpr std::size_t kMaxCalls = 100'000;      // more than a pause's reports and orders make
        WINDLASS_STATE(v, self.tick, self.events_called, self.substeps);
        v.fields_of(self.surroundings);
        v.fields_of(self.own_ship);
        WINDLASS_STATE(v, self.faults, self.orders, self.anchor_watch, self.ground_watch, self.model_watch,
                       self.lights_and_shapes.anchor_ball, self.lights_and_shapes.anchor_lights);
        if constexpr (Visitor::kRestores) {
            self.surroundings.set_tide(self.def.tide);
            v.within({"tick"}, self.tick, 0, kMaxCount);
            v.within({"events_called"}, self.events_called, 0, kMaxCount);
            v.within({"substeps"}, self.substeps, 0, static_cast<unsigned>(self.def.max_substeps));
            self.surroundings.hold_to(self.def.environment, v);
            self.own_ship.hold(v, self.surroundings.environment().level);
        }
        v.fields_of(self.deck);
        if constexpr (Visitor::kRestores)
            self.deck.hold_together(v, self.own_ship.state(),
                                    self.own_ship.expected(self.surroundings.sea(), self.time()));
        v.length({"calls_waiting"}, self.waiting, kMaxCalls);
        for (auto& event : self.waiting) {
            auto& [called_at, time, number, severity, code, side, value, text] = event;
            WINDLASS_STATE(v, called_at, time, number, severity, code, side, value, text);
            v.within({"side"}, side, -1, 1);
        }
    }

    /// Cables that take several ticks in one step take those that are over, before anything changes in them.
    void catch_up() { deck.catch_up(deck_tick(log_to(waiting))); }

    DeckTick deck_tick(const EventLog& log) const {
        constexpr double kUnknown = 2; // m, of waves that may move a foreign ship's hawse pipes
        return {.environment = surroundings.environment(),
                .ship = own_ship.state(),
                .faults = faults,
                .log = log,
                .wave_height = std::max(surroundings.sea().height(time()), own_ship.foreign() ? kUnknown : 0),
                .wave_period = surroundings.wave_period(),
                .force_at_rest = own_ship.force_at_rest(),
                .number = tick,
                .dt = 1.0 / def.tick_rate_hz};
    }

    EventLog log_to(std::vector<ExerciseEvent>& list) {
        return EventLog(
            [this, &list](const words::Event& event, int side, double value, const std::string& text) {
                list.push_back({tick, time(), ++events_called, event.severity, std::string(event.name), side,
                                value, text});
            });
    }
};

Exercise::Exercise(std::unique_ptr<World> world) : world_(std::move(world)) {}

Exercise::Exercise(const ExerciseDef& def) : Exercise(std::make_unique<World>(def)) {
    if (anchored_by(def) != nullptr) {
        if (def.settled) {
            *this = read_checkpoint(*def.settled);
            world_->def.settled = def.settled;
            world_->def.lesson = def.lesson; // it may have been put to practice since
            return;
        }
        play_prelude(*this, def);
        world_->leave_prelude();
    }
    world_->arm();
}

Exercise Exercise::blank(const ExerciseDef& def) {
    return Exercise(std::make_unique<World>(def));
}
Exercise::~Exercise() = default;
Exercise::Exercise(Exercise&&) noexcept = default;
Exercise& Exercise::operator=(Exercise&&) noexcept = default;

const ExerciseDef& Exercise::def() const {
    return world_->def;
}
std::uint64_t Exercise::tick() const {
    return world_->tick;
}
double Exercise::time() const {
    return world_->time();
}

bool Exercise::called() const {
    return !world_->events.empty();
}

std::int64_t Exercise::visits() const {
    return world_->deck.visits();
}

bool Exercise::step(double dt) {
    assert(dt > 0 && std::abs(dt * world_->def.tick_rate_hz - 1) < 1e-9 &&
           "a tick is as long as the definition says");
    World& w = *world_;
    ++w.tick;
    w.events.swap(w.waiting);
    w.waiting.clear();
    const EventLog log = w.log_to(w.events);
    const double rise = w.surroundings.advance(dt, w.time());
    w.faults.advance(w.time(), log);

    // The ship moves under what the cables did to her in their last steps; the hawse pipes move with her.
    if (!w.own_ship.step(w.surroundings, rise, w.faults, dt, w.time(), log)) return false;
    if (!w.deck.step(w.deck_tick(log))) return false;
    w.substeps = w.deck.substeps();
    for (const Bower& bower : w.deck.bowers())
        w.own_ship.pulled_by(bower.pull);
    w.men_work(dt, log);
    w.anchor_watch.look(w.def.ship, w.own_ship.state(), dt, log);
    w.ground_watch.look(w.def.ship, w.surroundings.environment(), w.own_ship.state(), dt, log);
    StepCounts counts;
    for (const Bower& bower : w.deck.bowers())
        counts = counts + bower.tackle.step_counts();
    w.model_watch.look(w.tick, w.def.tick_rate_hz, counts, log);
    w.orders.watch(w.now(), log);
    // A fault that comes is an event that may bring another one: until none comes any more.
    for (std::size_t called = w.events.size() + 1; called != w.events.size();) {
        called = w.events.size();
        for (const Bower& bower : w.deck.bowers()) {
            const Windlass& windlass = bower.tackle.windlass();
            w.faults.watch(bower.side,
                           {w.time(), windlass.state().cable_out, windlass.loads().deck.gypsy_load}, w.events,
                           log);
        }
    }
    return true;
}

void Exercise::apply(const Order& command) {
    World& w = *world_;
    const EventLog log = w.log_to(w.waiting);
    std::visit(
        [&](const auto& order) {
            using Order = std::decay_t<decltype(order)>;
            if constexpr (std::is_same_v<Order, WindlassOrder>) {
                for (Bower& bower : w.deck.bowers()) {
                    if (bower.side != order.side) continue;
                    assert(order.brake >= 0 && order.brake <= 1 && std::abs(order.speed_lever) <= 1 &&
                           "orders are checked before");
                    const WindlassLevers levers{order.brake, order.speed_lever, order.clutch_in,
                                                order.stopper_closed, order.emergency_stop};
                    if (levers == bower.levers) continue;
                    w.catch_up();
                    bower.touched = true;
                    bower.levers = levers;
                }
            } else if constexpr (std::is_same_v<Order, HelmOrder>) {
                assert(std::abs(order.engine) <= 1 && std::abs(order.bow_thruster) <= 1 &&
                       std::abs(order.stern_thruster) <= 1 && "orders are checked before");
                w.own_ship.steer(order, w.surroundings.sea(), w.time());
            } else if constexpr (std::is_same_v<Order, FaultOrder>) {
                w.catch_up();
                w.faults.order(order, w.time(), log);
            } else if constexpr (std::is_same_v<Order, EnvironmentOrder>) {
                w.catch_up();
                w.surroundings.order(order.weather, order.ramp, w.time());
                log("environment.changed", -1, order.weather.wind_speed,
                    order.ramp > 0 ? "weather is being changed by the instructor"
                                   : "weather changed by the instructor");
            } else if constexpr (std::is_same_v<Order, ReportMade>) {
                say(order, w.talk(), w.now(), w.orders, log);
            } else if constexpr (std::is_same_v<Order, BridgeOrderGiven>) {
                say(order, w.talk(), w.now(), w.orders, w.faults, log);
            } else if constexpr (std::is_same_v<Order, WatchCircleOrder>) {
                w.anchor_watch.order(order, log);
            } else if constexpr (std::is_same_v<Order, LightsAndShapes>) {
                show(order, w.lights_and_shapes, log);
            } else if constexpr (std::is_same_v<Order, DeckWorkOrder>) {
                for (Bower& bower : w.deck.bowers())
                    if (bower.side == order.side) bower.party.set_to(order.work, order.side, log);
            } else if constexpr (std::is_same_v<Order, ChanceDrawn>) {
                w.faults.draw(order);
            } else if constexpr (std::is_same_v<Order, OwnShipSample>) {
                w.own_ship.follow(order, w.time(), log);
            }
        },
        command);
}

bool Exercise::brought_up(Side side) const {
    const auto& bowers = world_->deck.bowers();
    return std::any_of(bowers.begin(), bowers.end(), [&](const Bower& bower) {
        return bower.side == side && bower.event_detector.brought_up();
    });
}

bool Exercise::runs_away(Side side) const {
    const auto& bowers = world_->deck.bowers();
    return std::any_of(bowers.begin(), bowers.end(), [&](const Bower& bower) {
        return bower.side == side && bower.event_detector.runs_away();
    });
}

bool Exercise::motor_tripped(Side side) const {
    const auto& bowers = world_->deck.bowers();
    return std::any_of(bowers.begin(), bowers.end(), [&](const Bower& bower) {
        const PrimeMoverState& motor = bower.tackle.windlass().state().motor;
        return bower.side == side && (motor.tripped || motor.overspeed);
    });
}

WindlassOrder Exercise::levers(Side side) const {
    WindlassOrder order{.side = side};
    for (const Bower& bower : world_->deck.bowers()) {
        if (bower.side != side) continue;
        const auto& [brake, speed, clutch_in, stopper_closed, emergency_stop] = bower.levers;
        order = {side, brake, speed, clutch_in, stopper_closed, emergency_stop};
    }
    return order;
}

HelmOrder Exercise::helm() const {
    return world_->own_ship.helm();
}

bool Exercise::foreign() const {
    return world_->own_ship.foreign();
}

bool Exercise::foreign_lost() const {
    return world_->own_ship.foreign_lost();
}

void Exercise::visit_state(ConstStateVisitor& v) const {
    const World& world = *world_;
    World::list_state(v, world);
}

void Exercise::visit_state(StateVisitor& v) {
    World::list_state(v, *world_);
}

void Exercise::view(Snapshot& s) const {
    view_unhashed(s);
    StateHash hash;
    visit_state(hash);
    s.state_hash = hash.value();
}

void Exercise::view_unhashed(Snapshot& s) const {
    const World& w = *world_;
    const EnvironmentDef& environment = w.surroundings.environment();
    const WeatherInRamp& weather = w.surroundings.weather();
    const SeaSurface& sea = w.surroundings.sea();
    const ShipState& ship = w.own_ship.state();
    s.tick = w.tick;
    s.time = w.time();
    const Vec3 bow = hawse_position(w.def.ship, ship, 0);
    s.environment.depth = environment.level - bed_height(environment, bow.x(), bow.y());
    s.environment.now = weather.now();
    s.environment.now.tide_height = environment.level;
    s.environment.after = weather.after();
    s.environment.ramp_left = weather.left();
    s.environment.gust = environment.wind_speed - s.environment.now.wind_speed;
    s.environment.swing = environment.wind_from - s.environment.now.wind_from;
    s.sea.ramp_begin = sea.ramp_begin();
    s.sea.ramp_end = sea.ramp_end();
    s.sea.waves.reserve(kMaxWaveComponents); // all that it may ever need, taken the first time
    s.sea.waves.assign(sea.components().begin(), sea.components().end());
    view_ship(ship, w.own_ship.helm(), w.own_ship.answers(), s.ship);
    s.cable_force = w.own_ship.pull().force;
    s.cable_moment = {0, 0,
                      -w.own_ship.pull().moment}; // clockwise seen from above is about the z axis downwards
    s.tackle.resize(w.deck.bowers().size());
    s.model_nodes = 0;
    s.model_level = w.deck.bowers().front().tackle.level();
    s.model_error = {};
    for (std::size_t k = 0; k < w.deck.bowers().size(); ++k) {
        const Bower& bower = w.deck.bowers()[k];
        s.tackle[k].side = bower.side;
        s.tackle[k].hawse = hawse_position(w.def.ship, ship, outboard(bower.side));
        s.tackle[k].force = bower.pull.force;
        s.cable_moment.head<2>() += bower.moment.head<2>();
        view_anchor(bower.tackle, bower.event_detector.phase(), environment, s.tackle[k].anchor);
        view_chain(bower.tackle, ship.heading, environment, s.tackle[k].chain);
        view_windlass(bower.tackle, bower.levers, causes(bower, w.faults), s.tackle[k].windlass);
        s.tackle[k].deck_work = {bower.party.set(), bower.party.left(), bower.party.waits()};
        const ChainState& chain = bower.tackle.chain();
        s.model_nodes += static_cast<unsigned>(chain.links + 1 - chain.asleep);
        // What is shown is the dearest level in use and the largest error.
        s.model_level = std::min(s.model_level, bower.tackle.level());
        s.model_error = worse(s.model_error, bower.tackle.error(environment));
    }
    over_water(environment.level, s);
    s.state_hash = 0;
    s.faults = w.faults.list();
    s.bridge_orders = w.orders.list();
    s.watch_circle = w.anchor_watch.circle();
    s.outside_watch_circle = w.anchor_watch.outside();
    s.lights_and_shapes = w.lights_and_shapes;
    s.events = w.events;
    s.model_substeps = w.substeps;
    s.model_steps = w.model_watch.last();
    s.model_in_doubt = w.model_watch.in_doubt();
}

} // namespace windlass::exercise
