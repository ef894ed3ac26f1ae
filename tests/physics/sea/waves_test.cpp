// Seas made of components: heights, periods, directions, and how one gives way to another.

#include "server/physics/base/units.hpp"
#include "server/physics/sea/sea_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace windlass::physics {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::vector<WaveComponent> components(const WaveTrain& train, double depth = 30) {
    std::vector<WaveComponent> all(static_cast<std::size_t>(components_of(train.kind)));
    cut_into_components(train, depth, all);
    return all;
}

double variance(const std::vector<WaveComponent>& waves) {
    double sum = 0;
    for (const WaveComponent& c : waves)
        sum += 0.5 * c.amplitude_after * c.amplitude_after;
    return sum;
}

/// Of the spectrum, from zero up to omega; of the n-th moment.
double moment(const WaveTrain& train, int n, double up_to) {
    constexpr int kSteps = 4000;
    double sum = 0;
    for (int k = 0; k < kSteps; ++k) {
        const double omega = (k + 0.5) * up_to / kSteps;
        sum += std::pow(omega, n) * spectral_density(train, omega) * up_to / kSteps;
    }
    return sum;
}

class EveryTrain : public ::testing::TestWithParam<WaveTrain> {};
INSTANTIATE_TEST_SUITE_P(Waves, EveryTrain,
                         ::testing::Values(WaveTrain{WaveKind::wind_sea, 6, 0.3, 1},
                                           WaveTrain{WaveKind::wind_sea, 9, 4, 77},
                                           WaveTrain{WaveKind::swell, 11, 2, 5},
                                           WaveTrain{WaveKind::swell, 16, 6, 5}));

TEST(Waves, HaveTheLengthThatTheDepthGivesThem) {
    for (const double depth : {5.0, 30.0, 500.0})
        for (const double period : {2.0, 8.0, 20.0}) {
            const double omega = kTurn / period, k = wave_number(omega, depth);
            EXPECT_NEAR(kGravity * k * std::tanh(k * depth), omega * omega, 1e-9 * omega * omega);
        }
    // 1.04, 1.14, 1.42 times as short as in deep water (Newton's method by hand, to the last figure given)
    for (const auto& [period, times] : {std::pair{8.0, 1.04}, {10.0, 1.14}, {14.0, 1.42}}) {
        const double omega = kTurn / period;
        EXPECT_NEAR(wave_number(omega, 30) * kGravity / (omega * omega), times, 0.005) << period;
    }
}

TEST_P(EveryTrain, HasTheEnergyOfItsHeight) {
    EXPECT_NEAR(4 * std::sqrt(variance(components(GetParam()))), 1, 1e-12); // 4 sqrt(m0), 1 m
}

TEST_P(EveryTrain, HasItsEnergyWhereTheSpectrumHasIt) {
    const WaveTrain& train = GetParam();
    const double peak = kTurn / train.period, whole = moment(train, 0, 6 * peak);
    EXPECT_NEAR(16 * whole, 1, 0.02); // the formula's own constant is good to that
    double largest = 0;
    for (const WaveComponent& c : components(train))
        largest = std::max(largest, 0.5 * c.amplitude_after * c.amplitude_after);
    for (const double omega : {0.8 * peak, 0.95 * peak, peak, 1.1 * peak, 1.3 * peak, 1.8 * peak}) {
        double below = 0;
        for (const WaveComponent& c : components(train))
            if (c.omega < omega) below += 0.5 * c.amplitude_after * c.amplitude_after;
        // A component stands for its bin: no nearer than the largest of them.
        EXPECT_NEAR(below, moment(train, 0, omega) / (16 * whole), largest) << omega / peak;
    }
}

TEST_P(EveryTrain, KeepsHeightAndPeriodOverThreeHours) {
    const WaveTrain& train = GetParam();
    const auto waves = components(train);
    double squares = 0, before = 0;
    int crossings = 0;
    constexpr double kStep = 0.25;
    const int samples = static_cast<int>(3 * 3600 / kStep);
    for (int k = 0; k < samples; ++k) {
        double z = 0;
        for (const WaveComponent& c : waves)
            z += c.amplitude_after * std::cos(c.phase - c.omega * k * kStep);
        squares += z * z;
        crossings += before < 0 && z >= 0;
        before = z;
    }
    EXPECT_NEAR(4 * std::sqrt(squares / samples), 1, 0.02); // components beat in three hours
    const double peak = kTurn / train.period;
    const double zero_up = kTurn * std::sqrt(moment(train, 0, 4 * peak) / moment(train, 2, 4 * peak));
    EXPECT_NEAR(samples * kStep / crossings, zero_up, 0.06 * zero_up); // bins stand for what is in them
}

TEST_P(EveryTrain, DoesNotComeBackWithinAnHour) {
    // Of a surface that repeats itself the record after the time would be the record before: correlation 1.
    const auto waves = components(GetParam());
    const double whole = variance(waves);
    double closest = 0;
    for (double lag = 60; lag < 3600; lag += 0.25) {
        double sum = 0;
        for (const WaveComponent& c : waves)
            sum += 0.5 * c.amplitude_after * c.amplitude_after * std::cos(c.omega * lag);
        closest = std::max(closest, sum / whole);
    }
    EXPECT_LT(closest, 0.9) << "of waves of " << GetParam().period << " s";
}

