// A participant that means harm, or does not know better: what it sends changes nothing but the log of
// events, and costs no memory.

#include "tests/wire/hostile_rig.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace windlass::test {
using namespace rigs;

namespace {

TEST_F(Hostile, PayloadsThatAreNoneAreRefusedUnopened) {
    std::mt19937 random(3);
    for (const auto& row : topics::all) {
        if (row.from_server || std::string(row.name).starts_with("Replay") || row.rate == 60) continue;
        wire::RawWriter writer(enemy_, row);
        matched(writer);
        for (int i = 0; i < 300; ++i) {
            Payload garbage(4 + random() % 300, 0xFF);
            if (i % 3 != 0) // a third is all ones: booleans of 255, texts of 4 GB
                std::generate(garbage.begin(), garbage.end(),
                              [&] { return static_cast<std::uint8_t>(random()); });
            if (i % 2 != 0) std::copy_n("\0\1\0\0", 4, garbage.begin()); // a true header
            writer.write(garbage);
        }
        EXPECT_TRUE(eventually([&] {
            return has_refused(std::string(row.type) + " from (unnamed): payload");
        })) << row.name;
    }
    expect_unharmed();
}

TEST_F(Hostile, NumbersThatAreNoneAndCodesThatAreNoneAreRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    wire::Writer<WindlassCommand> levers(enemy_, topics::windlass_command, 99);
    wire::Writer<HelmCommand> helm(enemy_, topics::helm_command, 99);
    wire::Writer<EnvironmentCommand> orders(enemy_, topics::environment_command);
    wire::Writer<FaultCommand> faults(enemy_, topics::fault_command);
    matched(levers), matched(helm), matched(orders), matched(faults);
    std::uint64_t serial = 0;
    for (const double bad : {nan, -nan, 1e308, -1e308, std::numeric_limits<double>::infinity()}) {
        auto lever = signed_by<WindlassCommand>("enemy", ++serial);
        lever.brake(bad);
        lever.speed_lever(bad);
        levers.write(lever);
        auto wheel = signed_by<HelmCommand>("enemy", serial);
        wheel.rudder(bad);
        helm.write(wheel);
        auto order = signed_by<EnvironmentCommand>("enemy", serial);
        order.weather().wind_speed(bad);
        orders.write(order);
        auto fault = signed_by<FaultCommand>("enemy", serial);
        fault.severity(bad);
        faults.write(fault);
        pace(std::chrono::milliseconds(100)); // a refusal for each
    }
    for (const char* field : {"brake = nan", "rudder = nan", "wind_speed = nan", "severity = nan"})
        EXPECT_TRUE(eventually([&] { return has_refused(field); })) << field;
    expect_unharmed();
}

TEST_F(Hostile, TenThousandCommandsASecondChangeNotABit) {
    wire::Writer<WindlassCommand> levers(enemy_, topics::windlass_command, 0);
    matched(levers);
    flood([&](std::uint64_t serial) {
        auto lever = signed_by<WindlassCommand>("enemy", serial);
        lever.brake(2);
        levers.write(lever);
    });
    EXPECT_TRUE(eventually([&] { return has_refused("rate = "); }));
    EXPECT_LT(static_cast<double>(events()),
              20 + 10 * (seconds() + 1) + 20); // 10 refusals a second, a burst of 20, and what was there
    EXPECT_GT(truth().commands_refused(), 1000U);
    expect_unharmed();
}

TEST_F(Hostile, TenThousandReportsASecondDoNotWashTheLogAway) {
    wire::Writer<Report> reports(enemy_, topics::report);
    matched(reports);
    flood([&](std::uint64_t serial) {
        auto report = signed_by<Report>("enemy", serial);
        report.text("again");
        reports.write(report);
    });
    EXPECT_TRUE(eventually([&] { return has_refused("rate = "); }));
    EXPECT_LT(static_cast<double>(events()),
              50 + 30 * (seconds() + 1) + 20 + 20); // 20 reports a second and a burst of 50 as well
    expect_unharmed(false); // the state counts the events of the exercise, and reports are events
}

TEST_F(Hostile, ThousandsOfInstancesLeaveTheTrueOnesAlone) {
    wire::Writer<WindlassCommand> levers(enemy_, topics::windlass_command, 99);
    matched(levers);
    std::uint64_t serial = 0;
    for (int side = 2; side < 5002; ++side) {
        auto lever = signed_by<WindlassCommand>("enemy", ++serial);
        lever.side(side % 2 == 0 ? side : -side);
        levers.write(lever);
        if (side % 10 == 0) pace(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(eventually([&] { return has_refused("side = "); }));
    expect_unharmed(); // while the enemy's writer and its instances are still there
}

TEST_F(Hostile, AnotherTypeUnderATopicsNameIsNotHeard) {
    const wire::Topic<ShipState> false_topic{{.name = "FaultCommand",
                                              .type = "ShipState",
                                              .from_server = false,
                                              .rate = 0,
                                              .reliable = true,
                                              .depth = 64}};
    wire::Writer<ShipState> writer(enemy_, false_topic);
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(writer.write(ShipState()));
    // Readers are told of in the order in which the server makes them, and this one's is the last.
    const wire::Writer<AssessmentCommand> last(enemy_, topics::assessment_command);
    matched(last);
    EXPECT_EQ(writer.matched(), 0);
    expect_unharmed();
}

} // namespace
} // namespace windlass::test
