// Quantities of a condition that are worked out of several places.

#include "server/assess/quantities.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::assess {

namespace {

double quantity(const char* name, const exercise::Snapshot& seen) {
    return quantities()[static_cast<std::size_t>(quantity_of(name))].read(seen, seen.tackle.front());
}

/// A ship that heads by so many degrees, her pipes 8 m apart and 110 m from midships, between two anchors 300
/// m apart in line east and west: port's to the west, as a standing moor lays them for a ship that heads
/// north.
exercise::Snapshot moored(double heading_deg) {
    exercise::Snapshot seen;
    seen.tackle.resize(2);
    const double heading = heading_deg * std::numbers::pi / 180;
    const physics::Vec3 ahead(std::sin(heading), std::cos(heading), 0), right(ahead.y(), -ahead.x(), 0);
    for (int side : {0, 1}) {
        exercise::TackleView& tackle = seen.tackle[static_cast<std::size_t>(side)];
        const double out = side == 0 ? -1 : 1;
        tackle.side = static_cast<exercise::Side>(side);
        tackle.hawse = 4 * out * right;
        tackle.anchor.position = physics::Vec3(150 * out, 0, -20);
    }
    return seen;
}

} // namespace

// She lies by her bow in the middle: open while port's pipe is on port anchor's side, crossed while it is on
// the other.
TEST(Quantities, LeadsAreCrossedWhileSheHeadsAwayFromTheSideThatKeepsHerHawseOpen) {
    for (const double heading : {0.0, 45.0, 80.0, -45.0, -80.0})
        EXPECT_EQ(quantity("leads_crossed", moored(heading)), 0) << heading;
    exercise::Snapshot off = moored(180);
    // Turned round, and a little off the line of the anchors, as streams leave her.
    for (exercise::TackleView& tackle : off.tackle)
        tackle.hawse.y() += 10;
    EXPECT_EQ(quantity("leads_crossed", off), 1);
    off.tackle.pop_back();
    EXPECT_EQ(quantity("leads_crossed", off), 0) << "one cable crosses nothing";
}

} // namespace windlass::assess
