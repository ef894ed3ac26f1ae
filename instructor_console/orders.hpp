#pragma once
// The instructor's orders, and by what in the picture one knows that the server has carried them out.

#include "station/picture.hpp"

#include <functional>
#include <optional>
#include <string>

namespace windlass::console {

/// Whether the order, given under that name, shows in the picture.
using CarriedOut = std::function<bool(const station::Picture& now, const std::string& name)>;

/// Shows in the server's log: an event of that code that names who gave the order.
CarriedOut logged(std::string code);

template <class Sample>
struct Order {
    Sample sample; ///< origin is filled on sending
    CarriedOut carried_out;
    std::string done; ///< said when it has been carried out, e.g. "running"
};

using RunOrder = Order<ExerciseCommand>;
using FaultOrder = Order<FaultCommand>;

RunOrder start_order();
RunOrder pause_order();
RunOrder reset_order();
RunOrder stop_order();
RunOrder time_scale_order(double scale); ///< exercise seconds per wall second; 0 as fast as possible
RunOrder restore_order(double time);     ///< s of exercise
RunOrder load_order(const std::string& file);

/// New wind and current; what is not given stays as the picture has it. m/s, rad.
struct Environment {
    std::optional<double> wind_speed, wind_from, current_speed, current_towards;
};
RunOrder environment_order(const Environment& environment, const station::Picture& picture);

/// severity 0..1; value in s, m or N as the trigger says.
FaultOrder fault_order(FaultCode code, int side, double severity, FaultTrigger trigger, double value);
FaultOrder clear_order(FaultCode code, int side);

} // namespace windlass::console
