#pragma once
// The options of "fault": what shall go wrong, and when.

#include "instructor_console/orders.hpp"

#include <CLI/CLI.hpp>

namespace windlass::console {

struct FaultOptions {
    std::string code;
    double severity = 1;
    double ramp = 0; ///< s
    int target = 0;
    std::optional<double> at_time, at_cable_out, at_cable_out_at_most;
    std::optional<double> at_load_kn, at_load_at_most_kn;
    std::optional<std::string> at_event, at_order;
    std::vector<double> between; ///< s, two of them
    bool clear = false;

    void add_to(CLI::App& app);
    FaultOrder order(int side) const;
};

} // namespace windlass::console
