// Every field of the exercise's picture is hidden from the seats or seen by one: what is hidden leaves the
// bytes of their views as they are. A field that is new stands in neither list, and is missed.

#include "tests/perceive/ships.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace windlass::perceive {
namespace {

using exercise::AnchorPhase;
using exercise::AnchorView;
using exercise::ChainView;
using exercise::EnvironmentView;
using exercise::FaultCode;
using exercise::FaultPhase;
using exercise::MarkView;
using exercise::ShipView;
using exercise::Snapshot;
using exercise::TackleView;
using exercise::Weather;
using exercise::WindlassView;

// How many members a struct has: as many as it can be made of.
struct Anything {
    template <class T>
    operator T() const; // NOLINT: never called
};
template <class T, class... Members>
consteval std::size_t members() {
    if constexpr (requires { T{Members{}..., Anything{}}; })
        return members<T, Members..., Anything>();
    else
        return sizeof...(Members);
}

enum class Kept {
    hidden,
    above, ///< seen of an anchor that is above the water, hidden of one that is below
    seen,
    part ///< sorted member by member
};

struct Field {
    std::string name;
    Kept kept;
    std::function<void(Snapshot&)> change;
};

// Another value of any kind, as far from the old one as no step is wide.
void change(double& x) {
    x = 3 * x + 1000.25;
}
void change(bool& x) {
    x = !x;
}
template <class Integer>
requires std::is_integral_v<Integer>
void change(Integer& x) {
    x += 7;
}
template <class Enum>
requires std::is_enum_v<Enum>
void change(Enum& x) {
    x = static_cast<Enum>(x == Enum{} ? 1 : 0);
}
void change(physics::Vec3& x) {
    x += physics::Vec3(3, 5, -7);
}
void change(Eigen::Quaterniond& x) {
    x = x * Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized());
}
void change(std::vector<Eigen::Vector3f>& nodes) {
    nodes.at(1).x() += 1;
}
void change(std::vector<float>& tensions) {
    for (float& tension : tensions)
        tension *= 3;
}
void change(std::vector<MarkView>& marks) {
    marks.at(5).shackle += 1;
} // on deck
void change(std::vector<physics::CurrentLayer>& profile) {
    profile = {{.depth = 0, .share = 3, .turn = 1}};
}
void change(std::vector<exercise::BridgeOrderView>& orders) {
    orders.emplace_back();
}
void change(std::vector<exercise::ExerciseEvent>& events) {
    events.emplace_back().code = "anchor.dragging";
}
void change(exercise::WatchCircleOrder& circle) {
    circle = {true, 1, 2, 300};
}
void change(exercise::LightsAndShapes& shown) {
    shown = {true, true};
}
void change(physics::ModelError& error) {
    error.load += 1, error.shape += 1;
}
void change(physics::StepCounts& counts) {
    counts.implicit += 100;
}
void change(exercise::SeaView& sea) {
    sea.ramp_end += 1;
    sea.waves.emplace_back();
}
void change(Weather& weather) {
    weather.wind_speed += 30;
}
void change(std::vector<exercise::FaultView>& faults) {
    faults.resize(2);
    faults[0].order.code = FaultCode::brake_lining_glazed;
    faults[0].phase = FaultPhase::active;
    faults[0].severity_now = 1;
    faults[1].order.code = FaultCode::load_cell_bias;
}

Snapshot& snapshot(Snapshot& s) {
    return s;
}
EnvironmentView& environment(Snapshot& s) {
    return s.environment;
}
Weather& now(Snapshot& s) {
    return s.environment.now;
}
ShipView& ship(Snapshot& s) {
    return s.ship;
}
TackleView& tackle(Snapshot& s) {
    return s.tackle.at(0);
}
AnchorView& anchor(Snapshot& s) {
    return s.tackle.at(0).anchor;
}
ChainView& chain(Snapshot& s) {
    return s.tackle.at(0).chain;
}
WindlassView& windlass(Snapshot& s) {
    return s.tackle.at(0).windlass;
}

#define HIDDEN(of, member)                                                                                   \
    Field {                                                                                                  \
#of "." #member, Kept::hidden, [](Snapshot & s) { change(of(s).member); }                            \
    }
