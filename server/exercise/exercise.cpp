#include "server/exercise/exercise.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/picture/views.hpp"
#include "server/exercise/prelude.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/exercise/talk/lights_and_shapes.hpp"
#include "server/exercise/talk/report_text.hpp"
#include "server/exercise/talk/talk.hpp"
#include "server/exercise/tick/deck.hpp"
#include "server/exercise/watch/ground_watch.hpp"
#include "server/exercise/watch/model_watch.hpp"
#include "server/exercise/watch/watch_circle.hpp"
#include "server/exercise/weather/weather_table.hpp"
#include "server/physics/base/state_limits.hpp"
#include "server/physics/sea/chance.hpp"
#include "server/physics/sea/ground.hpp"
#include "server/physics/sea/gusts.hpp"
#include "server/physics/ship/ship_dynamics.hpp"

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

// m/s, of a state that is brought back: as of the files and orders, in the strongest gust
constexpr double kMaxWind = weather_row("wind_speed").high * 4, kMaxCurrent = 15;
constexpr double kFarthestInATick = 5; // m, that a hawse pipe moves while its cable waits
constexpr double kMaxTide = 50;        // m; of both what orders may ask for and a tide adds to it

/// s between two looks at what the ship would ask of her cables at rest: engine, gusts and drift change
/// slower.
constexpr double kLookAtRest = 0.5;
/// m/s, at which the water rises and falls at most: twenty times the fastest tide's, and a Panamax's snubbed
/// cable takes it up without a swing.
constexpr double kFastestRise = 0.01;
constexpr double kWavesCount = 0.3; ///< m, significant: lower ones do nothing to a cable's pull

/// s after a blackout at which the emergency generator must bear its load, the steering gear among it (SOLAS
/// II-1/42, 43: 45 s).
constexpr double kEmergencySupply = 45;

/// s, of the longest waves that count; 0: none do.
double wave_period(const Weather& weather) {
    const double waves = weather.wave_height >= kWavesCount ? weather.wave_period : 0;
    return std::max(waves, weather.swell_height >= kWavesCount ? weather.swell_period : 0);
}
} // namespace

struct Exercise::World {
    ExerciseDef def;
    EnvironmentDef environment; ///< as the model is given it now
    WeatherInRamp weather;
    std::vector<TideRow> tide; ///< that runs: none before the exercise
    SeaSurface sea;
    ShipInWaves in_waves;       ///< both keep nothing that the rest of the state does not say
    ShipDynamics ship_dynamics; ///< nor does this
    Gusts gusts;
    ShipState ship;
    ForeignShip foreign_ship;
    ForeignShip::Drive foreign_drive = ForeignShip::Drive::none; ///< as last called
    bool foreign_jumped = false; ///< its last sample was not followed, and that was said
    Helm helm;                   ///< as ordered
    Helm answers;                ///< what of it the ship hears
    CablePull pull;              ///< of the last tick, which moves the ship in this one
    Vec3 at_rest{0, 0, 0}; ///< N, world: what all but her cables asks of her at rest, when last looked at
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
          environment(before.environment),
          weather(before.weather),
          tide(before.tide),
          sea(sea_of(before.weather), water_depth(def)),
          in_waves(def.ship, water_depth(def)),
          ship_dynamics(def.ship),
          ship(ship_start(before.ship_start, before.environment.level)),
          deck(before, ride_waves(0)) {}

