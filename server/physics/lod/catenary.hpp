#pragma once
// The cable in equilibrium: from a point where it lies on the bottom to the hawse pipe lip, in their vertical
// plane; elastic, with friction on the bottom, lighter in water than in air.
//
// Elastic catenary: Irvine (1981), Cable Structures, section 2.4. Along the hanging part the horizontal pull
// H is the same everywhere and T + T^2 / (2 EA) grows by the weight of a metre for each metre of height: so
// the tensions at the surface and at the lip follow from H in closed form, and only H is sought, by Newton.

#include "server/physics/base/state_limits.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/sea/environment.hpp"

#include <utility>

namespace windlass::physics {

/// One cable at rest. SI; x from the foot towards the lip, z above the bed as the chain lies on it.
class Catenary {
public:
    Catenary(const ChainDef& chain, const EnvironmentDef& environment);

    /// Finds the cable of the given unstretched length (m) from a foot on the bottom to a lip span (m) away,
    /// at the given height (m) above the water, whose surface is at level (m, world). False when none of it
    /// would lie on the bottom, or more would than there is room for; the last solution then stands.
    bool solve(double length, double span, double lip_height, double level = 0);

    double horizontal() const { return h_; }            ///< N, pull towards the foot
    double vertical() const { return v_lip_; }          ///< N, at the lip, downwards
    double tension() const { return t_lip_; }           ///< N, at the lip
    double lying() const { return lying_; }             ///< m, unstretched, on the bottom
    double hanging() const { return length_ - lying_; } ///< m, unstretched
    double foot_tension() const { return tension_at(0); }
    double level() const { return level_; } ///< m, world, of the surface

    /// Place (x, z) and tension (N) at unstretched length s (m) from the foot.
    std::pair<double, double> place_at(double s) const;
    double tension_at(double s) const;

    /// The last solution.
    template <class Visitor, StateOf<Catenary> Self>
    friend void visit_state(Visitor& v, Self& self) {
        WINDLASS_STATE(v, self.level_, self.length_, self.span_, self.lip_height_, self.h_, self.t_surface_,
                       self.t_lip_, self.v_surface_, self.v_lip_, self.lying_, self.lying_reach_);
        WINDLASS_WITHIN(v, -kFarthest, kFarthest, self.level_, self.length_, self.span_, self.lip_height_,
                        self.lying_, self.lying_reach_);
        WINDLASS_WITHIN(v, 0, kStrongest, self.h_, self.t_surface_, self.t_lip_, self.v_surface_,
                        self.v_lip_);
    }

private:
    struct Reach {
        double excess = 0, slope = 0; ///< m that the cable reaches too far, and its derivative by H
    };
    Reach reach(double h);
    double tension_above(double tension, double weight) const;
    double depth() const { return bed_ + level_; } ///< m, to the surface

    double water_, air_, stiffness_; ///< weights, N/m, and EA, N
    double friction_;                ///< N/m on the bottom
    double bed_;                     ///< m from the bed, as the chain lies on it, to z = 0
    double level_ = 0;               ///< m, world, of the surface
    double length_ = 0, span_ = 0, lip_height_ = 0;
    double h_ = 0, t_surface_ = 0, t_lip_ = 0, v_surface_ = 0, v_lip_ = 0; ///< N
    double lying_ = 0, lying_reach_ = 0;                                   ///< m, unstretched and stretched
};

} // namespace windlass::physics
