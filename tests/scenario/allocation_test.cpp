// The hot loop allocates nothing: counted where every new ends up, and where Bullet takes its memory.

#include "rigs/chain_step.hpp"
#include "rigs/drill.hpp"

#include <LinearMath/btAlignedAllocator.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size) {
    ++allocations;
    return std::malloc(size);
}

} // namespace

void* operator new(std::size_t size) {
    if (void* memory = counted(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size);
}
// Not inlined: where GCC sees free() beside a new that it did not inline, it warns of a mismatch.
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}

namespace windlass::exercise {

using namespace rigs;

namespace {

/// Allocations in the given seconds of exercise: ours and Bullet's, in step() and view().
long allocations_in(Exercise& exercise, Snapshot& snapshot, double seconds) {
    const int rate = exercise.def().tick_rate_hz;
    const auto ticks = static_cast<int>(seconds * rate);
    const long before = allocations;
    for (int k = 0; k < ticks; ++k) {
        exercise.step(1.0 / rate);
        exercise.view(snapshot);
    }
    return allocations - before;
}

class Allocation : public testing::Test {
protected:
    Allocation() { btAlignedAllocSetCustom(counted, std::free); }
    ~Allocation() override { btAlignedAllocSetCustom(nullptr, nullptr); }

    void levers(double brake, double speed, bool clutch) {
        exercise_.apply(WindlassOrder{Side::port, brake, speed, clutch, false, false});
    }

    Exercise exercise_{quiet_def(18, 5)};
    Snapshot snapshot_;
};

} // namespace

TEST_F(Allocation, IsCountedWhenAnExerciseIsBuilt) {
    const long before = allocations;
    const Exercise other(quiet_def(18, 5));
    EXPECT_GT(allocations - before, 10);
}

TEST_F(Allocation, DoesNotHappenWhileTheAnchorHangs) {
    allocations_in(exercise_, snapshot_, 2);
    EXPECT_EQ(allocations_in(exercise_, snapshot_, 5), 0);
}

TEST_F(Allocation, DoesNotHappenWhileCableIsVeeredAndHoveIn) {
    levers(0, 0, true);
    allocations_in(exercise_, snapshot_, 3);
    levers(0, -1, true);
    allocations_in(exercise_, snapshot_, 1);
    const double out = snapshot_.tackle[0].chain.cable_out;
    EXPECT_EQ(allocations_in(exercise_, snapshot_, 10), 0);
    EXPECT_GT(snapshot_.tackle[0].chain.cable_out, out + 3.5); // nodes came
    levers(0, 1, true);
    allocations_in(exercise_, snapshot_, 1);
    EXPECT_EQ(allocations_in(exercise_, snapshot_, 8), 0);
    EXPECT_LT(snapshot_.tackle[0].chain.cable_out, out + 2); // and went
}

TEST_F(Allocation, DoesNotHappenWhileTheAnchorLiesOnTheBottom) {
    levers(0, 0, false); // let go
    allocations_in(exercise_, snapshot_, 12);
    levers(1, 0, false);
    allocations_in(exercise_, snapshot_, 10);
    ASSERT_LT(snapshot_.tackle[0].anchor.height_above_bottom, 0.1);
    EXPECT_EQ(allocations_in(exercise_, snapshot_, 5), 0);
}

TEST_F(Allocation, DoesNotHappenInAStepOfAThousandLinks) {
    // Let fall from a heap of zigzags: slack, folded and taut links, and steps that are taken implicitly, all
    // from the first step on.
    physics::ChainDef def;
    def.node_spacing = 0.2;
    physics::EnvironmentDef sea;
    const physics::Vec3 lip(0, 0, 0);
    physics::ChainState chain = physics::straight_chain(def, lip - physics::Vec3(0, 0, 200), lip, 200, 1000);
    for (int i = 0; i < 1000; ++i)
        chain.position.set(i, physics::Vec3(0.001 * i, i % 2 ? 0.1 : -0.1, -0.02 * (1000 - i)));
    physics::ChainSolver solver(def, 1000);
    physics::LockedEnd top;
    physics::ChainTail tail;
    tail.inverse_mass.xx = tail.inverse_mass.yy = tail.inverse_mass.zz = 1e-4;
    const long before = allocations;
    bool direct = false, implicit = false;
    for (int k = 0; k < 600; ++k) {
        tail.velocity = chain.velocity.at(0) -
                        physics::Vec3(0, 0, physics::step_kick(chain, 1.0 / 60) * physics::kGravity);
        const physics::ChainStepResult result =
            rigs::step_chain(solver, chain, sea, 1.0 / 60, tail, top, lip);
        (result.implicit ? implicit : direct) = true;
    }
    EXPECT_EQ(allocations - before, 0);
    EXPECT_TRUE(direct);
    EXPECT_TRUE(implicit);
    ASSERT_TRUE(std::isfinite(chain.position.z[0]));
}

TEST_F(Allocation, DoesNotHappenWhileTwoCablesLieAcrossEachOther) {
    // Hawse pipes at the stem, closer together than the anchors are wide, and both let go.
    ExerciseDef def = quiet_def(18, 5);
    def.ship.hawse_forward = 110.5, def.ship.hawse_outboard = 0.7;
    def.tackle.push_back(def.tackle[0]);
    def.tackle[1].side = Side::starboard;
    Exercise exercise(def);
    for (const Side side : {Side::port, Side::starboard})
        exercise.apply(WindlassOrder{side, 0, 0, false, false, false});
    allocations_in(exercise, snapshot_, 6);
    for (const Side side : {Side::port, Side::starboard})
        exercise.apply(WindlassOrder{side, 1, 0, false, false, false});
    allocations_in(exercise, snapshot_, 10); // until the last event is called: events take memory
    EXPECT_EQ(allocations_in(exercise, snapshot_, 5), 0);
    EXPECT_EQ(snapshot_.model_level, ModelLevel::dynamic) << "they are near each other";
    const AnchorView &port = snapshot_.tackle[0].anchor, &starboard = snapshot_.tackle[1].anchor;
    EXPECT_LT((port.position - starboard.position).norm(), 2) << "one lies on the other";
}

TEST_F(Allocation, DoesNotHappenWhileChainSleepsAndTheCatenaryComesAndGoes) {
    Drill drill(steady_breeze_def());
    ASSERT_TRUE(lie_quietly(drill));
    bool quiet =
        false; // no event, which takes memory: steps that were not solved well are told once a minute
    for (int visit = 0; visit < 5 && !quiet; ++visit) {
        ASSERT_TRUE(drill.run_until([&] { return drill.now().model_level == ModelLevel::catenary; }, 900));
        const auto events = drill.log().size();
        const long before = allocations;
        ASSERT_TRUE(drill.run_until([&] { return drill.now().model_level != ModelLevel::catenary; }, 300));
        drill.run(5);
        quiet = drill.log().size() == events;
        if (quiet) {
            EXPECT_EQ(allocations - before, 0);
        }
    }
    EXPECT_TRUE(quiet);
}

} // namespace windlass::exercise