TEST_P(EveryTrain, RunsWhereItIsSaidTo) {
    const WaveTrain& train = GetParam();
    double east = 0, north = 0;
    for (const WaveComponent& c : components(train)) {
        const double k = std::hypot(c.k_x, c.k_y), energy = c.amplitude_after * c.amplitude_after;
        east += energy * c.k_x / k, north += energy * c.k_y / k;
        EXPECT_NEAR(k, wave_number(c.omega, 30), 1e-12);
    }
    const double off = std::remainder(std::atan2(east, north) - train.from - std::numbers::pi, kTurn);
    // 14 to 18 directions stand for the spreading (31 and 12 degrees): a few degrees.
    EXPECT_NEAR(off, 0, train.kind == WaveKind::swell ? 0.06 : 0.15);
    const double together = std::hypot(east, north) / (2 * variance(components(train)));
    EXPECT_NEAR(together, train.kind == WaveKind::swell ? 0.977 : 0.849, 0.03); // of cos^20, cos^2
}

TEST_P(EveryTrain, HasOtherPhasesOfAnotherSeedAndNothingElse) {
    WaveTrain other = GetParam();
    ++other.seed;
    const auto one = components(GetParam()), two = components(other);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].omega, two[i].omega);
        EXPECT_EQ(one[i].k_x, two[i].k_x);
        EXPECT_EQ(one[i].amplitude_after, two[i].amplitude_after);
        EXPECT_NE(one[i].phase, two[i].phase);
    }
}

// ---- the surface

const SeaDef kBreeze{.wave_height = 1, .wave_period = 5, .swell_height = 2, .swell_period = 12};

/// Largest jump of the elevation between two instants a millisecond apart, anywhere on the way.
double largest_step(SeaSurface& sea, double from, double to) {
    double before = sea.elevation(50, 20, from), largest = 0;
    for (double t = from; t < to; t += 1e-3) {
        sea.advance(t);
        const double now = sea.elevation(50, 20, t);
        largest = std::max(largest, std::abs(now - before));
        before = now;
    }
    return largest;
}

TEST(SeaSurface, IsThereAtOnceAndOfTheHeightOrdered) {
    SeaSurface sea(kBreeze, 30);
    EXPECT_EQ(sea.components().size(), static_cast<std::size_t>(kSeaComponents + kSwellComponents));
    EXPECT_NEAR(sea.height(0), std::hypot(1, 2), 1e-12);
    EXPECT_TRUE(SeaSurface({}, 30).flat());
    EXPECT_EQ(SeaSurface({}, 30).elevation(1, 2, 3), 0);
}

TEST(SeaSurface, KeepsItsComponentsWhenOnlyTheHeightChanges) {
    SeaSurface sea(kBreeze, 30);
    const std::vector before(sea.components().begin(), sea.components().end());
    SeaDef higher = kBreeze;
    higher.swell_height = 3;
    sea.order(higher, 100, 60);
    ASSERT_EQ(sea.components().size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(sea.components()[i].phase, before[i].phase);
        EXPECT_EQ(sea.components()[i].amplitude_before, before[i].amplitude_before);
    }
    EXPECT_NEAR(sea.height(130), std::hypot(1, 2.5), 1e-12); // straight
    EXPECT_FALSE(sea.advance(159));
    EXPECT_TRUE(sea.advance(160));
    EXPECT_NEAR(sea.height(160), std::hypot(1, 3), 1e-12);
    EXPECT_FALSE(sea.advance(161));
}

TEST(SeaSurface, GivesWayWithoutAJump) {
    SeaSurface sea(kBreeze, 30);
    SeaDef other = kBreeze;
    other.swell_from = 1, other.wave_period = 7;
    sea.order(other, 10, 0); // at once: in half a minute
    EXPECT_EQ(sea.components().size(), static_cast<std::size_t>(kMaxWaveComponents));
    // Some 2.5 m/s is the fastest that 2 m of such sea goes up or down.
    EXPECT_LT(largest_step(sea, 10, 20), 5e-3);
    SeaDef third = other;
    third.swell_from = 2; // while the first is there still
    sea.order(third, 20, 60);
    EXPECT_LT(largest_step(sea, 20, 100), 5e-3);
    EXPECT_EQ(sea.components().size(), static_cast<std::size_t>(kSeaComponents + kSwellComponents));
    EXPECT_NEAR(sea.height(100), std::hypot(1, 2), 1e-12);
    SeaSurface asked(third, 30); // the same sea, whatever the way to it
    EXPECT_NEAR(sea.elevation(5, 6, 100), asked.elevation(5, 6, 100), 1e-12);
}

TEST(SeaSurface, AnOrderThatChangesNothingChangesNothing) {
    SeaSurface sea(kBreeze, 30);
    sea.order(kBreeze, 40, 60);
    EXPECT_EQ(sea.ramp_begin(), sea.ramp_end());
    EXPECT_EQ(sea.components().size(), static_cast<std::size_t>(kSeaComponents + kSwellComponents));
}

} // namespace
} // namespace windlass::physics
