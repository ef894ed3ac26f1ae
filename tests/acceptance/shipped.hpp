#pragma once
// The windlasses of config/ as parameters of tests.

#include "bench/acceptance/machines.hpp"

#include <algorithm>
#include <ostream>

namespace windlass::lab {

inline const std::vector<Machine>& machines() {
    static const std::vector<Machine> all = shipped_machines(WINDLASS_CONFIG_DIR);
    return all;
}

inline const Machine& machine(const std::string& name) {
    return *std::find_if(machines().begin(), machines().end(),
                         [&](const Machine& m) { return m.name == name; });
}

inline void PrintTo(const Machine& machine, std::ostream* out) {
    *out << machine.name;
}

} // namespace windlass::lab
