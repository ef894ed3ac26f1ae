#include "bench/methods/list.hpp"

#include <algorithm>
#include <stdexcept>

namespace windlass::lab {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> all{
        production_method(),  direct_end_method(),          leapfrog_method(),
        xpbd_method(),        small_step_xpbd_method(),     lumped_rk4_method(),
        implicit_fe_method(), bullet_links_method(),        catenary_method(),
        pbd_method(),         production_in_phase_method(),
    };
    return all;
}

const MethodEntry* find_method(const std::string& name) {
    const auto at = std::find_if(methods().begin(), methods().end(),
                                 [&](const MethodEntry& entry) { return entry.name == name; });
    return at == methods().end() ? nullptr : &*at;
}

std::unique_ptr<Method> make_method(const MethodEntry& entry, const Problem& problem, int links, double dt,
                                    const MethodSettings& settings) {
    if (!problem.obstacles.empty() && !entry.does_obstacles) {
        std::string able;
        for (const MethodEntry& other : methods())
            if (other.does_obstacles) able += (able.empty() ? "" : ", ") + other.name;
        throw std::invalid_argument(entry.name +
                                    ": obstacles are not allowed: it knows the flat seabed only; " +
                                    "with obstacles: " + able);
    }
    if (!entry.rigid || !problem.rigid_start) return entry.make(problem, links, dt, settings);
    Problem unstretched = problem;
    unstretched.start = problem.rigid_start;
    return entry.make(unstretched, links, dt, settings);
}

} // namespace windlass::lab