#define ABOVE(of, member)                                                                                    \
    Field {                                                                                                  \
#of "." #member, Kept::above, [](Snapshot & s) { change(of(s).member); }                             \
    }
#define SEEN(of, member)                                                                                     \
    Field {                                                                                                  \
#of "." #member, Kept::seen, [](Snapshot & s) { change(of(s).member); }                              \
    }
#define PART(of, member)                                                                                     \
    Field {                                                                                                  \
#of "." #member, Kept::part, {}                                                                      \
    }

const std::vector<Field>& fields() {
    static const std::vector<Field> list{
        SEEN(snapshot, tick),
        SEEN(snapshot, time),
        HIDDEN(snapshot, state_hash),
        HIDDEN(snapshot, outside_watch_circle),
        PART(snapshot, environment),
        HIDDEN(snapshot, sea), // it is a topic of its own
        PART(snapshot, ship),
        HIDDEN(snapshot, cable_force),
        HIDDEN(snapshot, cable_moment),
        PART(snapshot, tackle),
        HIDDEN(snapshot, faults),        // those of the bridge's own instruments: view_test
        HIDDEN(snapshot, bridge_orders), // they have a topic of their own
        HIDDEN(snapshot, watch_circle),
        HIDDEN(snapshot, lights_and_shapes), // they have a topic of their own
        HIDDEN(snapshot, events),            // as SeatEvent: event_test
        HIDDEN(snapshot, model_level),
        HIDDEN(snapshot, model_error),
        HIDDEN(snapshot, model_nodes),
        HIDDEN(snapshot, model_substeps),
        HIDDEN(snapshot, model_steps),
        HIDDEN(snapshot, model_in_doubt),

        SEEN(environment, depth), // echo sounder
        PART(environment, now),
        HIDDEN(environment, after),
        HIDDEN(environment, ramp_left),
        SEEN(environment, gust), // anemometer
        SEEN(environment, swing),

        SEEN(now, wind_speed),
        SEEN(now, wind_from),
        HIDDEN(now, gust_factor),
        HIDDEN(now, gust_period),
        HIDDEN(now, veering),
        HIDDEN(now, wave_height), // the sea itself is SeaState
        HIDDEN(now, wave_period),
        HIDDEN(now, wave_from),
        HIDDEN(now, swell_height),
        HIDDEN(now, swell_period),
        HIDDEN(now, swell_from),
        HIDDEN(now, wave_seed),
        SEEN(now, current_speed), // log
        SEEN(now, current_towards),
        SEEN(now, current_profile),
        HIDDEN(now, tide_height),
        SEEN(now, visibility),
        SEEN(now, time_of_day),

        SEEN(ship, position),
        SEEN(ship, attitude),
        SEEN(ship, heading),
        SEEN(ship, velocity),
        SEEN(ship, surge),
        HIDDEN(ship, sway), // the log is one of one axis
        SEEN(ship, yaw_rate),
        SEEN(ship, engine),
        SEEN(ship, rudder),
        SEEN(ship, bow_thruster),
        SEEN(ship, stern_thruster),
        SEEN(ship, engine_ordered),
        SEEN(ship, rudder_ordered),
        SEEN(ship, bow_thruster_ordered),
        SEEN(ship, stern_thruster_ordered),

        SEEN(tackle, side),
        PART(tackle, anchor),
        PART(tackle, chain),
        PART(tackle, windlass),
        PART(tackle, deck_work), // how long it takes in steps: view_test
        HIDDEN(tackle, hawse),
        HIDDEN(tackle, force),

        PART(anchor, phase), // view_test: home, a'cockbill and the tremor of dragging alone
        ABOVE(anchor, position),
        ABOVE(anchor, attitude),
        HIDDEN(anchor, velocity),
        HIDDEN(anchor, shackle),
        HIDDEN(anchor, height_above_bottom),
        HIDDEN(anchor, holding_capacity),
        HIDDEN(anchor, holding_used),
        HIDDEN(anchor, uplift),
        HIDDEN(anchor, embedment),
        HIDDEN(anchor, dragged),
        HIDDEN(anchor, soil),
        ABOVE(anchor, fluke_angle),
        ABOVE(anchor, weight), // both as mud
        ABOVE(anchor, carried),
        HIDDEN(anchor, breakout),
        HIDDEN(anchor, bent),
        ABOVE(anchor, fouled),

        HIDDEN(chain, cable_out),
        SEEN(chain, lead_clock),
        SEEN(chain, top_angle),
        HIDDEN(chain, on_bottom),
        HIDDEN(chain, turns),
        HIDDEN(chain, largest_tension),
        HIDDEN(chain, stretched),
        HIDDEN(chain, stretch),
        HIDDEN(chain, stay),
        SEEN(chain, nodes), // above water: view_test
        HIDDEN(chain, tension),
        SEEN(chain, marks), // in sight: view_test

        HIDDEN(windlass, hawse_tension),
        HIDDEN(windlass, gypsy_load),
        SEEN(windlass, gypsy_load_indicated),
        HIDDEN(windlass, brake_load),
        HIDDEN(windlass, stopper_load),
        HIDDEN(windlass, motor_load),
        HIDDEN(windlass, shaft_brake_load),
        HIDDEN(windlass, bitter_end_load),
        HIDDEN(windlass, spurling_pipe_load),
        HIDDEN(windlass, locker_load),
        SEEN(windlass, breaking_load), // certificate
        HIDDEN(windlass, brake_capacity),
        SEEN(windlass, brake_rating), // plate
        HIDDEN(windlass, lining_friction),
        HIDDEN(windlass, cable_out),
        SEEN(windlass, cable_out_indicated),
        SEEN(windlass, cable_speed_indicated),
        SEEN(windlass, cable_speed), // in steps
        HIDDEN(windlass, gypsy_speed),
        SEEN(windlass, gypsy_turn),
        SEEN(windlass, brake_position),
        HIDDEN(windlass, brake_torque),
        PART(windlass, brake_power), // heard in steps: view_test
        HIDDEN(windlass, brake_energy),
        HIDDEN(windlass, brake_wear),
        SEEN(windlass, lining_temperature), // smelt in steps: view_test
        HIDDEN(windlass, drum_temperature),
        HIDDEN(windlass, motor_torque),
        SEEN(windlass, motor_speed), // heard in steps
        SEEN(windlass, motor_current),
        PART(windlass, motor_pressure), // in steps: view_test
        HIDDEN(windlass, motor_temperature),
        SEEN(windlass, speed_lever),
        SEEN(windlass, power),
        SEEN(windlass, tripped),
        SEEN(windlass, emergency_stop),
        SEEN(windlass, stopper_closed),
        SEEN(windlass, clutch),
        SEEN(windlass, clutch_offset),
        HIDDEN(windlass, clutch_sheared), // the motor turns and the gypsy does not
        SEEN(windlass, gypsy_jumping),
        SEEN(windlass, stopper_sprung),
        SEEN(windlass, motor_burst),
    };
    return list;
}

