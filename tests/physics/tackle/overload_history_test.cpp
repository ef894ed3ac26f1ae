// What loads do to a cable for good: it stretches beyond what it was proved to, is longer from then on, and
// parts at its weakest link.

#include "rigs/tackle_rig.hpp"
#include "server/physics/chain/chain_feed.hpp"
#include "server/physics/chain/overload_history.hpp"
#include "tests/physics/exercise_step.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

namespace windlass::physics {
namespace {

ChainDef chain_78mm() {
    return stud_link_chain(0.078, Grade::k3, 330);
}

/// Chain between a fixed foot and a top that is drawn away from it, as in a testing machine.
struct TestingMachine {
    ChainRig rig;
    std::vector<LinkCondition> condition;
    OverloadHistory strain;
    Parting parting;
    double work = 0;   ///< J, into stretching for good
    double put_in = 0; ///< J, by the machine
    double longer = 0; ///< m

    TestingMachine(double length, std::vector<LinkCondition> pieces = {})
        : rig(chain_78mm(), in_air(), {0, 0, -length}, {0, 0, 0}, length, Foot::fixed),
          condition(std::move(pieces)) {}

    double load() const { return rig.top_tension(); }

    /// One step at a speed of the top, m/s.
    void step(double speed) {
        rig.hawse.z() += speed * kStep;
        const double length = rig.state.top_length;
        rig.step(kStep);
        put_in -= rig.last.hawse_impulse.z() * speed;
        EXPECT_EQ(rig.state.top_length, length); // the top is locked: nothing but stretch makes it longer
        feed_chain(rig.def, rig.state, 0, 0);
        const Strained strained = strain_links(rig.def, condition, 0, rig.state, strain);
        work += strained.work;
        longer += strained.longer;
        if (parting.link < 0) parting = strained.parting;
    }
    /// Draws until the condition holds or a link parts; false when neither did within so many metres.
    template <class Condition>
    bool draw_until(const Condition& reached, double speed, double max) {
        const auto steps = std::lround(max / (speed * kStep));
        for (long k = 0; k < steps; ++k) {
            if (parting.link >= 0 || reached()) return true;
            step(speed);
        }
        return false;
    }
    bool draw_until_parted(double max) {
        return draw_until([] { return false; }, 0.05, max);
    }
    double energy() const { return chain_energy(rig.def, rig.environment, rig.state).total(); }
};

} // namespace

TEST(Strain, LoadUpToTheProofLoadLeavesNothing) {
    TestingMachine machine(40);
    ASSERT_TRUE(
        machine.draw_until([&] { return machine.load() > 0.995 * proof_load(machine.rig.def); }, 0.02, 1));
    EXPECT_GT(machine.strain.worst, 0.99 * proof_load(machine.rig.def));
    EXPECT_EQ(machine.rig.state.stretched, 0);
    EXPECT_EQ(machine.longer, 0);
    EXPECT_EQ(machine.work, 0);
}

TEST(Strain, SlowLoadStretchesEveryLinkUntilItYieldsAtThatLoad) {
    TestingMachine machine(40);
    const double load = 0.5 * (proof_load(machine.rig.def) + breaking_load(machine.rig.def));
    ASSERT_TRUE(machine.draw_until([&] { return machine.load() > load; }, 0.05, 4));
    ASSERT_EQ(machine.parting.link, -1);
    for (int i = 0; i < machine.rig.state.links; ++i) {
        // Waves in the chain, at the end of it, are below a thousandth of its load.
        EXPECT_NEAR(yield_load(machine.rig.def, machine.rig.state.stretch[i]), machine.rig.state.tension[i],
                    2e3)
            << "link " << i << " of " << machine.rig.state.links;
    }
    // Half way to the breaking load: half of a tenth, less what the foot bears less than the top by weight.
    const ChainDef& def = machine.rig.def;
    const double mean = load - 0.5 * 40 * weight_in_air(def);
    const double stretch = 0.1 * (mean - proof_load(def)) / (breaking_load(def) - proof_load(def));
    EXPECT_NEAR(machine.longer, stretch * 40, 0.005);
}

TEST(Strain, StretchedChainKeepsItsNewLength) {
    TestingMachine machine(40, {{.begins = 10, .ends = 15, .wear = 0.1}});
    ASSERT_TRUE(machine.draw_until([&] { return machine.longer > 0.15; }, 0.05, 2));
    ASSERT_LT(machine.strain.worst, proof_load(machine.rig.def)); // nothing but the worn piece yields
    const ChainDef& def = machine.rig.def;
    const double length = chain_length(def, machine.rig.state);
    EXPECT_NEAR(length, 40 + machine.longer, 1e-9);
    EXPECT_NEAR(new_length(def, machine.rig.state, length), 40, 1e-9);
    for (const double metres : {5.0, 12.5, 27.5, 40.0, 300.0})
        EXPECT_NEAR(new_length(def, machine.rig.state, stretched_length(def, machine.rig.state, metres)),
                    metres, 1e-9);
    EXPECT_EQ(stretched_length(def, machine.rig.state, 9), 9); // below: as it was
    EXPECT_NEAR(stretched_length(def, machine.rig.state, 27.5), 27.5 + machine.longer,
                1e-9); // above: all of it
    EXPECT_EQ(machine.rig.state.stretch[9], 0);
    EXPECT_GT(machine.rig.state.stretch[12], 0.02);
    EXPECT_EQ(machine.rig.state.stretch[15], 0);
}

TEST(Strain, WorkPutInIsEnergyKeptAndStretching) {
    TestingMachine machine(40);
    const double before = machine.energy();
    const double load = 0.5 * (proof_load(machine.rig.def) + breaking_load(machine.rig.def));
    ASSERT_TRUE(machine.draw_until([&] { return machine.load() > load; }, 0.05, 4));
    const double taken = sum(machine.rig.ledger) + machine.work;
    EXPECT_GT(machine.work, 0.8 * machine.put_in);                              // the rest is elastic
    EXPECT_NEAR((machine.energy() - before + taken) / machine.put_in, 1, 1e-5); // 7e-7 measured
}

TEST(Strain, ChainWornByTwelvePerCentBearsTheSquareOfWhatIsLeft) {
    for (const double wear : {0.0, 0.12}) {
        TestingMachine machine(10, {{.begins = 0, .ends = 330, .wear = wear}});
        ASSERT_TRUE(machine.draw_until_parted(2));
        // 0.774 of the certificate at 12 %, where a length is renewed. A step draws by 0.3 kN at this speed.
        EXPECT_NEAR(machine.parting.tension / breaking_load(machine.rig.def), (1 - wear) * (1 - wear), 1e-3);
        // Stretched like sound chain: a tenth, within the weight of 10 m.
        EXPECT_NEAR(machine.longer, 1, 0.02);
    }
}

TEST(Strain, CablePartsAtItsWeakestLink) {
    TestingMachine machine(40, {{.begins = 0, .ends = 330, .wear = 0.03},
                                {.begins = 8, .ends = 9, .wear = 0.05},
                                {.begins = 17.3, .ends = 17.3, .defect = 0.4}});
    ASSERT_TRUE(machine.draw_until_parted(2));
    EXPECT_EQ(machine.parting.link, 17);
    EXPECT_NEAR(machine.parting.tension / breaking_load(machine.rig.def), 0.6,
                1e-3);            // overlapping: not added up
    EXPECT_EQ(machine.longer, 0); // a crack breaks before anything stretches
}

TEST(Strain, OverloadedCableIsLongerAndItsCounterAgreesOnceItIsHove) {
    // A weight that worn chain cannot hang on without stretching, and a windlass that can heave it.
    TackleSetup setup;
    setup.condition = {{.begins = 15, .ends = 330, .wear = 0.45}};
    setup.anchor.mass = 125e3;
    setup.cable_out = 60;
    setup.windlass.rated_pull = 2e6, setup.windlass.stall_pull = 3e6;
    setup.windlass.clutch_rating = 5e6;
    rigs::TackleRig rig(setup, rigs::quiet_water(100));
    rig.tackle.keep_ledger();
    const double before = rig.tackle.energy(rig.environment), all = rig.tackle.bitter_end();
    rig.run(20);
    ASSERT_EQ(rig.tackle.chain().parted, -1);
    const double longer = rig.tackle.bitter_end() - all;
    EXPECT_GT(longer, 2);
    EXPECT_NEAR(rig.windlass().cable_out, 60 + longer, 1e-9);
    EXPECT_EQ(rig.tackle.windlass().counter_reading(), 60); // the gypsy has not turned
    const double lost = before - rig.tackle.energy(rig.environment);
    EXPECT_GT(rig.tackle.ledger().stretching, 0.9 * lost);
    EXPECT_NEAR(sum(rig.tackle.ledger()) / lost, 1, 1e-3); // 1.7e-4 measured

    rig.levers.clutch_in = true;
    rig.run(5);
    rig.levers.brake = 0, rig.levers.speed = 1;
    const double home = home_length(setup.chain);
    ASSERT_TRUE(rig.run_until([&] { return rig.windlass().cable_out < home + 1e-3; }, 600));
    // What stretched has run over the gypsy, in fewer links than metres.
    EXPECT_NEAR(rig.tackle.windlass().counter_reading(), home, counter_pulse(setup.chain.diameter));
    const double gained = rig.tackle.energy(rig.environment) - before;
    EXPECT_NEAR(-sum(rig.tackle.ledger()) / gained, 1, 1e-3); // 2e-5 measured
}

} // namespace windlass::physics
