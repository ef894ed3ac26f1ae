#include "server/assess/lesson.hpp"

#include "common/json_file.hpp"
#include "server/assess/names.hpp"
#include "server/assess/order_done.hpp"
#include "server/assess/quantities.hpp"
#include "server/assess/state.hpp"
#include "server/assess/unasked.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/physics/base/units.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace windlass::assess {

namespace {

using Json = nlohmann::json;

/// That a hint or a briefing may be for.
constexpr std::array<const char*, 2> kSeats{"forecastle", "bridge"};
constexpr const char* kPractice = "practice";

/// Reads what fits the schema, and says what the schema cannot: names that lead nowhere, figures that do not
/// go together.
class LessonReader {
public:
    LessonReader(const Json& json, const std::vector<int>& sides) : json_(json), sides_(sides) {}

    Lesson read() {
        lesson_.id = json_.value("id", "");
        lesson_.title = json_.value("title", lesson_.id);
        lesson_.briefing = json_.value("briefing", "");
        if (json_.contains("briefings"))
            for (std::size_t seat = 0; seat < kSeats.size(); ++seat)
                lesson_.briefings.at(seat) = json_.at("briefings").value(kSeats.at(seat), "");
        lesson_.practice = json_.value(kPractice, false);
        lesson_.ghost = json_.value("ghost", true);
        lesson_.bridge_manned = json_.value("bridge", "lesson") == "manned";
        lesson_.side = side(json_, "/lesson", sides_.empty() ? 0 : sides_.front());
        lesson_.two_sides = sides_.size() > 1;
        lesson_.pass = json_.value("pass", 70);
        lesson_.marks_when_confirmed = json_.value("marks_told", "at_end") == "when_confirmed";
        lesson_.patience = json_.value("patience", 0.0);
        read_names();
        read_list("objectives", [&](const Json& one, const std::string&) {
            lesson_.objectives.push_back({one.at("id"), one.value("text", ""), one.value("stcw", ""),
                                          one.value("pass", lesson_.pass)});
        });
        read_moments();
        read_list("orders", [&](const Json& one, const std::string& at) { read_order(one, at); });
        if (lesson_.bridge_manned) lay_what_it_may_order();
        read_list("faults", [&](const Json& one, const std::string& at) { read_fault(one, at); });
        read_list("schedule", [&](const Json& one, const std::string& at) { read_change(one, at); });
        read_list("criteria", [&](const Json& one, const std::string& at) { read_criterion(one, at); });
        lay_unasked(lesson_, sides_);
        read_list("hints", [&](const Json& one, const std::string& at) { read_hint(one, at); });
        read_end();
        read_runs();
        check_weights();
        return std::move(lesson_);
    }

    const std::vector<std::string>& faults() const { return faults_; }

private:
    template <class Take>
    void read_list(const char* name, const Take& take) {
        if (!json_.contains(name)) return;
        const Json& list = json_.at(name);
        for (std::size_t k = 0; k < list.size(); ++k)
            take(list[k], std::string("/lesson/") + name + "/" + std::to_string(k));
    }

    void fault(const std::string& at, const std::string& what) { faults_.push_back(at + ": " + what); }

    /// The names that others refer to, and that none is given twice.
    void read_names() {
        const auto take = [&](const char* list, std::vector<std::string>& names) {
            read_list(list, [&](const Json& one, const std::string& at) {
                const std::string id = one.at("id");
                if (std::find(names.begin(), names.end(), id) != names.end())
                    fault(at + "/id", '"' + id + "\" is there twice; every entry needs a name of its own");
                names.push_back(id);
            });
        };
        take("objectives", objectives_);
        take("orders", orders_);
        take("criteria", criteria_);
        std::vector<std::string> hints;
        take("hints", hints);
        if (json_.contains("moments"))
            for (const auto& [id, unused] : json_.at("moments").items())
                moments_.push_back(id);
        if (json_.contains("states"))
            for (const auto& [id, unused] : json_.at("states").items()) {
                if (std::ranges::find(moments_, id) != moments_.end())
                    fault("/lesson/states/" + id, "is the name of a moment, too; give it another");
                states_.push_back(id);
            }
    }

