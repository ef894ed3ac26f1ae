#pragma once
// The flukes' turn on their pin: one degree of freedom beside the anchor's rigid body.
//
// The body's own mass, centre and inertia are those with the flukes in the shank's plane. Turned flukes shift
// the point at which its weight acts, and count with the energy of that and of their own turn; what is left
// out is that the body's acceleration swings them.

#include "server/physics/anchor/anchor_shape.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/solver/chain_solver.hpp"

namespace windlass::physics {

/// A plain value.
struct FlukeState {
    double angle = 0; ///< rad, from the shank's plane; positive towards the anchor's -z
    double rate = 0;  ///< rad/s
};

/// What else acts on them in a step.
struct FlukeSurroundings {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< anchor axes into world axes
    double pin_height = 0;                              ///< m, above the bed
    double dug = 0;                                     ///< m below the bed that the soil lets the tips go
    double push = 0;             ///< N m, of soil against the tripping palms, turning the flukes down
    double friction = 0;         ///< N m, in the pin
    double submerged = 1;        ///< 0..1
    Vec3 through = Vec3::Zero(); ///< m/s, world, of the pin through the water
};

class Flukes {
public:
    /// mass: kg, of the anchor.
    Flukes(const FlukeShape& shape, double mass, double water_density);

    /// A step in two halves: how fast they turn by what acts on them, and, after whoever else has changed
    /// that, to where. The second returns what was lost at stops, in pin, soil and water, J.
    void swing(const FlukeSurroundings& s, const StepTime& time);
    double turn(const FlukeSurroundings& s, const StepTime& time);

    /// By how much their turn shifts the anchor's centre of mass, m, world.
    Vec3 shift(const Eigen::Matrix3d& axes) const;
    /// N, of the anchor's weight that shift belongs to: in water.
    double weight() const { return weight_; }
    /// J, kinetic and potential, the latter zero in the shank's plane.
    double energy(const Eigen::Matrix3d& axes) const;
    /// Sine of the angle by which the flukes point below the horizontal: of the lower arm where they are
    /// fixed.
    double dip(const Eigen::Matrix3d& axes) const;

    double angle() const { return state_.angle; }
    void turn_to(double angle) { state_ = {shape_.hinged ? angle : 0, 0}; }
    /// Whether they are fast on their pin in the steps to come: they stay as they stand to the shank.
    void seize(bool fast) { seized_ = fast; }
    double rate() const { return state_.rate; }
    void set_rate(double radians_per_second) { state_.rate = radians_per_second; }
    double inertia() const { return inertia_; } ///< kg m2, about the pin
    /// Whether a moment (N m) only presses them on one of their stops.
    bool stopped(double moment) const;
    /// The same, or on the bed.
    bool stopped(double moment, const FlukeSurroundings& s) const;
    template <class Visitor, StateOf<Flukes> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    double height_slope(const Eigen::Matrix3d& axes, double angle) const;
    double within(const FlukeSurroundings& s, double angle) const;

    FlukeShape shape_;
    double weight_ = 0;  ///< N, of the whole anchor in water
    double moment_ = 0;  ///< N m, the flukes' part of it times their lever
    double inertia_ = 0; ///< kg m2
    double drag_ = 0;    ///< N m s2, against their own turn
    double trail_ = 0;   ///< kg, moment of the water that streams past, for each m2/s2
    double energy_ = 0;  ///< J, before the step under way
    FlukeState state_;
    bool seized_ = false; ///< said anew in every step
};

} // namespace windlass::physics
