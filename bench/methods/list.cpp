#include "bench/methods/list.hpp"

#include <algorithm>

namespace windlass::lab {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> all{
        production_method(),  direct_end_method(),      leapfrog_method(),
        xpbd_method(),        small_step_xpbd_method(), lumped_rk4_method(),
        implicit_fe_method(), bullet_links_method(),    catenary_method(),
    };
    return all;
}

const MethodEntry* find_method(const std::string& name) {
    const auto at = std::find_if(methods().begin(), methods().end(),
                                 [&](const MethodEntry& entry) { return entry.name == name; });
    return at == methods().end() ? nullptr : &*at;
}

} // namespace windlass::lab
