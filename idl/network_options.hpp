#pragma once
// --lan and --discovery-server, which every program of ours has.

#include "idl/wire.hpp"

#include <CLI/CLI.hpp>

namespace windlass::wire {

/// Adds the two options. Both leave one host; they exclude each other.
inline void add_network_options(CLI::App& app, Network& network) {
    auto* lan = app.add_flag("--lan", network.lan,
                             "join others in the local network, found by multicast (docs/network.md)");
    app.add_option("--discovery-server", network.discovery_server,
                   "join others in any network through this fast-discovery-server (docs/network.md)")
        ->type_name("HOST:PORT")
        ->excludes(lan);
}

} // namespace windlass::wire