std::string all_bytes(const Snapshot& s, const SeatAids& aids) {
    return bytes(forecastle(s, aids)) + bytes(bridge(s));
}

std::string after(Snapshot s, const Field& field, const SeatAids& aids) {
    field.change(s);
    return all_bytes(s, aids);
}

constexpr SeatAids kNothingFitted{.counter = false, .load_cell = false};

TEST(Secrecy, EveryFieldIsSorted) {
    const auto sorted = [](const std::string& of) {
        return static_cast<std::size_t>(std::ranges::count_if(
            fields(), [&](const Field& field) { return field.name.starts_with(of + "."); }));
    };
    EXPECT_EQ(sorted("snapshot"), members<Snapshot>());
    EXPECT_EQ(sorted("environment"), members<EnvironmentView>());
    EXPECT_EQ(sorted("now"), members<Weather>());
    EXPECT_EQ(sorted("ship"), members<ShipView>());
    EXPECT_EQ(sorted("tackle"), members<TackleView>());
    EXPECT_EQ(sorted("anchor"), members<AnchorView>());
    EXPECT_EQ(sorted("chain"), members<ChainView>());
    EXPECT_EQ(sorted("windlass"), members<WindlassView>());
    EXPECT_EQ(members<MarkView>(), 5U) << "is the new one in sight? view_test, Marks";
}

