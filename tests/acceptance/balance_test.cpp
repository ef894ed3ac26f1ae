// Where the energy of let-go, walk-back, weighing and a lost cable goes.

#include "bench/acceptance/balance.hpp"

#include "tests/acceptance/shipped.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::lab {
namespace {

double joules(const std::vector<Entry>& entries, const std::string& name) {
    for (const Entry& entry : entries)
        if (entry.name == name) return entry.joules;
    ADD_FAILURE() << "no entry " << name;
    return 0;
}

void closes(const Balance& balance) {
    EXPECT_LT(std::abs(balance.open()), 0.005) << balance.run; // issue 4: within 0.5 %
    for (const Entry& sink : balance.sinks) {
        const bool may_give = sink.name == "motor" || sink.name == "work on the ship";
        // What springs of bed and hull hold is booked with them: a hundredth of the turnover at most.
        if (!may_give) {
            EXPECT_GT(sink.joules, -0.01 * balance.turned_over()) << balance.run << ", " << sink.name;
        }
    }
    double brake = 0;
    for (const Entry& entry : balance.brake)
        brake += entry.joules;
    // Lining and drum follow the brake's work to rounding.
    EXPECT_NEAR(brake, balance.brake_heat, 1e-6 * balance.turned_over()) << balance.run;
}

class BalanceOfSizes : public testing::TestWithParam<const char*> {};

TEST_P(BalanceOfSizes, LetGoCloses) {
    const Balance balance = let_go(machine(GetParam()));
    closes(balance);
    EXPECT_GT(joules(balance.sinks, "band brake"), 0.02 * balance.turned_over());
    EXPECT_GT(balance.lining, balance.drum); // the skin is what slips
}

TEST_P(BalanceOfSizes, WalkBackCloses) {
    const Balance balance = walk_back(machine(GetParam()));
    closes(balance);
    EXPECT_GT(joules(balance.sinks, "motor"), 0.3 * balance.turned_over()); // it brakes all the way
}

TEST_P(BalanceOfSizes, WeighingCloses) {
    const Balance balance = weigh(machine(GetParam()));
    closes(balance);
    EXPECT_LT(joules(balance.sinks, "motor"), -0.3 * balance.turned_over()); // it lifts
    EXPECT_GT(joules(balance.sinks, "soil"), 0);
}

TEST_P(BalanceOfSizes, LosingTheCableCloses) {
    const Balance balance = run_out(machine(GetParam()));
    closes(balance);
    EXPECT_GT(joules(balance.sinks, "parting"), 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, BalanceOfSizes,
                         testing::Values("electric_52mm", "electric_78mm", "electric_117mm", "hydraulic_78mm",
                                         "pole_changing_78mm"),
                         [](const auto& each) { return std::string(each.param); });

} // namespace
} // namespace windlass::lab
