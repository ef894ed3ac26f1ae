#include "bench/methods/list.hpp"

namespace windlass::lab {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> all{
        production_method(),  direct_end_method(),      leapfrog_method(),
        xpbd_method(),        small_step_xpbd_method(), lumped_rk4_method(),
        implicit_fe_method(), bullet_links_method(),    catenary_method(),
    };
    return all;
}

} // namespace windlass::lab
