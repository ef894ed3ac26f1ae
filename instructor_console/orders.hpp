#pragma once
// The instructor's orders, and by what in the picture one knows that the server has carried them out.

#include "station/picture.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace windlass::console {

/// Whether the order, given under that name, shows in the picture.
using CarriedOut = std::function<bool(const station::Picture& now, const std::string& name)>;

/// Shows in the server's log: an event of that code that names who gave the order.
CarriedOut logged(std::string code);

template <class Sample>
struct ServerOrder {
    Sample sample; ///< origin is filled on sending
    CarriedOut carried_out;
    std::string done;         ///< said when it has been carried out, e.g. "running"
    bool ends_server = false; ///< it may be carried out by a server that then is gone, its answer with it
};

using RunOrder = ServerOrder<ExerciseCommand>;
using FaultOrder = ServerOrder<FaultCommand>;

RunOrder start_order();
RunOrder pause_order();
RunOrder reset_order();
RunOrder stop_order();
RunOrder time_scale_order(double scale); ///< exercise seconds per wall second; 0 as fast as possible
RunOrder restore_order(double time);     ///< s of exercise
RunOrder load_order(const std::string& file, bool practice);
/// A word into the log, to be found again in the recording; from the events after those in the picture on.
RunOrder bookmark_order(const std::string& text, const station::Picture& picture);

/// Predictions are made from now on, or no more. Carried out is what is not refused.
RunOrder predict_order(bool predict);

/// New weather; what is not given stays as the picture has it, at the end of a ramp that runs.
struct Environment {
    std::map<std::string_view, double> figures; ///< by their names in Weather, in its units: m/s, m, s, rad
    std::optional<double>
        fetch; ///< m of open water to windward: a wind sea that belongs to it, but what is given
    std::optional<std::vector<CurrentLayer>> current_profile;
    std::optional<double> ramp; ///< s; not given: what is left of the one that runs
};
/// The picture must have the environment.
ServerOrder<EnvironmentCommand> environment_order(const Environment& environment,
                                                  const station::Picture& picture);

/// What makes a fault active, as in FaultCommand; the fields that the trigger does not use stay 0.
struct Trigger {
    FaultTrigger what = TRIGGER_NOW;
    double value = 0; ///< s, m or N
    double until = 0; ///< s, TRIGGER_AT_CHANCE
    std::string event = {};
    BridgeOrderCode order = BRIDGE_ORDER_TEXT;
};

/// severity 0..1; ramp s; target: which of several, from 1, 0: whichever the model takes.
FaultOrder fault_order(FaultCode code, int side, double severity, const Trigger& trigger, double ramp = 0,
                       int target = 0);
FaultOrder clear_order(FaultCode code, int side);

/// An order to the forecastle, under the name of who gives it. 0 s: the code's own deadlines.
struct BridgeOrderWish {
    BridgeOrderCode code = BRIDGE_ORDER_TEXT;
    int side = SIDE_PORT; ///< -1: both
    double value = 0;     ///< shackles or m, as the code says
    std::string text = {};
    double repeat_within = 0; ///< s
    double do_within = 0;     ///< s
    int cancels = 0;          ///< BRIDGE_ORDER_CANCEL: number of the order that is taken back
};
ServerOrder<BridgeOrderCommand> bridge_order(const BridgeOrderWish& wish, const station::Picture& picture);

/// Anchor watch: centre and radius in m, world. kept false: no watch. Nothing in the picture shows it:
/// carried out is what is not refused.
ServerOrder<WatchCircle> watch_circle(bool kept, double x, double y, double radius);

/// What she shows at anchor, both of it. Carried out is what is not refused.
ServerOrder<LightsAndShapesCommand> lights_and_shapes(bool ball, bool lights);

/// An alert acknowledged or silenced, as the picture has it then.
ServerOrder<AlertCommand> alert_order(const Alert& alert, AlertAction action);

} // namespace windlass::console
