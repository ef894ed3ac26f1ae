#pragma once
// A script: what a trainee does and reports, step by step, each when its conditions hold.
// Format: config/schema/script.schema.json.

#include "station/lever_sender.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windlass::trainee {

/// A figure of the picture that a condition can look at; nothing while it has not been heard.
struct Quantity {
    const char* name; ///< as in the script
    const char* unit;
    std::optional<double> (*read)(const station::Picture& picture, int side);
};

/// Every quantity, in the order of the schema.
std::span<const Quantity> quantities();

/// Limits of one quantity, SI. at_least includes its limit, above and below do not.
struct Bounds {
    const Quantity* quantity = nullptr;
    std::optional<double> at_least, above, below;
};

/// All that is given must hold. Without anything it holds at once.
struct Condition {
    std::optional<double> after; ///< s since the step before
    std::vector<Bounds> bounds;
    std::optional<bool> anchor_on_bottom;
    std::optional<AnchorPhase> anchor_phase;
    std::optional<bool> clutch_in;
    std::optional<bool> stopper_closed;
    std::optional<std::string> event; ///< code of an event of this run

    /// since_step: s of exercise time since the step before.
    bool holds(const station::Picture& picture, int side, double since_step) const;

    /// Each condition that does not hold, with the value it has: "shackles at least 6 (now 4.2)".
    std::string unmet(const station::Picture& picture, int side, double since_step) const;
};

/// Levers to move; what is not given stays.
struct Orders {
    std::optional<double> brake, speed_lever, engine, rudder, bow_thruster, stern_thruster;
    std::optional<bool> clutch_in, stopper_closed, emergency_stop;

    void apply(station::LeverSet& set) const;
    bool any() const;
};

struct ReportOrder {
    ReportCode code = REPORT_TEXT;
    double value = 0;
    std::string text;
};

struct Step {
    Condition when;
    Orders orders;
    std::optional<ReportOrder> report;
    std::string say;
    double timeout = 0; ///< s of exercise time
};

struct Script {
    std::string title;
    int side = SIDE_PORT;
    std::vector<Step> steps;
};

/// Reads a script. Throws exercise::ConfigError naming every fault: file, JSON pointer, value, what is
/// allowed.
Script load_script(const std::filesystem::path& file);

} // namespace windlass::trainee
