#pragma once
// One way of computing a chain. The rivals stand here side by side; none of them is in the server.

#include "bench/problem/problem.hpp"

#include <memory>
#include <string>
#include <vector>

namespace windlass::lab {

/// A method at work on one problem. Constructed by its factory at time 0 with the line in its starting shape.
class Method {
public:
    virtual ~Method() = default;

    /// Advances by one step of the size given to the factory (s).
    virtual void step() = 0;

    virtual double time() const = 0; ///< s
    virtual int links() const = 0;
    virtual Vec3 position(int node) const = 0; ///< m, node 0 at the lower end
    virtual Vec3 velocity(int node) const = 0; ///< m/s
    virtual double
    tension(int link) const = 0; ///< N, link i between node i and i + 1, as the method itself measures it
    virtual int iterations() const { return 1; } ///< of the last step

    /// Steps so far that the method could not solve and took as they stood: from the first on, its numbers
    /// are not its answer.
    virtual long unsolved() const { return 0; }
};

/// Settings that only some methods have; the defaults are those of the sources.
struct MethodSettings {
    int iterations = 0; ///< 0: the method's own

    // PBD; defaults of Jiang, Ren, He (2020). Stiffnesses are shares of an error that one sweep takes away.
    double k_stretch = 0.99, k_bend = 0.02, k_lra = 1, k_pin = 1;
    bool bend_by_angle = false; ///< bends by the angle of two links, not by the distance from a centroid
    double rest_angle = 0;      ///< rad, of bends by angle
    double k_slack = 0;         ///< of a link that is too short; 0: chain does not push
    int bend_iterations = 8, lra_iterations = 3, pin_iterations = 5;
    double pin_damping = 0; ///< share of the speed between chain and anchor that a step takes away
    bool self_collision = false;
    double radius = 0;        ///< m, of a particle; 0: resolution times a link
    double resolution = 0.5;  ///< particle radius over their distance: at 0.5 neighbours just touch
    double rest_distance = 0; ///< m, at which particles come to rest before a surface
    bool coloured = false;    ///< sweep every other link at once instead of one after the other
};

/// A method in the list.
struct MethodEntry {
    std::string name;       ///< on the command line, e.g. "leapfrog"
    std::string title;      ///< one line: what it is, after whom
    std::string leaves_out; ///< what of the problem it cannot do; empty when nothing
    /// Throws std::invalid_argument (clear text) when the method cannot do the problem.
    std::unique_ptr<Method> (*make)(const Problem& problem, int links, double dt,
                                    const MethodSettings& settings);
    bool does_obstacles = false; ///< whether it knows Problem::obstacles
    bool rigid = false;          ///< its links keep their length: it starts at Problem::rigid_start
};

/// All methods, production first. Each file in bench/methods adds one or a few.
const std::vector<MethodEntry>& methods();

/// The method of that name, nullptr when there is none.
const MethodEntry* find_method(const std::string& name);

/// Puts a method to work. Throws std::invalid_argument when it cannot do the problem, among others because
/// there are obstacles and it does not know any.
std::unique_ptr<Method> make_method(const MethodEntry& entry, const Problem& problem, int links, double dt,
                                    const MethodSettings& settings);

} // namespace windlass::lab
