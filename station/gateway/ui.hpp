#pragma once
// A station program as the host of its pages: its options, and serving until it is told to stop.

#include "station/gateway/gateway.hpp"
#include "station/options.hpp"

namespace windlass::gateway {

/// --ui-port, and for those who may let foreign tools look on --foxglove and --foxglove-origin.
struct UiOptions {
    static constexpr int kPort = 8765; ///< or the next one that is free, unless a port is asked for

    std::optional<int> port; ///< 0: any
    bool foxglove = false;
    std::vector<std::string> foxglove_origins;

    void add_to(CLI::App& app);
    void add_foxglove_to(CLI::App& app);
};

/// Serves the pages of the seat until a signal asks to stop; prints an address with the token for each page
/// on stdout, one to a line, and what is refused on stderr. Returns the exit code. Throws std::runtime_error
/// when there are no pages, no port, or DDS does not start.
int serve_pages(const UiOptions& options, GatewayOptions gateway);

} // namespace windlass::gateway