TEST(Secrecy, WhatIsHiddenLeavesTheBytesAsTheyAre) {
    for (const Field& field : fields()) {
        if (field.kept != Kept::hidden) continue;
        for (const SeatAids& aids : {SeatAids{}, kNothingFitted}) {
            EXPECT_EQ(after(riding(), field, aids), all_bytes(riding(), aids)) << field.name;
            EXPECT_EQ(after(weighing(), field, aids), all_bytes(weighing(), aids)) << field.name;
        }
    }
}

TEST(Secrecy, WhatTheAnchorIsUnderWaterIsHidden) {
    for (const Field& field : fields()) {
        if (field.kept != Kept::above) continue;
        EXPECT_EQ(after(riding(), field, {}), all_bytes(riding(), {})) << field.name;
        EXPECT_NE(after(weighing(), field, {}), all_bytes(weighing(), {})) << field.name;
    }
}

TEST(Secrecy, WhatIsSeenIsIndeed) {
    for (const Field& field : fields())
        if (field.kept == Kept::seen) {
            EXPECT_NE(after(riding(), field, {}), all_bytes(riding(), {})) << field.name;
        }
}

TEST(Secrecy, CameraShowsWindlassAndCableOnDeckAndNothingElse) {
    const std::set<std::string> in_picture{"snapshot.tick",
                                           "snapshot.time",
                                           "tackle.side",
                                           "chain.marks",
                                           "windlass.cable_speed",
                                           "windlass.gypsy_turn",
                                           "windlass.brake_position",
                                           "windlass.speed_lever",
                                           "windlass.clutch",
                                           "windlass.gypsy_jumping",
                                           "windlass.stopper_closed",
                                           "windlass.stopper_sprung",
                                           "windlass.lining_temperature"}; // as smoke and flames
    std::set<std::string> found;
    for (const Field& field : fields()) {
        if (!field.change) continue;
        for (const Snapshot& before : {riding(), weighing()}) {
            Snapshot after = before;
            field.change(after);
            if (bytes(camera(after)) != bytes(camera(before))) found.insert(field.name);
        }
    }
    EXPECT_EQ(found, in_picture);
}

TEST(Secrecy, GhostHasLeversAndTheSeatsOwnGaugesAndNothingElse) {
    const std::set<std::string> shown{"snapshot.tick",
                                      "snapshot.time",
                                      "tackle.side",
                                      "ship.velocity",
                                      "ship.engine",
                                      "ship.rudder",
                                      "ship.bow_thruster",
                                      "ship.stern_thruster",
                                      "windlass.cable_speed", // as it is seen
                                      "windlass.brake_position",
                                      "windlass.speed_lever",
                                      "windlass.clutch",
                                      "windlass.stopper_closed",
                                      "windlass.cable_out_indicated",
                                      "windlass.cable_speed_indicated",
                                      "windlass.gypsy_load_indicated"};
    const auto ghost = [](const Snapshot& s) {
        ForecastleView forecastle;
        perceive_forecastle_ghost(s, s.tackle.at(0), some_ship(), {}, forecastle);
        BridgeView bridge;
        perceive_bridge_ghost(s, some_ship(), bridge);
        return bytes(forecastle) + bytes(bridge);
    };
    std::set<std::string> found;
    for (const Field& field : fields()) {
        if (!field.change) continue;
        for (const Snapshot& before : {riding(), weighing()}) {
            Snapshot after = before;
            field.change(after);
            if (ghost(after) != ghost(before)) found.insert(field.name);
        }
    }
    EXPECT_EQ(found, shown);
}

TEST(Secrecy, CameraSmellsNothing) {
    Snapshot s = riding();
    s.tackle[0].windlass.lining_temperature = 500; // it smells
    ASSERT_EQ(forecastle(s).lining(), LINING_SMELLS);
    EXPECT_EQ(bytes(camera(s)), bytes(camera(riding())));
    s.tackle[0].windlass.lining_temperature = 600;
    EXPECT_EQ(camera(s).lining(), LINING_SMOKES);
}

