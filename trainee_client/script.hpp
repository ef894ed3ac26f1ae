#pragma once
// A script: what a trainee does and reports, step by step, each when its conditions hold.
// Format: config/schema/script.schema.json.

#include "station/lever_sender.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace windlass::trainee {

/// What one must have to look at something: a seat's view, or the truth, which a coach has.
enum class Eyes { seat, coach };

/// A figure of the picture that a condition can look at; nothing while it has not been heard.
struct Quantity {
    const char* name; ///< as in the script
    const char* unit;
    Eyes eyes;
    std::optional<double> (*read)(const station::Picture& picture, int side);
};

/// Every quantity, in the order of the schema.
std::span<const Quantity> quantities();

/// Limits of one quantity, SI. at_least includes its limit, above and below do not.
struct Bounds {
    const Quantity* quantity = nullptr; ///< null: the figure of a report
    std::optional<double> at_least, above, below;

    bool hold(double value) const {
        return (!at_least || value >= *at_least) && (!above || value > *above) && (!below || value < *below);
    }
};

/// All that is given must hold. Without anything it holds at once.
struct Condition {
    std::optional<double> after; ///< s since the step before
    std::vector<Bounds> bounds;
    std::optional<bool> anchor_on_bottom;
    std::optional<AnchorPhase> anchor_phase;
    std::optional<bool> clutch_in;
    std::optional<bool> stopper_closed;
    std::optional<std::string> event;       ///< code of an event of this run, of the truth
    std::optional<std::string> seat_event;  ///< code of an event of this run that is noticed at the seat
    std::optional<BridgeOrderCode> order;   ///< the bridge has given it and it waits to be repeated back
    std::optional<BridgeOrderCode> ordered; ///< the bridge has given it in this run, repeated back or not
    std::optional<double> ordered_value;    ///< with that number
    std::optional<ReportCode> reported;     ///< the forecastle has, since the step before
    std::optional<int> reported_side;       ///< SIDE_PORT, SIDE_STARBOARD or -1; nothing: the one worked
    std::optional<Bounds> reported_value;   ///< figure of that report; of a lead its hour

    /// since_step: s of exercise time since the step before; reports_before: how many had been heard by then.
    bool holds(const station::Picture& picture, int side, double since_step,
               std::uint64_t reports_before = 0) const;

    /// Each condition that does not hold, with the value it has: "shackles at least 6 (now 4.2)".
    std::string unmet(const station::Picture& picture, int side, double since_step,
                      std::uint64_t reports_before = 0) const;
};

/// Levers to move; what is not given stays.
struct Orders {
    std::optional<double> brake, speed_lever, engine, rudder, bow_thruster, stern_thruster;
    std::optional<bool> clutch_in, stopper_closed, emergency_stop;

    void apply(station::LeverSet& set) const;
    bool any() const;
};

/// A report as it was entered; what was not stays open.
struct ReportOrder {
    ReportCode code = REPORT_TEXT;
    double value = 0;
    int lead = 0; ///< clock hour 1..12; 0: not given
    StayGiven stay = STAY_NOT_GIVEN;
    Growing growing = GROWING_NOT_GIVEN;
    CableWeight weight = WEIGHT_NOT_GIVEN;
    std::optional<int> side; ///< SIDE_PORT, SIDE_STARBOARD or -1 both; nothing: the one that is worked
    std::optional<BridgeOrderCode> order; ///< REPORT_ORDER_REPEATED: what was understood; REPORT_UNSAFE: what
                                          ///< is proposed
    int order_number = 0; ///< that it answers; 0: the newest one of that code, that is unsafe: the newest
    std::string text;
};

/// The report as it is sent, of a man at that windlass: it carries what was entered and nothing else. A
/// repeat without a number answers the newest order of its code in the picture.
Report sample_of(const ReportOrder& order, int side, const station::Picture& picture);

/// An order to the forecastle: a seat of the bridge gives it.
struct BridgesOrder {
    BridgeOrderCode code = BRIDGE_ORDER_TEXT;
    double value = 0;
    std::optional<int> side; ///< as a report's
    std::string text;
};

/// What she is to show from now on: the bridge's to order.
struct Shown {
    bool anchor_ball = false;
    bool anchor_lights = false;
};

/// The anchor watch that the bridge keeps from now on.
struct Circle {
    double x = 0, y = 0, radius = 0; ///< m, world
};

struct Step {
    Condition when;
    Orders orders;
    std::optional<Shown> show;
    std::optional<Circle> circle;
    std::optional<DeckWork> deck_work; ///< what the men are set to from now on
    std::optional<ReportOrder> report;
    std::optional<BridgesOrder> order;
    std::string say;
    double timeout = 0; ///< s of exercise time
};

/// To a question at a freeze, by its id: a number in its unit, or the text of one of its choices.
using QuestionAnswers = std::map<std::string, std::variant<double, std::string>, std::less<>>;

/// The answer as it is sent, but for its origin; nothing: there is none to that question. Throws
/// std::runtime_error when it is none of those that the question allows.
std::optional<Answer> answer_to(const Question& question, const QuestionAnswers& answers);

struct Script {
    std::string title;
    int side = SIDE_PORT;
    std::optional<double> repeats_orders; ///< s after which every order is repeated back, beside the steps
    bool follows_orders = false;  ///< does not wait for an order when a later one has come in its place
    bool repeats_wrongly = false; ///< with another figure, or for the other side where it has none
    bool conns = false;           ///< gives orders, and so has no windlass
    bool mate = false;            ///< works the windlass as the bridge orders, in place of steps
    std::vector<Step> steps;
    QuestionAnswers answers{}; ///< to what its seat is asked
};

/// Reads a script. Throws exercise::ConfigError naming every fault: file, JSON pointer, value, what is
/// allowed. With the eyes of a seat, a condition that looks at the truth is a fault, and what to do is told.
Script load_script(const std::filesystem::path& file, Eyes eyes);

} // namespace windlass::trainee
