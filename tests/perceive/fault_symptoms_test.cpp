// Every fault is brought in, shows by a symptom on a topic that a seat hears, and is gone when it is cleared.

#include "server/config/config.hpp"
#include "server/perceive/perceive.hpp"
#include "words/words.hpp"

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>

namespace windlass::perceive {
namespace {

using exercise::ExerciseDef;
using exercise::FaultCode;
using rigs::Drill;

// ------------------------------------------------------------------ what a seat has of a drill

ForecastleView forecastle_of(const Drill& drill) {
    ForecastleView view;
    perceive_forecastle(drill.now(), drill.now().tackle[0], seat_ship(drill.exercise().def()), {}, view);
    return view;
}

BridgeView bridge_of(const Drill& drill) {
    BridgeView view;
    perceive_bridge(drill.now(), seat_ship(drill.exercise().def()), view);
    return view;
}

/// Times that a seat noticed an event of this code.
double noticed(const Drill& drill, const std::string& code) {
    return static_cast<double>(
        std::count_if(drill.log().begin(), drill.log().end(), [&](const exercise::ExerciseEvent& event) {
            const auto seen = perceive_event(event, drill.now());
            return seen && seen->code().to_string() == code;
        }));
}

// ------------------------------------------------------------------ ships

/// Anchor hanging clear of the bottom on the brake.
ExerciseDef hanging() {
    return rigs::quiet_def(60, 25);
}

ExerciseDef hydraulic() {
    ExerciseDef def = rigs::quiet_def(200, 60);
    def.tackle[0].windlass =
        config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/walk_back_60m.json").tackle[0].windlass;
    return def;
}

/// 275 kN at the gypsy while heaving.
ExerciseDef heavy() {
    return rigs::quiet_def(200, 110);
}

/// 370 kN while heaving: three quarters of what the motor is rated for.
ExerciseDef heaviest() {
    return rigs::quiet_def(250, 170);
}

ExerciseDef near_the_end() {
    ExerciseDef def = rigs::quiet_def(325, 311.8);
    def.tackle[0].windlass.bitter_end_strength = 1.35e6; // 30 % of the breaking load
    return def;
}

// ------------------------------------------------------------------ work, and what is seen of it

double counter(const Drill& drill) {
    return forecastle_of(drill).cable_out_indicated();
}

/// m by the counter that run out in so many seconds of it; negative: hove in.
double run_out(Drill& drill, double seconds) {
    const double before = counter(drill);
    drill.run(seconds);
    return counter(drill) - before;
}

double on_a_tenth_of_the_brake(Drill& drill) {
    drill.grip(0.055); // holds the anchor that hangs there, and a fifth more
    return run_out(drill, 15);
}
double brake_off(Drill& drill) {
    drill.brake(0);
    return run_out(drill, 4);
}
void into_gear(Drill& drill) {
    drill.clutch(true);
    drill.run(4);
    drill.brake(0);
    drill.run(3);
}
double heave(Drill& drill) {
    into_gear(drill);
    drill.speed_lever(1);
    return run_out(drill, 15);
}
double heave_till_trip(Drill& drill) {
    into_gear(drill);
    drill.speed_lever(0.3);
    drill.run(250);
    return forecastle_of(drill).tripped();
}
double trips_while_heaving(Drill& drill) {
    into_gear(drill);
    drill.speed_lever(1);
    drill.run(2);
    return forecastle_of(drill).tripped();
}
double load_shown(Drill& drill) {
    drill.run(1);
    return forecastle_of(drill).gypsy_load_indicated();
}
double snubbed(Drill& drill) {
    drill.brake(0);
    drill.run(3);
    drill.emergency_stop(true); // its spring is quicker than a hand
    drill.run(4);
    return noticed(drill, "cable.slack");
}
double onto_the_stopper(Drill& drill) {
    drill.stopper(true);
    drill.run(2);
    return brake_off(drill);
}
double helm_ahead(Drill& drill) {
    drill.engine(0.5);
    drill.run(30);
    return bridge_of(drill).engine();
}
double let_go_and_fall_back(Drill& drill) {
    EXPECT_TRUE(rigs::let_go_and_pay_out(drill, 2));
    drill.run(40);
    drill.brake(0);
    drill.run_until([&] { return drill.chain().cable_out > 110; }, 120);
    drill.brake(1);
    drill.run(300);
    return bridge_of(drill).speed_over_ground();
}

// ------------------------------------------------------------------ the table

struct Symptom {
    FaultCode code;
    double severity;
    ExerciseDef (*ship)();
    std::function<double(Drill&)> seen; ///< works, and gives what a seat sees of it
    double differs;                     ///< by how much at least the fault shows in that
    /// Gone with the fault; a wet lining stays wet until work has dried it (BandBrake).
    bool heals = true;
};

const std::vector<Symptom>& symptoms() {
    const auto lever = [](auto read) {
        return [read](Drill& drill) {
            drill.brake(0.5);
            drill.clutch(true);
            drill.stopper(true);
            drill.run(4);
            return static_cast<double>(read(forecastle_of(drill)));
        };
    };
    static const std::vector<Symptom> table{
        {FaultCode::brake_lining_faded, 0.9, hanging, on_a_tenth_of_the_brake, 1},
        {FaultCode::motor_power_lost, 1, hanging, heave, 1},
        {FaultCode::clutch_jumps_out, 1, hanging, heave, 1},
        {FaultCode::load_cell_dead, 1, hanging, load_shown, 5e4},
        {FaultCode::brake_lining_worn, 1, hanging, on_a_tenth_of_the_brake, 1},
        {FaultCode::brake_wet, 1, hanging, on_a_tenth_of_the_brake, 1, false},
        {FaultCode::stopper_pin_out, 1, hanging, onto_the_stopper, 1},
        {FaultCode::hydraulic_pump_lost, 0.5, hydraulic, heave, 0.5},
        {FaultCode::hydraulic_hose_burst, 1, hydraulic, heave, 1},
        {FaultCode::drive_trip, 1, hanging, trips_while_heaving, 1},
        {FaultCode::blackout, 1, hanging, heave, 1},
        {FaultCode::clutch_shaft_damaged, 0.97, hanging, heave, 1},
        {FaultCode::gypsy_pockets_worn, 1, hanging,
         [](Drill& drill) {
             drill.run(2);
             return static_cast<double>(forecastle_of(drill).gypsy_jumping());
         },
         1},
        {FaultCode::spurling_pipe_jammed, 0.06, hanging, brake_off, 1},
        {FaultCode::chain_link_weak, 0.97, hanging, snubbed, 1},
        {FaultCode::joining_shackle_open, 0.93, heavy, snubbed, 1},
        {FaultCode::bitter_end_weak, 0.9, near_the_end,
         [](Drill& drill) {
             drill.brake(0);
             drill.run(15);
             return noticed(drill, "cable.bitter_end_parted");
         },
         1},
        {FaultCode::chain_counter_drift, 1, hanging, brake_off, 1},
        {FaultCode::soil_poor, 1, rigs::let_go_def, let_go_and_fall_back, 0.15},
        {FaultCode::cctv_lost, 1, hanging,
         [](Drill& drill) { return static_cast<double>(bridge_of(drill).cctv_works()); }, 1},
        {FaultCode::vhf_lost, 1, hanging,
         [](Drill& drill) { return static_cast<double>(bridge_of(drill).vhf_works()); }, 1},
        {FaultCode::brake_lining_glazed, 1, hanging, on_a_tenth_of_the_brake, 0.3},
        {FaultCode::brake_seized, 1, hanging, lever([](const auto& view) { return view.brake_position(); }),
         0.4},
        {FaultCode::clutch_seized, 1, hanging, lever([](const auto& view) { return view.clutch(); }), 1},
        {FaultCode::stopper_jammed, 1, hanging, lever([](const auto& view) { return view.stopper_closed(); }),
         1},
        {FaultCode::overload_relay_misset, 1, heaviest, heave_till_trip, 1},
        {FaultCode::phase_lost, 1, heavy, heave, 1},
        {FaultCode::flukes_seized, 1, rigs::let_go_def, let_go_and_fall_back, 0.15},
        {FaultCode::load_cell_bias, 0.5, hanging, load_shown, 3e4},
        {FaultCode::telegraph_failed, 1, hanging, helm_ahead, 0.3},
        {FaultCode::ship_blackout, 1, hanging, helm_ahead, 0.3},
    };
    return table;
}

/// Shown elsewhere. Three of the motor that the cable drives, each hidden by what the others still do:
/// Accident.*Motor* and Accident.ProtectionSaves*. Under water, seen by work of half an hour:
/// FoulAnchor.HeavingOn*, Turns.Wedge*, Holding.* and Anchor.*.
const std::set<FaultCode> kElsewhere{FaultCode::overspeed_protection_lost,
                                     FaultCode::counterbalance_stuck_open, FaultCode::relief_valve_low,
                                     FaultCode::anchor_fouled, FaultCode::cable_twisted};

class FaultSymptoms : public testing::TestWithParam<Symptom> {};

TEST_P(FaultSymptoms, IsSeenAndGoneWhenItIsCleared) {
    const Symptom& row = GetParam();
    const ExerciseDef def = row.ship();
    const bool while_it_works =
        row.code == FaultCode::drive_trip; // tripped at rest, the lever at zero resets it
    const auto order = exercise::FaultOrder{.code = row.code, .severity = row.severity};
    exercise::FaultOrder armed = order;
    if (while_it_works) {
        armed.trigger = exercise::FaultTrigger::at_time;
        armed.trigger_value = 10.5;
    }

    Drill sound(def), faulty(def), cleared(def);
    for (Drill* drill : {&sound, &faulty, &cleared})
        drill->run(1);
    faulty.give(armed);
    cleared.give(order);
    for (Drill* drill : {&sound, &faulty, &cleared})
        drill->run(while_it_works ? 1 : 6); // a lining takes 5 s to be wet through
    cleared.clear(row.code);
    cleared.run(1);

    const double without = row.seen(sound), with = row.seen(faulty), after = row.seen(cleared);
    EXPECT_GE(std::abs(with - without), row.differs) << without << " becomes " << with;
    if (row.heals) {
        EXPECT_LE(std::abs(after - without), 0.25 * row.differs) << without << " becomes again " << after;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryFault, FaultSymptoms, testing::ValuesIn(symptoms()), [](const auto& info) {
    std::string name{words::row_of(info.param.code).name};
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(FaultSymptomsTable, HasARowForEveryFaultOfTheModel) {
    for (int k = 0; k < exercise::kFaultCodes; ++k) {
        const auto code = static_cast<FaultCode>(k);
        const auto rows = std::count_if(symptoms().begin(), symptoms().end(),
                                        [&](const Symptom& symptom) { return symptom.code == code; });
        EXPECT_EQ(rows, kElsewhere.contains(code) ? 0 : 1) << words::row_of(code).name;
    }
}

TEST(FaultSymptomsTable, StandsInTheInstructorsGuide) {
    std::ifstream file(WINDLASS_SOURCE_DIR "/docs/instructor.md");
    const std::string guide{std::istreambuf_iterator<char>(file), {}};
    for (const words::Fault& row : words::kFaultCode) {
        std::string line = "| `" + std::string(row.name) + "`" + (row.both_sides ? " (both sides)" : "");
        for (const std::string_view cell : {row.symptom, row.reason, row.way_out, row.severity})
            line += " | " + std::string(cell);
        line += " |\n";
        EXPECT_NE(guide.find(line), std::string::npos) << line;
    }
}

TEST(ShipBlackout, LeavesTheRudderWhereItIsUntilTheEmergencySupplySteersHer) {
    Drill drill(hanging());
    drill.give(exercise::HelmOrder{.engine = 0.5, .bow_thruster = 0.5});
    drill.run(20);
    drill.give(exercise::FaultOrder{.code = FaultCode::ship_blackout});
    drill.give(exercise::HelmOrder{.engine = 0.5, .rudder = 0.4, .bow_thruster = 0.5});
    drill.run(40);
    EXPECT_EQ(bridge_of(drill).rudder(), 0);
    EXPECT_EQ(bridge_of(drill).bow_thruster(), 0);
    EXPECT_NEAR(bridge_of(drill).engine(), 0, 0.01);
    EXPECT_FALSE(forecastle_of(drill).power());
    drill.run(20); // 60 s
    EXPECT_NEAR(bridge_of(drill).rudder(), 0.4, 1e-3);
    EXPECT_NEAR(bridge_of(drill).engine(), 0, 0.01);
    drill.clear(FaultCode::ship_blackout);
    drill.run(60);
    EXPECT_NEAR(bridge_of(drill).engine(), 0.5, 0.01);
}

} // namespace
} // namespace windlass::perceive