    /// Tick 0 with the ship as a prelude has left her, and the weather of the definition: its sea comes up.
    void leave_prelude() {
        tick = events_called = 0;
        events.clear();
        waiting.clear();
        weather = WeatherInRamp(def.weather);
        lay_weather_now();
        tide = def.tide;
        lights_and_shapes = at_anchor_by(def.weather.time_of_day);
        sea = SeaSurface({}, water_depth(def));
        in_waves = ShipInWaves(def.ship, water_depth(def));
        if (def.weather.wave_height > 0 || def.weather.swell_height > 0)
            sea.order(sea_of(def.weather), 0, kSeaFade);
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

    /// All of the weather but the water's level, which follows it at its own pace.
    void lay_weather_now() {
        const double level = environment.level;
        lay_weather(weather.now(), environment);
        environment.level = level;
    }

    /// Weather and water dt (s) on.
    void advance_weather(double dt) {
        if (!tide.empty()) {
            const Tide now = tide_at(tide, time()), was = tide_at(tide, time() - dt);
            weather.run_tide({now.height - was.height, now.stream - was.stream});
        }
        if (weather.advance(dt) || !tide.empty()) lay_weather_now();
        // The sea is wide: what is ordered at once comes at a pace that throws no ship.
        const double rise =
            std::clamp(weather.now().tide_height - environment.level, -kFastestRise * dt, kFastestRise * dt);
        environment.level += rise;
        ship.level = environment.level, ship.rise = rise / dt;
    }

    /// The wind as it blows now, about the weather's mean.
    void blow() {
        const Weather& now = weather.now();
        const WindNow wind = gusts.wind(
            {now.wind_speed, now.wind_from, now.gust_factor, now.gust_period, now.wave_seed}, time());
        environment.wind_speed = wind.speed, environment.wind_from = wind.from;
    }

    /// What the waves do to the ship at t (s).
    WaveMotion wave_motion(double t) {
        const Vec3 velocity = ship_velocity(ship);
        return in_waves.motion(sea, {ship.x, ship.y, ship.heading, velocity.x(), velocity.y()}, t);
    }

    /// Lays it over her.
    const ShipState& ride_waves(double t) {
        ship.waves = wave_motion(t);
        return ship;
    }

    /// m, significant, that may move the hawse pipes: those of a foreign ship move as she likes.
    double wave_height() const {
        constexpr double kUnknown = 2;
        const bool foreign = foreign_drive != ForeignShip::Drive::none;
        return std::max(sea.height(time()), foreign ? kUnknown : 0);
    }

    /// Who sails her, when it changes.
    void call_foreign_drive(const EventLog& log) {
        const ForeignShip::Drive was = foreign_drive, now = foreign_ship.drive(time());
        if (now == was) return;
        foreign_drive = now;
        switch (now) {
        case ForeignShip::Drive::none:
            return log("own_ship.handed_back", -1, 0);
        case ForeignShip::Drive::fresh:
            return log("own_ship.foreign", -1, 0);
        case ForeignShip::Drive::late:
            return log("own_ship.late", -1, ForeignShip::kLate);
        case ForeignShip::Drive::held:
            return log("own_ship.lost", -1, ForeignShip::kStill);
        }
    }

    void take(const OwnShipSample& sample, const EventLog& log) {
        const auto answer = foreign_ship.take(sample, time(), ship);
        if (answer == ForeignShip::Answer::jumped && !foreign_jumped)
            log("own_ship.jumped", -1,
                (sample.position + ship.level * Vec3::UnitZ() - midships(ship)).norm());
        foreign_jumped = answer == ForeignShip::Answer::jumped;
    }

    /// The forecastle reports. Whoever is not heard learns that nothing came back.
    void take(const ReportMade& report, const EventLog& log) {
        if (gets_through(report, talk())) {
            log("report.made", report.side, report.value, report_text(report));
            orders.hear(report, now(), log);
            return;
        }
        log("report.not_heard", report.side, report.value,
            "no answer from the bridge; " + report_text(report));
        if (const std::string rung = bell(report); !rung.empty()) log("report.bell", -1, 0, rung);
    }

    /// The bridge orders; the same.
    void take(const BridgeOrderGiven& order, const EventLog& log) {
        const Talk way = talk();
        if (!gets_through(order, way)) {
            const std::string words = order_words(order.code, order.side, order.value);
            log("order.not_heard", order.side, 0,
                "no answer from the forecastle; ordered: " + (words.empty() ? order.text : words));
            return;
        }
        BridgeOrderGiven heard = order;
        if (!way.vhf) heard.text = kByHand;
        orders.give(heard, now(), log);
        faults.hear(heard);
    }

    Talk talk() const { return talk_of(faults.list(), weather.now().visibility); }

    /// The helm is moved: who moves it has her, where no foreign model is heard.
    void take(const Helm& ordered) {
        const auto drive = foreign_ship.drive(time());
        const bool unheard = drive == ForeignShip::Drive::late || drive == ForeignShip::Drive::held;
        if (unheard && !(ordered == helm)) foreign_ship.release(time(), wave_motion(time()), ship);
        helm = ordered;
    }

    double time() const { return static_cast<double>(tick) / def.tick_rate_hz; }

    template <class Visitor, StateOf<World> Self>
    static void list_state(Visitor& v, Self& self) {
        constexpr std::uint64_t kMaxCount = 1ULL << 40; // of ticks: a century
        constexpr std::size_t kMaxCalls = 100'000;      // more than a pause's reports and orders make
        WINDLASS_STATE(v, self.tick, self.events_called, self.substeps, self.environment, self.weather,
                       self.sea, self.ship, self.foreign_ship, self.foreign_drive, self.foreign_jumped,
                       self.helm, self.answers, self.pull, self.at_rest, self.faults, self.orders,
                       self.anchor_watch, self.ground_watch, self.model_watch,
                       self.lights_and_shapes.anchor_ball, self.lights_and_shapes.anchor_lights);
        if constexpr (Visitor::kRestores) {
            self.environment.current_profile = self.weather.now().current_profile; // which no state has twice
            self.tide = self.def.tide;
            v.within({"tick"}, self.tick, 0, kMaxCount);
            v.within({"events_called"}, self.events_called, 0, kMaxCount);
            v.within({"substeps"}, self.substeps, 0, static_cast<unsigned>(self.def.max_substeps));
            self.hold_to_definition(v);
        }
        v.fields_of(self.deck);
        if constexpr (Visitor::kRestores) self.hold_ship_together(v);
        v.length({"calls_waiting"}, self.waiting, kMaxCalls);
        for (auto& event : self.waiting) {
            auto& [called_at, time, number, severity, code, side, value, text] = event;
            WINDLASS_STATE(v, called_at, time, number, severity, code, side, value, text);
            v.within({"side"}, side, -1, 1);
        }
    }

    BridgeOrders::When now() const { return {tick, time()}; }

    /// She is where the cables left her some ticks ago, and where she will be is near: what jumps tears them.
    void hold_ship_together(const StateVisitor& v) {
        ShipState next = ship;
        next.waves = wave_motion(time());
        if (foreign_ship.drive(time()) == ForeignShip::Drive::none)
            foreign_ship.fade(time(), next.waves);
        else
            foreign_ship.move(time(), next);
        for (const Bower& bower : deck.bowers()) {
            const double side = outboard(bower.side);
            const Vec3 from = hawse_position(def.ship, bower.from, side);
            for (const ShipState* at : {&ship, &next})
                v.within(
                    {"way of a hawse pipe while its cable waits (x y heading level surge sway heave roll "
                     "pitch heel trim place tick has)"},
                    (hawse_position(def.ship, *at, side) - from).norm(), 0, kFarthestInATick);
        }
    }

    /// Of the environment wind, current and level alone ever change; and no lever goes beyond its stops.
    void hold_to_definition(const StateVisitor& v) const {
        const EnvironmentDef& was = def.environment;
        const auto same = [&](const char* name, double value, double defined) {
            v.within({name}, value, defined, defined);
        };
        same("environment.depth", environment.depth, was.depth);
        same("environment.water_density", environment.water_density, was.water_density);
        same("environment.soil", static_cast<double>(environment.soil), static_cast<double>(was.soil));
        same("environment.bed_stiffness", environment.bed_stiffness, was.bed_stiffness);
        same("environment.bed_friction", environment.bed_friction, was.bed_friction);
        v.within({"environment.wind_speed"}, environment.wind_speed, 0, kMaxWind);
        v.within({"environment.current_speed"}, environment.current_speed, 0, kMaxCurrent);
        v.within({"environment.level"}, environment.level, -kMaxTide, kMaxTide);
        v.within({"ship.level"}, ship.level, environment.level, environment.level);
        WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, environment.wind_from, environment.current_towards);
        WINDLASS_WITHIN(v, -kStrongest, kStrongest, at_rest);
        for (const Helm& levers : {helm, answers}) {
            v.within({"helm.engine"}, levers.engine, -1, 1);
            v.within({"helm.rudder"}, levers.rudder, -def.ship.rudder_max, def.ship.rudder_max);
            v.within({"helm.bow_thruster"}, levers.bow_thruster, -1, 1);
            v.within({"helm.stern_thruster"}, levers.stern_thruster, -1, 1);
        }
    }

