#pragma once
// One way of computing a chain. The rivals stand here side by side; none of them is in the server.

#include "bench/lab/problem.hpp"

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
    int iterations = 0;                                           ///< 0: the method's own
    double k_stretch = 0.99, k_bend = 0.02, k_lra = 1, k_pin = 1; ///< PBD, Jiang, Ren, He (2020)
};

/// A method in the list.
struct MethodEntry {
    std::string name;       ///< on the command line, e.g. "leapfrog"
    std::string title;      ///< one line: what it is, after whom
    std::string leaves_out; ///< what of the problem it cannot do; empty when nothing
    /// Throws std::invalid_argument (clear text) when the method cannot do the problem.
    std::unique_ptr<Method> (*make)(const Problem& problem, int links, double dt,
                                    const MethodSettings& settings);
};

/// All methods, production first. Each file in bench/methods adds one or a few.
const std::vector<MethodEntry>& methods();

/// The method of that name, nullptr when there is none.
const MethodEntry* find_method(const std::string& name);

} // namespace windlass::lab