TEST(Secrecy, CameraShowsMenAtWorkAndNotWhatOthersWaitForNorHowLong) {
    using enum words::DeckHindrance;
    const auto at = [](const exercise::DeckWorkView& work) {
        Snapshot s = riding();
        s.tackle[0].deck_work = work;
        return camera(s);
    };
    const auto broken = exercise::DeckWork::break_cable;
    EXPECT_EQ(at({broken, 411.2, none}).deck_work(), DECK_WORK_BREAK_CABLE);
    EXPECT_EQ(bytes(at({broken, 411.2, none})), bytes(at({broken, 20, none})));
    for (const exercise::DeckWorkView& idle :
         {exercise::DeckWorkView{broken, 411.2, stopper_off}, exercise::DeckWorkView{broken, 0, none}})
        EXPECT_EQ(bytes(at(idle)), bytes(camera(riding())));
}

TEST(Secrecy, CameraTellsNoPlaceByItsMarks) {
    const ForecastleView picture = camera(riding());
    ASSERT_FALSE(picture.marks().empty()); // the sixth is on deck
    for (const CableMark& mark : picture.marks()) {
        EXPECT_LE(mark.outboard(), 0);
        EXPECT_EQ(mark.position(), Point3f());
    }
}

TEST(Secrecy, GaugesThatAreNotFittedShowNothing) {
    Snapshot s = riding();
    s.tackle[0].windlass.gypsy_load_indicated = 9e5;
    s.tackle[0].windlass.cable_out_indicated = 99;
    s.tackle[0].windlass.cable_speed_indicated = 3;
    EXPECT_EQ(all_bytes(s, kNothingFitted), all_bytes(riding(), kNothingFitted));
}

TEST(Secrecy, CableUnderWaterIsHiddenHoweverMuchOfItThereIs) {
    Snapshot s = riding();
    auto& nodes = s.tackle[0].chain.nodes;
    const auto first_below = static_cast<std::size_t>(
        std::ranges::find_if(nodes, [](const auto& node) { return node.z() < -1.5F; }) - nodes.begin());
    for (std::size_t i = first_below + 1; i < nodes.size(); ++i)
        nodes[i] += Eigen::Vector3f(4, -3, -2);
    nodes.resize(nodes.size() + 60, nodes.back());
    s.tackle[0].chain.tension.resize(nodes.size() - 1, 7e5F);
    s.tackle[0].chain.cable_out = s.tackle[0].windlass.cable_out += 60;
    EXPECT_EQ(all_bytes(s, {}), all_bytes(riding(), {}));
}

TEST(Secrecy, WhatTheAnchorDoesOnTheBottomIsHiddenButForTheTremorOfDragging) {
    const std::string before = all_bytes(riding(), {});
    for (const AnchorPhase phase :
         {AnchorPhase::hanging, AnchorPhase::on_bottom, AnchorPhase::digging_in, AnchorPhase::holding,
          AnchorPhase::aweigh, AnchorPhase::fouled, AnchorPhase::lost}) {
        Snapshot s = riding();
        s.tackle[0].anchor.phase = phase;
        EXPECT_EQ(all_bytes(s, {}), before) << static_cast<int>(phase);
    }
    Snapshot s = riding();
    s.tackle[0].anchor.phase = AnchorPhase::dragging;
    ForecastleView felt = forecastle(s);
    EXPECT_EQ(felt.vibration(), 1);
    felt.vibration(0);
    EXPECT_EQ(bytes(felt), bytes(forecastle(riding())));
    EXPECT_EQ(bytes(bridge(s)), bytes(bridge(riding())));
}

TEST(Secrecy, MarksOutOfSightAreHidden) {
    Snapshot s = riding(); // the sixth is on deck, the fifth under water, the seventh in the locker
    for (MarkView& mark : s.tackle[0].chain.marks) {
        if (mark.shackle == 6) continue;
        mark.outboard += mark.outboard > 0 ? 0.3 : -0.3;
        mark.white_links += 1;
        mark.last = !mark.last;
        mark.shackle += 1;
        if (mark.outboard > 0) mark.position += Eigen::Vector3f(1, 1, -1);
    }
    EXPECT_EQ(all_bytes(s, {}), all_bytes(riding(), {}));
}

} // namespace
} // namespace windlass::perceive
