#pragma once
// The line as particles, which the position-based methods first move as if no link held them and then pull
// back onto their constraints: what PBD, XPBD and the direct solve at the end of the step share.

#include "bench/methods/lumped_line.hpp"
#include "bench/problem/method.hpp"
#include "server/physics/chain/chain_forces.hpp"

namespace windlass::lab {

using physics::SymmetricField;

/// Who bears a particle that lies on the seabed.
enum class SeabedBy {
    prediction, ///< spring, damper and friction, implicit, as in the server
    method      ///< the method's own contacts: the prediction takes no notice
};

/// Particles in one step: places at its start, velocities, and the places where they shall be at its end.
struct Particles {
    LumpedLine line;
    double dt = 0;    ///< s
    bool wet = false; ///< whether water or seabed may act; else all inverse masses are scalars
    Field position;   ///< m, at the start of the step
    Field velocity;   ///< m/s
    Field target;     ///< m, at its end as far as known
    std::vector<double> inverse_mass; ///< 1/kg, across the chain; 0 for held particles
    SymmetricField inverse_matrix;    ///< 1/kg, when wet: added mass, drag and seabed differ with direction
    long steps = 0;

    /// Throws std::invalid_argument like LumpedLine.
    Particles(const Problem& problem, int links, double dt, SeabedBy seabed);

    int nodes() const { return line.nodes(); }
    double time() const { return static_cast<double>(steps) * dt; }

    /// Moves all particles freely: targets and, when wet, inverse masses.
    void predict();

    /// Ends the step: velocities from the way to the targets.
    void accept();

private:
    void predict_in_air();
    void predict_in_water();
    void predict_node(int i);
    void hold(const End& end, int node);

    SeabedBy seabed_;
};

/// A method that moves particles: what it answers about them.
class ParticleMethod : public Method {
public:
    double time() const override { return particles_.time(); }
    int links() const override { return particles_.line.links; }
    Vec3 position(int node) const override { return particles_.position.at(node); }
    Vec3 velocity(int node) const override { return particles_.velocity.at(node); }

protected:
    ParticleMethod(const Problem& problem, int links, double dt, SeabedBy seabed)
        : particles_(problem, links, dt, seabed) {}

    Particles particles_;
};

} // namespace windlass::lab
