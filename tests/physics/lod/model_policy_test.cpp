// The cable at rest as the catenary level has it, and the links that an error budget allows.

#include "server/physics/lod/catenary.hpp"
#include "server/physics/lod/model_policy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {

namespace {

/// A bed so hard that the chain lies on it and not in it.
EnvironmentDef hard_bed(double depth) {
    EnvironmentDef environment;
    environment.depth = depth;
    environment.bed_stiffness = 1e12;
    return environment;
}

} // namespace

/// s = sqrt(y^2 + 2 y H / w), x = H / w asinh(s w / H), T = H + w y, for inextensible chain in water alone.
TEST(Catenary, AgreesWithTheClosedFormOfInextensibleChain) {
    ChainDef chain;
    chain.stiffness = 1e14;
    const EnvironmentDef environment = hard_bed(40);
    const double w = weight_in_water(chain, environment.water_density);
    for (const double h : {100e3, 200e3, 400e3, 800e3}) {
        const double hanging = std::sqrt(40 * 40 + 2 * 40 * h / w), x = h / w * std::asinh(hanging * w / h);
        constexpr double kLying = 50, kAtTheSurface = 1e-9; // m
        Catenary cable(chain, environment);
        ASSERT_TRUE(cable.solve(hanging + kLying, x + kLying, kAtTheSurface)) << h;
        EXPECT_NEAR(cable.horizontal(), h, 1e-5 * h);
        EXPECT_NEAR(cable.tension(), h + w * 40, 1e-5 * h);
        EXPECT_NEAR(cable.lying(), kLying, 1e-3);
    }
}

TEST(Catenary, LiesWhereItsOwnTensionsPutIt) {
    const ChainDef chain;
    const EnvironmentDef environment;
    Catenary cable(chain, environment);
    ASSERT_TRUE(cable.solve(160, 150, 6));
    const auto [x, z] = cable.place_at(160);
    EXPECT_NEAR(x, 150, 1e-6);
    const double sunk = weight_in_water(chain, environment.water_density) /
                        (environment.bed_stiffness * chain.contact_diameter);
    EXPECT_NEAR(z, environment.depth + sunk + 6, 1e-6);
    EXPECT_NEAR(cable.tension_at(160), cable.tension(), 1e-6);
    // Every hanging metre is stretched by its tension, and the weight that hangs is borne at the lip.
    double weight = 0;
    for (int k = 0; k < 1600; ++k) {
        const double s = 0.1 * k;
        const auto [xa, za] = cable.place_at(s);
        const auto [xb, zb] = cable.place_at(s + 0.1);
        if (s < cable.lying()) continue; // its few millimetres of stretch are spread evenly
        const double tension = cable.tension_at(s + 0.05);
        EXPECT_NEAR(std::hypot(xb - xa, zb - za), 0.1 * (1 + tension / chain.stiffness), 2e-6) << s;
        const bool dry = 0.5 * (za + zb) > environment.depth + sunk;
        weight += 0.1 * (dry ? weight_in_air(chain) : weight_in_water(chain, environment.water_density));
    }
    EXPECT_NEAR(weight, cable.vertical(), 150); // N, a tenth of a metre of chain
}

TEST(Catenary, FrictionTakesThePullOffTheFoot) {
    const ChainDef chain;
    const EnvironmentDef environment;
    Catenary cable(chain, environment);
    ASSERT_TRUE(cable.solve(160, 150, 6));
    const double rubbed = environment.bed_friction * weight_in_water(chain, environment.water_density);
    EXPECT_NEAR(cable.foot_tension(), std::max(0.0, cable.horizontal() - rubbed * cable.lying()), 1e-6);
    EXPECT_EQ(cable.tension_at(0), cable.foot_tension());
}

TEST(Catenary, RefusesSlackAndTautCableAndKeepsItsLastSolution) {
    Catenary cable(ChainDef{}, EnvironmentDef{});
    ASSERT_TRUE(cable.solve(160, 150, 6));
    const double h = cable.horizontal();
    EXPECT_FALSE(cable.solve(160, 120, 6)); // 31 m of it up and down: 9 m too many
    EXPECT_FALSE(cable.solve(160, 158, 6)); // all off the bottom
    EXPECT_FALSE(cable.solve(160, 200, 6)); // cannot reach
    EXPECT_EQ(cable.horizontal(), h);
}

TEST(SpacingWithin, KeepsTheBudgetThatItWasGiven) {
    const ChainDef chain;
    for (const double hanging : {20.0, 31.0, 60.0, 110.0}) {
        for (const ModelError budget :
             {ModelError{0.01, 0.25}, ModelError{0.05, 0.25}, ModelError{0.02, 0.5}}) {
            const double spacing = spacing_within(budget, hanging, chain, 5);
            const ModelError error = spacing_error(spacing, hanging);
            EXPECT_LE(error.load, budget.load);
            EXPECT_LE(error.shape, budget.shape);
            // ... and not much better than asked for, or it would be dear.
            EXPECT_GT(std::max(error.load / budget.load, error.shape / budget.shape), 0.95);
        }
    }
}

TEST(SpacingWithin, NeverCutsACableFinerThanTheWireCarriesNorLongerThanTheCable) {
    ChainDef chain;
    chain.length = 1000;
    EXPECT_GE(spacing_within({1e-6, 1e-6}, 31, chain, 5), 0.5);
    EXPECT_LE(spacing_within({1, 10}, 31, chain, 0.5), 1.0);
}

TEST(WorseError, IsTheLargerOneOfEachAndNoneWhereOneIsNotEstimated) {
    const ModelError error = worse({0.01, 0.3}, {0.02, 0.1});
    EXPECT_EQ(error.load, 0.02);
    EXPECT_EQ(error.shape, 0.3);
    for (const ModelError none : {worse(error, kNotEstimated), worse(kNotEstimated, error)}) {
        EXPECT_LT(none.load, 0);
        EXPECT_LT(none.shape, 0);
    }
}

} // namespace windlass::physics
