#include "server/exercise/exercise.hpp"

#include "server/exercise/faults.hpp"
#include "server/exercise/lookout.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/exercise/views.hpp"
#include "server/physics/ground_tackle.hpp"
#include "server/physics/hull_surface.hpp"
#include "server/physics/ship.hpp"
#include "server/physics/state_fields.hpp"

#include <algorithm>
#include <stdexcept>

namespace windlass::exercise {

using namespace physics;

namespace {

double outboard(Side side) {
    return side == Side::port ? -1 : 1;
}

TackleSetup setup(const ExerciseDef& exercise, const GroundTackleDef& def) {
    return {.windlass = def.windlass,
            .chain = modelled_chain(exercise, def),
            .anchor = def.anchor,
            .cable_out = def.cable_out,
            .clutch_in = def.clutch_in,
            .stopper_closed = def.stopper_closed,
            .brake = def.brake,
            .budget = exercise.model.adaptive ? std::optional(exercise.model.budget) : std::nullopt};
}

/// So far the side passes inside the hawse pipe lip, m: the lip stands out by a link's width, so that chain
/// hanging from it is clear also where the bow's side runs aslant.
double lip_clearance(const ExerciseDef& def) {
    double width = 0;
    for (const GroundTackleDef& tackle : def.tackle)
        width = std::max(width, tackle.chain.contact_diameter);
    return width;
}

/// Takes over what a cable that lies against the hull does to it.
void add_hull_load(const ShipState& ship, const ContactLoad& load, CablePull& pull) {
    const Vec3 midships(ship.x, ship.y, 0);
    pull.force -= load.impulse;
    pull.moment +=
        (load.moment - midships.cross(load.impulse)).z(); // clockwise, and on the ship: twice turned
}

ShipState ship_start(const ShipStartDef& def) {
    ShipState ship;
    ship.x = def.x, ship.y = def.y, ship.heading = def.heading;
    ship.surge = def.surge, ship.sway = def.sway, ship.yaw_rate = def.yaw_rate;
    return ship;
}

/// One side: the machine, the hands on its levers, the eyes on it.
struct Station {
    Side side;
    GroundTackle tackle;
    Lookout lookout;
    WindlassLevers levers;
    ShipState from;       ///< where the ship was at the tackle's last step
    CablePull pull;       ///< of that step
    int waited = 0;       ///< ticks since
    bool touched = false; ///< levers moved since

    Station(const ExerciseDef& exercise, const GroundTackleDef& def, const Vec3& lip)
        : side(def.side),
          tackle(setup(exercise, def), exercise.environment, lip),
          lookout(def.side, tackle),
          levers{def.brake, 0, def.clutch_in, def.stopper_closed, false},
          from(ship_start(exercise.ship_start)) {}

    void visit_state(StateVisitor& v) {
        WINDLASS_STATE(v, tackle, lookout, levers, from, pull, waited, touched);
    }
};

} // namespace

struct Exercise::World {
    ExerciseDef def;
    EnvironmentDef environment;
    ShipState ship;
    Helm helm;
    CablePull pull; ///< of the last tick, which moves the ship in this one
    FaultBook faults;
    ObstacleMesh hull;
    std::vector<Station> stations;
    std::uint64_t tick = 0, events_called = 0;
    unsigned substeps = 1;
    std::vector<ExerciseEvent> events, waiting; ///< of the last tick; called between ticks

    explicit World(const ExerciseDef& d)
        : def(d),
          environment(d.environment),
          ship(ship_start(d.ship_start)),
          hull(hull_mesh(d.ship, lip_clearance(d))) {
        if (def.tackle.empty() || def.tackle.size() > 2)
            throw std::invalid_argument("an exercise has one or two cables");
        if (def.tackle.size() == 2 && def.tackle[0].side == def.tackle[1].side) {
            throw std::invalid_argument("the two cables of an exercise are on different sides");
        }
        stations.reserve(def.tackle.size());
        for (const GroundTackleDef& tackle : def.tackle) {
            stations.emplace_back(def, tackle, hawse_position(def.ship, ship, outboard(tackle.side)));
        }
    }

