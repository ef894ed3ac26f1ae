// Both anchors of a ship whose hawse pipes stand at the stem, closer together than her anchors are wide.

#include "rigs/drill.hpp"
#include "server/physics/anchor/anchor_meeting.hpp"
#include "server/physics/windlass/band_brake.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windlass::exercise {
namespace {

constexpr std::array kBoth{Side::port, Side::starboard};

ExerciseDef pipes_at_the_stem() {
    ExerciseDef def = rigs::quiet_def(18, 5);
    def.ship.hawse_forward = 110.5, def.ship.hawse_outboard = 0.7;
    // Links of 0.66 m. How they jam is luck: the anchor that comes in last may wedge the other's, and drive
    // its load beyond what its motor stalls at (0.75 to 1.3 MN with links of 0.4 to 2 m, 2.5 with 0.2 and
    // 0.3).
    def.model.adaptive = false;
    def.tackle[0].chain.node_spacing = 0.66;
    def.tackle.push_back(def.tackle[0]);
    def.tackle[1].side = Side::starboard;
    return def;
}

/// Both worked alike.
struct BothAnchors {
    ExerciseDef def = pipes_at_the_stem();
    Exercise exercise{def};
    Snapshot now;
    physics::Anchor port{def.tackle[0].anchor, 0, def.environment, {}},
        starboard{def.tackle[1].anchor, 0, def.environment, {}}; ///< their shapes
    bool good = true;
    double load = 0, closest = 1e9; ///< N; m, of anything of the one to anything of the other

    BothAnchors() { exercise.view(now); }
    void order(double brake, double speed, bool clutch) {
        for (const Side side : kBoth)
            exercise.apply(WindlassOrder{side, brake, speed, clutch, false, false});
    }
    template <class Condition>
    void run_until(const Condition& done, double seconds) {
        for (int k = 0; k < seconds * 300 && !done(); ++k) {
            good = exercise.step(1.0 / 300) && good;
            exercise.view(now);
            for (const TackleView& tackle : now.tackle)
                load = std::max(load, tackle.windlass.hawse_tension);
            if (k % 10 == 0) closest = std::min(closest, apart());
        }
    }
    double apart() {
        const auto put = [](physics::Anchor& anchor, const AnchorView& view) {
            anchor.set_pose({view.position, view.attitude});
            anchor.turn_flukes(view.fluke_angle);
        };
        put(port, now.tackle[0].anchor), put(starboard, now.tackle[1].anchor);
        double min = 1e9;
        for (int i = 0; i < port.boxes(); ++i)
            for (int j = 0; j < starboard.boxes(); ++j)
                min = std::min(min, separation(port.box(i), starboard.box(j), 1e9).distance);
        return min;
    }
};

TEST(AnchorsMeet, LetGoTogetherAndHoveHomeTogetherTheyBearOnEachOther) {
    BothAnchors both;
    both.order(physics::position_of_grip(both.def.tackle[0].windlass, 0), 0, false);
    both.run_until([&] { return both.now.tackle[0].chain.cable_out > 28; }, 20);
    both.order(1, 0, false);
    both.run_until([] { return false; }, 5);
    EXPECT_LT(both.closest, 0);     // one fell across the other
    EXPECT_GT(both.closest, -0.05); // half of what flukes are thick is 0.1 m
    EXPECT_LT(both.load, 300e3);    // 120 kN

    both.order(1, 0, true);
    const auto in = [&](int side) { return both.now.tackle[side].windlass.clutch == ClutchState::in; };
    both.run_until([&] { return in(0) && in(1); }, 60);
    both.order(0, 1, true);
    both.run_until([] { return false; }, 100);
    EXPECT_TRUE(both.good);
    // There is no room for both: they jam at the pipes, neither gets home, and the motors stall.
    for (const TackleView& tackle : both.now.tackle)
        EXPECT_LT(tackle.chain.cable_out, 0);
    EXPECT_GT(both.load, 500e3);
    // One is wedged, and pulled out again by the motor of the other, which stalls at 880 kN. Pulled back, a
    // drive bears 880 kN / (0.88 x 0.85) by its gear's friction, and the hawse pipe's (0.7) its part of what
    // comes in.
    EXPECT_LT(both.load, 880e3 / (0.88 * 0.85) / 0.7);
    EXPECT_GT(both.closest, -0.1); // 2 cm
}

} // namespace
} // namespace windlass::exercise