    int reference(const std::vector<std::string>& names, const std::string& name, const std::string& at,
                  const char* what) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            fault(at, unknown(name, names) + " (" + what + " of this lesson)");
            return 0;
        }
        return static_cast<int>(found - names.begin());
    }

    int side(const Json& object, const std::string& at, int otherwise) {
        if (!object.contains("side")) return otherwise;
        const std::string name = object.at("side");
        if (name == "both") return -1;
        const int side = name == "starboard" ? 1 : 0;
        if (std::find(sides_.begin(), sides_.end(), side) == sides_.end())
            fault(at + "/side", '"' + name +
                                    "\": the exercise has no windlass there; add it to /tackle, or "
                                    "name the other side");
        return side;
    }

    /// One text or a list of them.
    static std::vector<std::string> texts(const Json& value) {
        if (value.is_string()) return {value.get<std::string>()};
        return value.get<std::vector<std::string>>();
    }

    /// The state or moment of that name.
    Condition named(const std::string& name, const std::string& at, int usual_side) {
        constexpr int kDeepest = 8; // states that refer to states
        if (const auto known = std::ranges::find(moments_, name); known != moments_.end()) {
            Condition to{.side = usual_side};
            to.signs.push_back({SignKind::moment, static_cast<int>(known - moments_.begin())});
            return to;
        }
        if (std::ranges::find(states_, name) == states_.end()) {
            std::vector<std::string> names = states_;
            names.insert(names.end(), moments_.begin(), moments_.end());
            fault(at, unknown(name, names) + " (states and moments of this lesson)");
            return {};
        }
        if (depth_ == kDeepest) {
            fault(at, '"' + name + "\": refers to itself by way of others; let it look at figures");
            return {};
        }
        ++depth_;
        Condition to = condition(json_.at("states").at(name), "/lesson/states/" + name, usual_side);
        --depth_;
        return to;
    }

    Condition condition(const Json& object, const std::string& at, int usual_side) {
        Condition to{.side = side(object, at, usual_side)};
        to.time = object.value("time", 0.0);
        to.since = object.value("since", 0.0);
        to.hold = object.value("for", 0.0);
        for (std::size_t k = 0; k < quantities().size(); ++k) {
            const std::string name = quantities()[k].name;
            if (object.contains(name))
                to.bounds.push_back(bounds(object.at(name), static_cast<int>(k), at + "/" + name));
        }
        if (object.contains("clutch"))
            to.bounds.push_back(
                {.quantity = quantity_of(object.at("clutch") == "in" ? "clutch_in" : "clutch_out"),
                 .above = 0.5});
        if (object.contains("stopper"))
            to.bounds.push_back(object.at("stopper") == "on"
                                    ? Bounds{.quantity = quantity_of("stopper_on"), .above = 0.5}
                                    : Bounds{.quantity = quantity_of("stopper_on"), .below = 0.5});
        if (object.contains("anchor"))
            for (const std::string& phase : texts(object.at("anchor")))
                to.phases |=
                    1U << static_cast<unsigned>(std::max(0, place_of(words::kAnchorPhaseNames, phase)));
        to.times = object.value("times", 1);
        read_signs(object, at, to);
        for (const auto& [field, list] : {std::pair("either", &to.either), std::pair("not", &to.neither)})
            if (object.contains(field))
                for (const std::string& name : texts(object.at(field)))
                    list->push_back(named(name, at + "/" + field, to.side));
        if (to.since > 0 && to.signs.empty())
            fault(at + "/since",
                  "nothing stands beside it that could have come; name an event, report, moment "
                  "or order, or use \"for\" or \"time\"");
        if (to.hold > 0) to.memory = lesson_.held++;
        return to;
    }

    Bounds bounds(const Json& value, int quantity, const std::string& at) {
        if (value.is_boolean())
            return value.get<bool>() ? Bounds{.quantity = quantity, .above = 0.5}
                                     : Bounds{.quantity = quantity, .below = 0.5};
        if (value.is_number()) return {.quantity = quantity, .at_least = value.get<double>()};
        const Bounds to{.quantity = quantity,
                        .above = value.value("above", -kNoLimit),
                        .below = value.value("below", kNoLimit)};
        if (to.above >= to.below) fault(at, "above is not below \"below\": nothing can lie between");
        return to;
    }

    void read_signs(const Json& object, const std::string& at, Condition& to) {
        if (object.contains("event"))
            for (const std::string& code : texts(object.at("event"))) {
                if (place_of(words::kEventNames, code) < 0)
                    fault(at + "/event",
                          unknown(code, {words::kEventNames.begin(), words::kEventNames.end()}));
                to.signs.push_back({SignKind::event, watch(lesson_, {code, to.side})});
            }
        if (object.contains("report"))
            for (const std::string& code : texts(object.at("report")))
                to.signs.push_back({SignKind::report,
                                    watch(lesson_, WatchedReport{static_cast<exercise::ReportCode>(std::max(
                                                                     0, place_of(words::kReportNames, code))),
                                                                 to.side})});
        if (object.contains("moment"))
            for (const std::string& id : texts(object.at("moment")))
                to.signs.push_back({SignKind::moment, reference(moments_, id, at + "/moment", "moments")});
        for (const auto& [field, kind] :
             {std::pair("given", SignKind::order_given), std::pair("repeated", SignKind::order_repeated),
              std::pair("answered", SignKind::order_answered), std::pair("done", SignKind::order_done),
              std::pair("challenged", SignKind::order_challenged)})
            if (object.contains(field))
                for (const std::string& id : texts(object.at(field)))
                    to.signs.push_back({kind, reference(orders_, id, at + "/" + field, "orders")});
    }

    void read_moments() {
        lesson_.moments.resize(moments_.size()); // their places are referred to before they are read
        for (std::size_t k = 0; k < moments_.size(); ++k)
            lesson_.moments[k] = {moments_[k], condition(json_.at("moments").at(moments_[k]),
                                                         "/lesson/moments/" + moments_[k], lesson_.side)};
    }

    static bool waits_for_later(const Condition& when, int place) {
        const auto later = [place](const Condition& one) { return waits_for_later(one, place); };
        return std::ranges::any_of(when.signs,
                                   [place](const Sign& sign) {
                                       return sign.kind >= SignKind::order_given && sign.index >= place;
                                   }) ||
               std::ranges::any_of(when.either, later) || std::ranges::any_of(when.neither, later);
    }

    void read_order(const Json& one, const std::string& at) {
        LessonOrder order{.id = one.at("id"), .given = {}, .when = {}, .unsafe = {}, .done = {}};
        exercise::BridgeOrderGiven& given = order.given;
        given.code = static_cast<exercise::BridgeOrderCode>(
            std::max(0, place_of(words::kBridgeOrderNames, one.at("code"))));
        given.side = side(one, at, lesson_.side);
        given.value = one.value("value", 0.0);
        given.text = one.value("text", "");
        given.by = "bridge";
        given.repeat_within = one.value("repeat", 0.0);
        given.do_within = one.value("do", 0.0);
        const bool needs_value = given.code == exercise::BridgeOrderCode::pay_out ||
                                 given.code == exercise::BridgeOrderCode::veer ||
                                 given.code == exercise::BridgeOrderCode::walk_out;
        if (needs_value && given.value <= 0 && !lesson_.bridge_manned)
            fault(at + "/value", "is missing: how far the cable is to go out, shackles (m for walk_out)");
        const std::size_t place = lesson_.orders.size();
        if (one.contains("when")) {
            order.when = condition(one.at("when"), at + "/when", lesson_.side);
            if (waits_for_later(order.when, static_cast<int>(place)))
                fault(at + "/when", "waits for an order that comes after it, and so would never be given; "
                                    "put it behind that one");
        } else if (place > 0) {
            order.when.side = lesson_.side;
            order.when.signs.push_back(
                {lesson_.patience > 0 ? SignKind::order_answered : SignKind::order_done,
                 static_cast<int>(place) - 1});
        }
        if (one.contains("unsafe")) order.unsafe = condition(one.at("unsafe"), at + "/unsafe", lesson_.side);
        // An order to both is carried out when both have done it, unless its condition names one.
        const bool names_one = one.contains("done") && one.at("done").contains("side");
        for (const int to : given.side >= 0 ? std::vector{given.side}
                            : names_one     ? std::vector{lesson_.side}
                                            : sides_)
            order.done.push_back(one.contains("done") ? condition(one.at("done"), at + "/done", to)
                                                      : usual_done(lesson_, given, to));
        lesson_.orders.push_back(std::move(order));
    }

    /// A bridge that is manned orders what it likes, and as often. A question is answered, which is no state.
    void lay_what_it_may_order() {
        for (const int to : sides_)
            for (std::size_t code = 0; code < words::kBridgeOrderNames.size(); ++code) {
                const exercise::BridgeOrderGiven given{.code = static_cast<exercise::BridgeOrderCode>(code)};
                lesson_.usually_done.at(static_cast<std::size_t>(to))
                    .push_back(is_question(given.code) ? Condition{.side = to}
                                                       : usual_done(lesson_, given, to));
            }
    }

    void read_fault(const Json& one, const std::string& at) {
        LessonFault to;
        const std::string code = one.at("code");
        const int place = place_of(words::kFaultNames, code);
        if (place < 0) {
            fault(at + "/code", unknown(code, {words::kFaultNames.begin(), words::kFaultNames.end()}));
            return;
        }
        to.order.code = static_cast<exercise::FaultCode>(place);
        to.order.side = static_cast<exercise::Side>(std::max(0, side(one, at, lesson_.side)));
        to.order.ramp = one.value("ramp", 0.0);
        to.order.target = one.value("target", 0);
        to.one_of = one.value("one_of", "");
        if (one.contains("delay")) to.delay = range(one.at("delay"), at + "/delay");
        to.order.severity = one.value("severity", 1.0);
        if (one.contains("severity_between")) {
            to.severity = range(one.at("severity_between"), at + "/severity_between");
            to.order.severity = to.severity->at(1);
        }
        to.when.side = lesson_.side;
        if (one.contains("when")) to.when = condition(one.at("when"), at + "/when", lesson_.side);
        if (one.contains("clear")) to.clear = condition(one.at("clear"), at + "/clear", lesson_.side);
        lesson_.faults.push_back(to);
    }

    /// Two figures between which an attempt draws.
    std::array<double, 2> range(const Json& value, const std::string& at) {
        const std::array<double, 2> to{value.at(0).get<double>(), value.at(1).get<double>()};
        if (to[0] > to[1])
            fault(at, "the first figure is above the second: nothing can be drawn between them");
        return to;
    }

    void read_change(const Json& one, const std::string& at) {
        WeatherChange change{.at = one.value("at", 0.0), .over = one.value("over", 0.0)};
        const auto take = [&](const char* name, std::optional<double>& to, double unit) {
            if (one.contains(name)) to = unit * one.at(name).get<double>();
        };
        take("wind_speed", change.wind_speed, 1);
        take("wind_from_deg", change.wind_from, physics::radians_from_degrees(1));
        take("current_speed", change.current_speed, 1);
        take("current_towards_deg", change.current_towards, physics::radians_from_degrees(1));
        take("visibility", change.visibility, 1);
        if (!lesson_.schedule.empty() && change.at < lesson_.schedule.back().at)
            fault(at + "/at", "is before the entry above it; put the earlier change first");
        lesson_.schedule.push_back(change);
    }

    /// What a kind cannot do without.
    bool needs(const Json& one, const std::string& at, const char* field, const char* why) {
        if (one.contains(field)) return true;
        fault(at + "/" + field, std::string("is missing: ") + why);
        return false;
    }

    void read_criterion(const Json& one, const std::string& at) {
        Criterion to{.id = one.at("id"), .text = one.value("why", "")};
        to.kind =
            static_cast<CriterionKind>(std::max(0, place_of(words::kCriterionKindNames, one.at("kind"))));
        to.weight = one.value("weight", 10);
        to.must = one.value("must", false);
        to.objective = one.value("objective", "");
        if (!to.objective.empty()) reference(objectives_, to.objective, at + "/objective", "objectives");
        to.side = side(one, at, lesson_.side);
        if (one.contains("from")) to.from = condition(one.at("from"), at + "/from", to.side);
        if (one.contains("to")) to.to = condition(one.at("to"), at + "/to", to.side);
        if (one.contains("that")) to.that = condition(one.at("that"), at + "/that", to.side);
        switch (to.kind) {
        case CriterionKind::limit:
            read_limit(one, at, to);
            break;
        case CriterionKind::sequence:
            if (needs(one, at, "steps", "the states that are to come one after the other"))
                for (std::size_t k = 0; k < one.at("steps").size(); ++k)
                    to.steps.push_back(
                        condition(one.at("steps")[k], at + "/steps/" + std::to_string(k), to.side));
            to.within = one.value("within", kNoLimit);
            break;
        case CriterionKind::state_at:
            if (needs(one, at, "at", "the moment from which it is counted")) {
                to.at = reference(moments_, one.at("at"), at + "/at", "moments");
                to.after = one.value("after", 0.0);
            }
            to.graded = one.contains("zero");
            to.zero = one.value("zero", 0.0);
            if (to.graded && to.zero <= to.after)
                fault(at + "/zero", "is not above after: the mark cannot fall between them");
            needs(one, at, "that", "what is to be so then");
            break;
        case CriterionKind::order:
            if (needs(one, at, "orders", "the orders that are judged"))
                for (const std::string& id : texts(one.at("orders")))
                    to.orders.push_back(reference(orders_, id, at + "/orders", "orders"));
            break;
        case CriterionKind::report:
            read_report(one, at, to);
            break;
        case CriterionKind::prohibited:
        case CriterionKind::final:
            needs(one, at, "that",
                  to.kind == CriterionKind::final ? "what is to be so at the end" : "what must never be so");
            break;
        case CriterionKind::question:
            read_question(one, at, to);
            break;
        case CriterionKind::rubric:
            break;
        }
        lesson_.criteria.push_back(std::move(to));
    }

    /// Place of the figure of that name.
    int known_quantity(const std::string& name, const std::string& at) {
        const int place = quantity_of(name);
        if (place >= 0) return place;
        std::vector<std::string> known;
        for (const Quantity& quantity : quantities())
            known.emplace_back(quantity.name);
        fault(at, unknown(name, known));
        return 0;
    }

    void read_limit(const Json& one, const std::string& at, Criterion& to) {
        to.min = one.value("min", -kNoLimit);
        to.max = one.value("max", kNoLimit);
        if (needs(one, at, "of", "the figure that is limited")) {
            to.quantity = known_quantity(one.at("of"), at + "/of");
        }
        if (!one.contains("min") && !one.contains("max"))
            fault(at + "/max", "is missing: a limit needs \"max\" or \"min\", in the figure's unit");
        if (to.min > to.max) fault(at + "/min", "is above max: nothing could be within");
        to.fail_below = one.value("fail_below", -kNoLimit);
        to.fail_above = one.value("fail_above", kNoLimit);
        if (to.fail_above < to.max || to.fail_below > to.min)
            fault(at + (to.fail_above < to.max ? "/fail_above" : "/fail_below"),
                  "lies within the limit: the mark would be lost before the limit is passed");
        to.grace = one.value("grace", 0.0);
        to.put_right = one.value("put_right", false);
        to.zero = one.value("zero", to.grace + 10);
        if (to.zero <= to.grace)
            fault(at + "/zero", "is not above grace: s outside that cost nothing come before those that cost "
                                "all");
    }

    void read_report(const Json& one, const std::string& at, Criterion& to) {
        if (!needs(one, at, "report", "the code of the report")) return;
        to.report =
            static_cast<exercise::ReportCode>(std::max(0, place_of(words::kReportNames, one.at("report"))));
        const bool usual = lay_usual_truth(lesson_, to);
        if (one.contains("truth")) {
            to.truth = ReportTruth::moment;
            to.truth_moment = static_cast<int>(lesson_.moments.size());
            Condition truth = condition(one.at("truth"), at + "/truth", to.side);
            lesson_.moments.push_back({"", std::move(truth)});
            if (!usual || to.half <= 0) to.early = 5, to.full = 30, to.half = 60;
        } else if (one.contains("that")) {
            to.truth = ReportTruth::state;
            to.that = condition(one.at("that"), at + "/that", to.side);
        } else if (!usual) {
            fault(at + "/truth",
                  "is missing: when is \"" + one.at("report").get<std::string>() +
                      "\" true? Give a condition for the moment (\"truth\"), or for the state (\"that\")");
        }
        to.early = one.value("early", to.early);
        to.full = one.value("full", to.full);
        to.half = one.value("half", std::max(to.half, to.full));
        to.count = one.value("count", 1);
        to.false_calls = one.value("false_calls", 0);
        if (one.contains("orders"))
            for (const std::string& id : texts(one.at("orders")))
                to.orders.push_back(reference(orders_, id, at + "/orders", "orders"));
        if (!to.orders.empty() && to.truth != ReportTruth::figure)
            fault(at + "/orders", "belong to reports of a figure alone; use \"from\" for the others");
        if (to.orders.size() > kSlots)
            fault(at + "/orders", "are more than " + std::to_string(kSlots) + ", which is the most");
        if (to.half < to.full) fault(at + "/half", "is below full: half a mark comes after a full one");
    }

    void read_question(const Json& one, const std::string& at, Criterion& criterion) {
        criterion.question = static_cast<int>(lesson_.questions.size());
        Question to{.criterion = static_cast<int>(lesson_.criteria.size()),
                    .ask = one.value("ask", ""),
                    .forecastle = one.value("seat", std::string(kSeats[0])) == kSeats[0],
                    .meant_for = one.value("meant_for", 0.0)};
        needs(one, at, "ask", "the question as the seat reads it");
        if (needs(one, at, "when", "at what the exercise holds for it")) {
            to.when = condition(one.at("when"), at + "/when", criterion.side);
            if (one.at("when").empty())
                fault(at + "/when",
                      "names nothing that must hold, so that it would be asked at once; name what "
                      "he could have noticed by then");
        }
        if (one.contains("of") == one.contains("choices"))
            fault(at + "/of", "a question wants a number, of the figure that is named here, or one of its "
                              "\"choices\": give the one or the other");
        if (one.contains("of")) read_number_asked(one, at, to);
        if (one.contains("choices"))
            for (std::size_t k = 0; k < one.at("choices").size(); ++k) {
                const Json& choice = one.at("choices")[k];
                const std::string place = at + "/choices/" + std::to_string(k) + "/that";
                if (choice.at("that").empty())
                    fault(place, "is empty, so that this answer would always be right");
                to.choices.push_back(
                    {choice.at("answer"), condition(choice.at("that"), place, criterion.side)});
            }
        lesson_.questions.push_back(std::move(to));
    }

    void read_number_asked(const Json& one, const std::string& at, Question& to) {
        to.quantity = known_quantity(one.at("of"), at + "/of");
        const Quantity& quantity = quantity_at(to.quantity);
        to.unit = one.value("unit", quantity.unit);
        to.one = one_of(to.unit, quantity);
        if (to.one == 0) {
            fault(at + "/unit", '"' + to.unit + "\": " + quantity.name + " is in " + quantity.unit +
                                    "; that, kN or t for N, kn for m/s, shackles for m");
            to.one = 1;
        }
        to.period = quantity.period / to.one;
        if (needs(one, at, "tolerance", "by how much the number may be off, in its unit"))
            to.tolerance = one.at("tolerance");
        to.step = one.value("step", to.tolerance);
    }

    void read_hint(const Json& one, const std::string& at) {
        const Json& when = one.at("when");
        Hint to{.id = one.at("id"),
                .say = one.at("say"),
                .when = condition(when, at + "/when", lesson_.side),
                .forecastle = one.value("seat", std::string(kSeats[0])) == kSeats[0]};
        if (when.contains("side")) to.side = to.when.side;
        if (when.empty())
            fault(at + "/when",
                  "names nothing that must hold, so that the hint would come at once; name what "
                  "the hand could notice by then");
        if (to.say.find_first_not_of(" \t\n") == std::string::npos)
            fault(at + "/say", "is empty; write what an instructor would murmur at that moment");
        if (one.contains("criterion"))
            to.criterion = reference(criteria_, one.at("criterion"), at + "/criterion", "criteria");
        lesson_.hints.push_back(std::move(to));
    }

    void read_end() {
        if (!json_.contains("end")) return;
        const Json& end = json_.at("end");
        if (end.contains("good")) lesson_.good = condition(end.at("good"), "/lesson/end/good", lesson_.side);
        lesson_.time_limit = end.value("time", 0.0);
        if (end.contains("abort"))
            for (const std::string& code : texts(end.at("abort"))) {
                if (place_of(words::kEventNames, code) < 0)
                    fault("/lesson/end/abort",
                          unknown(code, {words::kEventNames.begin(), words::kEventNames.end()}));
                lesson_.abort.push_back({code});
            }
        if (!end.contains("accidents")) return;
        for (std::size_t k = 0; k < end.at("accidents").size(); ++k) {
            const Json& one = end.at("accidents")[k];
            const std::string at = "/lesson/end/accidents/" + std::to_string(k) + "/when";
            if (one.at("when").empty())
                fault(at, "names nothing that must hold, so that the lesson would end at once; name what is "
                          "an accident");
            lesson_.abort.push_back({one.at("say"), condition(one.at("when"), at, lesson_.side)});
        }
    }

    void read_runs() {
        if (json_.contains("model_run")) lesson_.model_run.scripts = texts(json_.at("model_run"));
        read_list("also_right", [&](const Json& one, const std::string&) {
            lesson_.also_right.push_back({texts(one.at("script")), one.value("about", ""), {}});
        });
        if (json_.contains("hands"))
            for (const auto& [name, should] : json_.at("hands").items())
                lesson_.hands.emplace_back(name, should.get<std::string>());
        read_list("errors", [&](const Json& one, const std::string& at) {
            LessonRun run{texts(one.at("script")), one.value("about", ""), {}};
            for (const std::string& id : texts(one.at("fails"))) {
                reference(criteria_, id, at + "/fails", "criteria");
                run.fails.push_back(id);
            }
            lesson_.errors.push_back(std::move(run));
        });
    }

    void check_weights() {
        int sum = 0;
        for (const Criterion& criterion : lesson_.criteria)
            if (criterion.kind != CriterionKind::rubric) sum += criterion.weight;
        if (sum == 0) fault("/lesson/criteria", "nothing is judged: give at least one criterion a weight");
    }

    const Json& json_;
    const std::vector<int>& sides_;
    Lesson lesson_;
    std::vector<std::string> objectives_, orders_, criteria_, moments_, states_;
    int depth_ = 0; ///< of states that refer to states
    std::vector<std::string> faults_;
};

} // namespace

Lesson read_lesson(const std::string& text, const std::vector<int>& sides) {
    Json json = parse_json(text, "/lesson");
    LessonReader reader(json, sides);
    Lesson lesson = reader.read();
    std::string faults;
    for (const std::string& fault : reader.faults())
        faults += (faults.empty() ? "" : "\n") + fault;
    if (!faults.empty()) throw ConfigError(faults);
    exercise::StateHash hash;
    // One lesson has one hash, for practice or not.
    json.erase(kPractice);
    hash.text({"lesson"}, json.dump());
    lesson.hash = hash.value();
    return lesson;
}

std::string for_practice(const std::string& text) {
    if (text.empty()) return text;
    Json json = parse_json(text, "/lesson");
    json[kPractice] = true;
    return json.dump();
}

} // namespace windlass::assess