    double time() const { return static_cast<double>(tick) / def.tick_rate_hz; }

    void visit_state(StateVisitor& v) {
        WINDLASS_STATE(v, tick, events_called, substeps, environment, ship, helm, pull, faults);
        for (Station& station : stations)
            v.field({station.side == Side::port ? "port" : "starboard"}, station);
        std::size_t calls = waiting.size();
        v.field({"calls_waiting"}, calls);
        if (calls > 100000) throw std::length_error("more calls waiting than a tick's orders can make");
        waiting.resize(calls);
        for (ExerciseEvent& event : waiting) {
            auto& [called_at, time, number, severity, code, side, value, text] = event;
            WINDLASS_STATE(v, called_at, time, number, severity, code, side, value, text);
        }
    }

    bool work(Station& station, double seconds, const FaultBook::Log& log);

    FaultBook::Log log_to(std::vector<ExerciseEvent>& list) {
        return [this, &list](Severity severity, const char* code, int side, double value,
                             const std::string& text) {
            list.push_back({tick, time(), ++events_called, severity, code, side, value, text});
        };
    }
};

Exercise::Exercise(const ExerciseDef& def) : world_(std::make_unique<World>(def)) {}
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

bool Exercise::step(double dt) {
    World& w = *world_;
    ++w.tick;
    w.events.swap(w.waiting);
    w.waiting.clear();
    const FaultBook::Log log = w.log_to(w.events);

    // The ship moves under what the cables did to her in their last steps; the hawse pipes move with her.
    step_ship(w.def.ship, w.environment, w.helm, w.pull, dt, w.ship);
    w.pull = {};
    if (!finite(w.ship)) return false;

    w.substeps = 1;
    for (Station& station : w.stations) {
        ++station.waited;
        if (station.touched || station.waited >= station.tackle.stride(dt)) {
            if (!w.work(station, dt * station.waited, log)) return false;
        }
        w.pull.force += station.pull.force;
        w.pull.moment += station.pull.moment;
        const WindlassState& windlass = station.tackle.windlass().state();
        w.faults.watch(station.side,
                       {w.time(), windlass.cable_out, station.tackle.windlass().loads().deck.gypsy_load},
                       log);
    }
    return true;
}

/// Moves one side's ground tackle by so many seconds, up to where the ship is now. False when it ceased to be
/// finite.
bool Exercise::World::work(Station& station, double seconds, const FaultBook::Log& log) {
    const double side = outboard(station.side);
    const Vec3 from_lip = hawse_position(def.ship, station.from, side),
               lip = hawse_position(def.ship, ship, side);
    const WindlassCauses causes = faults.causes(station.side);

    const int steps = station.tackle.substeps(seconds, def.max_substeps);
    Vec3 force = Vec3::Zero();
    ContactLoad hull_load;
    for (int k = 1; k <= steps; ++k) {
        const Vec3 to = from_lip + (lip - from_lip) * (static_cast<double>(k) / steps);
        const HullSurface surface{&hull, hull_motion(station.from, ship, (k - 1.0) / steps, seconds), {}};
        station.tackle.step(environment, seconds / steps, station.levers, causes, to, &surface);
        force += station.tackle.pull_on_ship() / steps;
        hull_load.impulse += station.tackle.hull_load().impulse / steps;
        hull_load.moment += station.tackle.hull_load().moment / steps;
    }
    station.pull = {};
    add_pull(def.ship, ship, side, force, station.pull);
    add_hull_load(ship, hull_load, station.pull);
    substeps = std::max(substeps, static_cast<unsigned>(steps));
    station.from = ship;
    station.waited = 0;
    station.touched = false;
    station.lookout.watch(seconds, station.tackle, hawse_velocity(def.ship, ship, side).norm(), log);
    return station.tackle.finite();
}

void Exercise::apply(const Command& command) {
    World& w = *world_;
    const FaultBook::Log log = w.log_to(w.waiting);
    std::visit(
        [&](const auto& order) {
            using Order = std::decay_t<decltype(order)>;
            if constexpr (std::is_same_v<Order, WindlassOrder>) {
                for (Station& station : w.stations) {
                    if (station.side != order.side) continue;
                    const WindlassLevers levers{order.brake, order.speed_lever, order.clutch_in,
                                                order.stopper_closed, order.emergency_stop};
                    station.touched = station.touched || levers != station.levers;
                    station.levers = levers;
                }
            } else if constexpr (std::is_same_v<Order, HelmOrder>) {
                w.helm = {order.engine, order.rudder, order.bow_thruster, order.stern_thruster};
            } else if constexpr (std::is_same_v<Order, FaultOrder>) {
                w.faults.order(order, log);
            } else if constexpr (std::is_same_v<Order, EnvironmentOrder>) {
                w.environment.wind_speed = order.wind_speed, w.environment.wind_from = order.wind_from;
                w.environment.current_speed = order.current_speed,
                w.environment.current_towards = order.current_towards;
                log(Severity::info, "environment.changed", -1, order.wind_speed,
                    "wind and current changed by the instructor");
            } else if constexpr (std::is_same_v<Order, ReportMade>) {
                log(Severity::info, "report.made", order.side, order.value, report_text(order));
            }
        },
        command);
}

WindlassOrder Exercise::levers(Side side) const {
    WindlassOrder order{.side = side};
    for (const Station& station : world_->stations) {
        if (station.side != side) continue;
        const auto& [brake, speed, clutch_in, stopper_closed, emergency_stop] = station.levers;
        order = {side, brake, speed, clutch_in, stopper_closed, emergency_stop};
    }
    return order;
}

HelmOrder Exercise::helm() const {
    const auto& [engine, rudder, bow_thruster, stern_thruster] = world_->helm;
    return {engine, rudder, bow_thruster, stern_thruster};
}

void Exercise::visit_state(StateVisitor& v) {
    world_->visit_state(v);
}

void Exercise::view(Snapshot& s) const {
    World& w = *world_; // a hash goes through the state as a restore does, but changes nothing
    s.tick = w.tick;
    s.time = w.time();
    s.environment = {w.environment.depth, w.environment.wind_speed, w.environment.wind_from,
                     w.environment.current_speed, w.environment.current_towards};
    view_ship(w.ship, w.helm, s.ship);
    s.cable_force = w.pull.force;
    s.cable_moment = {0, 0, -w.pull.moment}; // clockwise seen from above is about the z axis downwards
    s.tackle.resize(w.stations.size());
    s.model_nodes = 0;
    s.model_level = w.stations.front().tackle.level();
    s.model_error = {};
    for (std::size_t k = 0; k < w.stations.size(); ++k) {
        const Station& station = w.stations[k];
        s.tackle[k].side = station.side;
        view_anchor(station.tackle, station.lookout.phase(), w.environment, s.tackle[k].anchor);
        view_chain(station.tackle, w.ship.heading, w.environment, s.tackle[k].chain);
        view_windlass(station.tackle, station.levers, w.faults.causes(station.side), s.tackle[k].windlass);
        const ChainState& chain = station.tackle.chain();
        s.model_nodes += static_cast<unsigned>(chain.links + 1 - chain.asleep);
        // What is shown is the dearest level in use and the largest error.
        s.model_level = std::min(s.model_level, station.tackle.level());
        const ModelError error = station.tackle.error(w.environment);
        s.model_error.load = std::max(s.model_error.load, error.load);
        s.model_error.shape = std::max(s.model_error.shape, error.shape);
    }
    StateHash hash;
    w.visit_state(hash);
    s.state_hash = hash.value();
    s.faults = w.faults.list();
    s.events = w.events;
    s.model_substeps = w.substeps;
}

} // namespace windlass::exercise