    /// Cables that take several ticks in one step take those that are over, before anything changes in them.
    void catch_up() { deck.catch_up(deck_tick(log_to(waiting))); }

    DeckTick deck_tick(const EventLog& log) const {
        return {.environment = environment,
                .ship = ship,
                .faults = faults,
                .log = log,
                .wave_height = wave_height(),
                .wave_period = wave_period(weather.now()),
                .force_at_rest = at_rest,
                .number = tick,
                .dt = 1.0 / def.tick_rate_hz};
    }

    /// A telegraph that has failed passes no order on, and a thruster without power takes none.
    void answer_helm() {
        const double engine = answers.engine;
        answers = helm;
        if (!machinery().thrusters_available) answers.bow_thruster = answers.stern_thruster = 0;
        if (faults.seconds_of(FaultCode::telegraph_failed, time()) >= 0) answers.engine = engine;
    }

    /// What a blackout leaves: steering, once the emergency supply is up.
    Machinery machinery() const {
        const double dark = faults.seconds_of(FaultCode::ship_blackout, time());
        return {.engine_available = dark < 0,
                .steering_available = dark < 0 || dark >= kEmergencySupply,
                .thrusters_available = dark < 0};
    }

    void look_at_rest() {
        const auto every = static_cast<std::uint64_t>(std::llround(kLookAtRest * def.tick_rate_hz));
        if (tick % every == 1) at_rest = ship_dynamics.force_at_rest(environment, answers, machinery(), ship);
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
    w.advance_weather(dt);
    w.blow();
    w.sea.advance(w.time());
    w.faults.advance(w.time(), log);

    // The ship moves under what the cables did to her in their last steps; the hawse pipes move with her.
    w.answer_helm();
    if (w.foreign_ship.drive(w.time()) == ForeignShip::Drive::none) {
        w.ship_dynamics.step(w.environment, w.answers, w.machinery(), w.pull, dt, w.ship);
        w.ride_waves(w.time());
        w.foreign_ship.fade(w.time(), w.ship.waves);
    } else {
        w.foreign_ship.move(w.time(), w.ship);
    }
    w.call_foreign_drive(log);
    w.pull = {};
    if (!finite(w.ship)) return false;
    w.look_at_rest();

    if (!w.deck.step(w.deck_tick(log))) return false;
    w.substeps = w.deck.substeps();
    for (const Bower& bower : w.deck.bowers()) {
        w.pull.force += bower.pull.force;
        w.pull.moment += bower.pull.moment;
    }
    w.anchor_watch.look(w.def.ship, w.ship, dt, log);
    w.ground_watch.look(w.def.ship, w.environment, w.ship, dt, log);
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
                w.take(order);
            } else if constexpr (std::is_same_v<Order, FaultOrder>) {
                w.catch_up();
                w.faults.order(order, w.time(), log);
            } else if constexpr (std::is_same_v<Order, EnvironmentOrder>) {
                w.catch_up();
                w.weather.order(order.weather, order.ramp);
                w.lay_weather_now();
                w.sea.order(sea_of(order.weather), w.time(), order.ramp);
                log("environment.changed", -1, order.weather.wind_speed,
                    order.ramp > 0 ? "weather is being changed by the instructor"
                                   : "weather changed by the instructor");
            } else if constexpr (std::is_same_v<Order, ReportMade>) {
                w.take(order, log);
            } else if constexpr (std::is_same_v<Order, BridgeOrderGiven>) {
                w.take(order, log);
            } else if constexpr (std::is_same_v<Order, WatchCircleOrder>) {
                w.anchor_watch.order(order, log);
            } else if constexpr (std::is_same_v<Order, LightsAndShapes>) {
                show(order, w.lights_and_shapes, log);
            } else if constexpr (std::is_same_v<Order, ChanceDrawn>) {
                w.faults.draw(order);
            } else if constexpr (std::is_same_v<Order, OwnShipSample>) {
                w.take(order, log);
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
    return world_->helm;
}

void Exercise::visit_state(ConstStateVisitor& v) const {
    const World& world = *world_;
    World::list_state(v, world);
}

void Exercise::visit_state(StateVisitor& v) {
    World::list_state(v, *world_);
}

void Exercise::view(Snapshot& s) const {
    const World& w = *world_;
    s.tick = w.tick;
    s.time = w.time();
    const Vec3 bow = hawse_position(w.def.ship, w.ship, 0);
    s.environment.depth = w.environment.level - bed_height(w.environment, bow.x(), bow.y());
    s.environment.now = w.weather.now();
    s.environment.now.tide_height = w.environment.level;
    s.environment.after = w.weather.after();
    s.environment.ramp_left = w.weather.left();
    s.environment.gust = w.environment.wind_speed - s.environment.now.wind_speed;
    s.environment.swing = w.environment.wind_from - s.environment.now.wind_from;
    s.sea.ramp_begin = w.sea.ramp_begin();
    s.sea.ramp_end = w.sea.ramp_end();
    s.sea.waves.reserve(kMaxWaveComponents); // all that it may ever need, taken the first time
    s.sea.waves.assign(w.sea.components().begin(), w.sea.components().end());
    view_ship(w.ship, w.answers, s.ship);
    s.cable_force = w.pull.force;
    s.cable_moment = {0, 0, -w.pull.moment}; // clockwise seen from above is about the z axis downwards
    s.tackle.resize(w.deck.bowers().size());
    s.model_nodes = 0;
    s.model_level = w.deck.bowers().front().tackle.level();
    s.model_error = {};
    for (std::size_t k = 0; k < w.deck.bowers().size(); ++k) {
        const Bower& bower = w.deck.bowers()[k];
        s.tackle[k].side = bower.side;
        s.tackle[k].hawse = hawse_position(w.def.ship, w.ship, outboard(bower.side));
        s.tackle[k].force = bower.pull.force;
        s.cable_moment.head<2>() += bower.moment.head<2>();
        view_anchor(bower.tackle, bower.event_detector.phase(), w.environment, s.tackle[k].anchor);
        view_chain(bower.tackle, w.ship.heading, w.environment, s.tackle[k].chain);
        view_windlass(bower.tackle, bower.levers, w.faults.causes(bower.side), s.tackle[k].windlass);
        const ChainState& chain = bower.tackle.chain();
        s.model_nodes += static_cast<unsigned>(chain.links + 1 - chain.asleep);
        // What is shown is the dearest level in use and the largest error.
        s.model_level = std::min(s.model_level, bower.tackle.level());
        s.model_error = worse(s.model_error, bower.tackle.error(w.environment));
    }
    over_water(w.environment.level, s);
    StateHash hash;
    visit_state(hash);
    s.state_hash = hash.value();
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
