#pragma once
// The options of "order", "watch-circle" and "lights-and-shapes": what the bridge says, keeps and shows.

#include "instructor_console/orders.hpp"

#include <CLI/CLI.hpp>

namespace windlass::console {

/// "hold-on 6 --side port", "text \"mind the buoy\"", "cancel 3".
struct BridgeOrderOptions {
    std::string code = {};
    std::string value = {}; ///< a number, or the text of "text"
    std::string side = "port";
    std::string text = {};
    double repeat_within = 0, do_within = 0; ///< s

    void add_to(CLI::App& app);

    /// Throws CLI::ValidationError when the order lacks its number or text, or has one that it does not take.
    BridgeOrderWish wish() const;
};

struct WatchOptions {
    bool off = false;
    std::optional<double> x, y; ///< m, world; without: where the ship is
    double radius = 0;          ///< m

    void add_to(CLI::App& app);
};

struct SignalOptions {
    bool ball = false, lights = false, none = false;

    void add_to(CLI::App& app);
};

} // namespace windlass::console
