#include "bench/methods/list.hpp"

namespace windlass::lab {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> all{
        production_method(),
    };
    return all;
}

} // namespace windlass::lab
