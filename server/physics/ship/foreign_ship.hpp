#pragma once
// A ship that another simulator moves: her motion between its samples, over late and lost ones, and smoothly
// from and to the server's own model.

#include "server/physics/ship/ship.hpp"

#include <array>

namespace windlass::physics {

/// Where a foreign ship is at an instant; midships on her waterline, waves included.
struct ForeignSample {
    Vec3 position = Vec3::Zero(); ///< m, world; z over the still water's surface
    Eigen::Quaterniond attitude =
        Eigen::Quaterniond(1, 0, 0, 0);   ///< her axes (x forward, y to port, z up) into the world's
    Vec3 velocity = Vec3::Zero();         ///< m/s, world
    Vec3 angular_velocity = Vec3::Zero(); ///< rad/s, world
    double time = 0;                      ///< s of the sender's clock, at which all this was so
};

/// Extrapolates by constant velocity; what a new sample shows to be otherwise is taken up over some time, by
/// a cubic in place and velocity, so that neither ever jumps: a taut cable of 78 mm is 2 to 3 MN/m, and a
/// step of 1 cm is 30 kN. The sender's clock is set by the sample that was least on its way. Deterministic;
/// takes no memory.
///
/// A cable hangs on a ship of a thousand times its mass, so coupling step by step is stable; what costs
/// damping is delay, and a delay of 0.1 s costs at most 1 % of the critical one on a taut cable.
class ForeignShip {
public:
    /// How far a sample may be from where the server has the ship, in the plane, in height and in each angle.
    static constexpr double kNear = 1, kNearHeight = 3, kNearAngle = 5 * std::numbers::pi / 180; // m, m, rad
    /// s without a sample until her velocity is no longer carried on, and until she lies still.
    static constexpr double kLate = 0.3, kStill = 4;

    enum class Drive {
        none,  ///< the server's own model sails her
        fresh, ///< samples come
        late,  ///< none for kLate: she loses her way
        held   ///< none for kStill: she lies still
    };
    friend constexpr Drive last_of(Drive) { return Drive::held; }
    enum class Answer { took_over, taken, out_of_order, jumped };

    /// now: s of the exercise; ship: as she is. A sample that is not newer than the last one, or that jumps,
    /// changes nothing.
    Answer hear(const ForeignSample& sample, double now, const ShipState& ship);

    Drive drive(double now) const;

    /// Her motion at now, where a foreign model drives her; engine and rudder stay.
    void place(double now, ShipState& ship) const;

    /// The server's own model has her from now on, from where she is and as fast as she is; sea: what its
    /// waves do to her at now.
    void release(double now, const WaveMotion& sea, ShipState& ship);

    /// What of the foreign model's heave, roll and pitch is left after a release is added to the sea's, and
    /// fades.
    void fade(double now, WaveMotion& waves);

    template <class Visitor, StateOf<ForeignShip> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    /// East, north, up (m); heading clockwise from north, roll starboard down, pitch bow up (rad); and their
    /// rates.
    struct Motion {
        std::array<double, 6> place{}, rate{};
    };
    enum class Has { never, drives, leaves };
    friend constexpr Has last_of(Has) { return Has::leaves; }

    static Motion motion_of(const ForeignSample& sample);
    static Motion motion_of(const ShipState& ship);
    Motion carried_on(double now) const;
    Motion behind(double now) const;
    void blend(const Motion& from, const Motion& to, double now, double least_time);

    Has has_ = Has::never;
    Motion last_;                            ///< of the last sample
    double sent_ = 0;                        ///< s of the sender's clock, of the last sample
    double offset_ = 0;                      ///< s, of the exercise's time over the sender's
    Motion behind_;                          ///< what was to be taken up when the blend began
    double blend_from_ = 0, blend_time_ = 1; ///< s of the exercise, s
};

} // namespace windlass::physics
