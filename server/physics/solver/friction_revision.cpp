#include "server/physics/solver/friction_revision.hpp"

#include "server/physics/base/vectorise.hpp"

#include <cassert>
#include <cstdint>

namespace windlass::physics {

namespace {

/// Cosine of the turn up to which friction along the old way and across it will do.
constexpr double kSameWay = 0.9;

Vec3 slide_of(const FreeMotion& motion, int i, const Vec3& velocity) {
    const Vec3 normal = motion.level ? Vec3::UnitZ() : motion.bed.normal.at(i);
    return velocity - velocity.dot(normal) * normal;
}

Vec3 velocity_of(const ChainState& state, const StepTime& time, const Field& placed, int i) {
    return (placed.at(i) - state.position.at(i)) / time.dt;
}

/// slide: m/s, along the bed.
inline bool fits(const BedFriction& friction, const Vec3& slide) {
    const double square = slide.squaredNorm(), on = slide.dot(friction.direction);
    const bool sticks = friction.direction.squaredNorm() == 0,
               creeps = square <= kFrictionCreep * kFrictionCreep;
    const bool goes_on = on >= kFrictionCreep && on * on >= kSameWay * kSameWay * square;
    return friction.max == 0 || (sticks && creeps) || (!sticks && goes_on);
}

/// Takes the node's friction for another.
void change(const ChainState& state, const StepTime& time, int i, const BedFriction& now,
            FreeMotion& motion) {
    const BedFriction was = motion.friction.at(i);
    SymmetricMatrix mass = motion.inverse_mass.at(i).inverse();
    Vec3 momentum = mass * velocity_of(state, time, motion.place, i);
    const double more = time.kick * (now.damping - was.damping);
    mass.xx += more, mass.yy += more, mass.zz += more;
    mass.add(-more, motion.level ? Vec3::UnitZ() : motion.bed.normal.at(i));
    mass.add(time.kick * was.damping, was.direction);
    mass.add(-time.kick * now.damping, now.direction);
    momentum += time.kick * (was.max * was.direction - now.max * now.direction);
    const SymmetricMatrix inverse = mass.inverse();
    motion.friction.set(i, now);
    motion.inverse_mass.set(i, inverse);
    motion.place.set(i, state.position.at(i) + time.dt * (inverse * momentum));
}

} // namespace

bool friction_fits(const ChainState& state, const StepTime& time, const Field& placed,
                   const FreeMotion& motion) {
    assert(state.links < static_cast<int>(placed.x.size()) && "a place for every node in use");
    const double rate = 1 / time.dt;
    std::int64_t misfits = 0;
    const auto look = [&](int i, const Vec3& normal) WINDLASS_INLINE {
        const Vec3 v = rate * (placed.at(i) - state.position.at(i));
        misfits += fits(motion.friction.at(i), v - v.dot(normal) * normal) ? 0 : 1;
    };
    if (motion.level) {
        WINDLASS_VECTORISE
        for (int i = motion.bed_first; i <= motion.bed_last; ++i)
            look(i, Vec3::UnitZ());
    } else {
        WINDLASS_VECTORISE
        for (int i = motion.bed_first; i <= motion.bed_last; ++i)
            look(i, motion.bed.normal.at(i));
    }
    return misfits == 0;
}

void revise_friction(const ChainState& state, const StepTime& time, const Field& placed, FreeMotion& motion) {
    assert(state.links < static_cast<int>(placed.x.size()) && "a place for every node in use");
    for (int i = motion.bed_first; i <= motion.bed_last; ++i) {
        const BedFriction was = motion.friction.at(i);
        const Vec3 slide = slide_of(motion, i, velocity_of(state, time, placed, i));
        if (fits(was, slide)) continue;
        const bool back =
            !was.direction.isZero() && slide.dot(was.direction) < kFrictionCreep; // it stops first
        change(state, time, i, friction_about(was.max, back ? Vec3::Zero() : slide), motion);
    }
}

void make_friction_proportional(const ChainState& state, const StepTime& time, FreeMotion& motion) {
    for (int i = motion.bed_first; i <= motion.bed_last; ++i) {
        const BedFriction was = motion.friction.at(i);
        if (was.direction.isZero()) continue;
        change(state, time, i, friction_in_proportion(was.max, slide_of(motion, i, state.velocity.at(i))),
               motion);
    }
}

} // namespace windlass::physics
