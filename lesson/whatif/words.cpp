#include "lesson/whatif/words.hpp"

#include "common/figure_text.hpp"
#include "server/assess/quantities.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::whatif {

using nlohmann::ordered_json;

namespace {

/// "0:29.0"
std::string clock(double seconds) {
    const auto tenths = std::llround(seconds * 10);
    return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

std::string points(int tenths) {
    return fmt::format("{}.{}", tenths / 10, tenths % 10);
}

std::string lever_words(const Trials& trials, const Lever& lever) {
    return assess::lever_words(lever, trials.sides().size() > 1);
}

std::string report_words(const exercise::ReportMade& report) {
    if (report.code == exercise::ReportCode::order_repeated) {
        const std::string order =
            words::order_text(static_cast<std::size_t>(report.order_code), report.side, report.value);
        return fmt::format("\"{}\" repeated back", order.empty() ? report.text : order);
    }
    return '"' +
           words::report_text({.code = static_cast<std::size_t>(report.code),
                               .side = report.side,
                               .value = report.value,
                               .lead = report.lead,
                               .stay = static_cast<std::size_t>(report.stay),
                               .growing = static_cast<std::size_t>(report.growing),
                               .weight = static_cast<std::size_t>(report.weight)}) +
           '"';
}

const assess::Result* result_of(const Answer& answer) {
    return answer.kept ? &answer.kept->result : answer.taken_over ? &answer.taken_over->result : nullptr;
}

/// What came of the criterion: its figure where it has one.
std::string figure_words(const Trials& trials, const Answer& answer, const assess::Result& result) {
    const assess::Criterion& criterion = trials.lesson().criteria[answer.criterion];
    const assess::CriterionResult& now = result.criteria[answer.criterion];
    std::string text;
    if (criterion.kind == assess::CriterionKind::limit) {
        const assess::Quantity& quantity = assess::quantity_at(criterion.quantity);
        text = fmt::format("{} {} instead of {}, ", quantity.text, figure_text(now.worst, quantity.unit),
                           figure_text(answer.lost.worst, quantity.unit));
    }
    text += now.milli == 1000 ? "all of its points kept"
                              : fmt::format("{:.0f} % of its points kept instead of {:.0f}", 0.1 * now.milli,
                                            0.1 * answer.lost.milli);
    if (answer.lost.must && !answer.lost.met && now.met) text += ", the must is met";
    text += fmt::format("; {} points of 100 instead of {}", points(result.tenths),
                        points(trials.recorded().tenths));
    std::string besides;
    for (std::size_t k = 0; k < result.criteria.size(); ++k) {
        const auto &was = trials.recorded().criteria[k], &is = result.criteria[k];
        if (k != answer.criterion && was.counts && is.milli < was.milli)
            besides += (besides.empty() ? "" : ", ") + is.code;
    }
    return text + (besides.empty() ? "." : ", and less for " + besides + ".");
}

std::string sure_words(const Sure& sure, bool chance) {
    std::string stands, falls;
    const auto add = [&](const std::optional<bool>& one, const char* text) {
        if (!one) return;
        std::string& to = *one ? stands : falls;
        to += (to.empty() ? "" : ", ") + std::string(text);
    };
    add(sure.sooner, "0.2 s earlier");
    add(sure.later, "0.2 s later");
    add(sure.more, "2 % more");
    add(sure.less, "2 % less");
    add(sure.water, "with a millimetre more water");
    add(sure.gusts, "with other gusts");
    std::string text = stands.empty() ? "" : "Stands " + stands + ".";
    if (!falls.empty())
        text +=
            (text.empty() ? "" : " ") + ("Does not stand " + falls) + (chance ? ": chance decides." : ".");
    return text;
}

} // namespace

std::string change_words(const Trials& trials, const Change& change) {
    const std::string at = clock(trials.seconds(change.tick));
    const double was = change.was_tick ? trials.seconds(*change.was_tick) : 0;
    const std::string lever = lever_words(trials, change.lever);
    const std::string to = value_words(change.lever, change.value);
    const double apart = std::abs(trials.seconds(change.tick) - was);
    switch (change.kind) {
    case ChangeKind::report_given:
        return fmt::format("{} {} reported", at, report_words(change.report));
    case ChangeKind::report_moved:
        return apart < 0.05
                   ? fmt::format("{} {} reported, instead of what was", at, report_words(change.report))
                   : fmt::format("{} {} reported, {:.1f} s {} than what was at {}", at,
                                 report_words(change.report), apart,
                                 change.tick < *change.was_tick ? "earlier" : "later", clock(was));
    case ChangeKind::report_left_out:
        return fmt::format("{} {} not reported", at, report_words(change.report));
    case ChangeKind::order_repeated:
        return fmt::format("{} {} at once and as it was given", at, report_words(change.report));
    case ChangeKind::sooner:
    case ChangeKind::later:
        return fmt::format("{} {} {} {:.1f} s {} than at {}", at, lever, to, apart,
                           change.kind == ChangeKind::sooner ? "earlier" : "later", clock(was));
    case ChangeKind::more:
    case ChangeKind::less:
        return fmt::format("{} {} {} instead of {}", at, lever, to,
                           value_words(change.lever, change.was_value));
    case ChangeKind::left_out:
        return fmt::format("{} {} left {}, not {}", at, lever, to,
                           value_words(change.lever, change.was_value));
    case ChangeKind::one_more:
        return fmt::format("{} {} {}, which stood {}", at, lever, to,
                           value_words(change.lever, change.was_value));
    }
    return "";
}

std::string remedy_words(const Trials& trials, const Answer& answer) {
    if (answer.kept)
        return fmt::format("{}: {} Other hands as recorded. {}", change_words(trials, answer.kept->change),
                           figure_words(trials, answer, answer.kept->result),
                           sure_words(answer.kept->sure, !answer.kept->sure.stands()));
    std::string text = "No single change that was tried keeps it, other hands as recorded. ";
    if (!trials.has_model()) return text + "The lesson's model hands were not there to be tried.";
    if (!answer.taken_over) return text + "Nor do the model's hands, whenever they take over.";
    const TakenOver& taken = *answer.taken_over;
    text += fmt::format("The model's hands keep it where they take over up to {}, and not later: {}",
                        clock(taken.time), figure_words(trials, answer, taken.result));
    if (taken.first)
        text += fmt::format(" What they first do otherwise: {}.", change_words(trials, *taken.first));
    return text + " " + sure_words(taken.sure, !taken.sure.stands());
}

std::string marks_words(const Trials& trials, const Answer& answer) {
    const assess::Result* result = result_of(answer);
    return points(trials.recorded().tenths) + (result == nullptr ? "" : " -> " + points(result->tenths));
}

std::string answer_words(const Trials& trials, const Answer& answer) {
    return fmt::format("{}{}: {}\n  {}", answer.lost.code, answer.lost.must ? " (must)" : "",
                       answer.lost.reason, remedy_words(trials, answer));
}

namespace {

constexpr std::array kKinds{
    "report_given", "report_moved", "report_left_out", "order_repeated", "sooner", "later",
    "more",         "less",         "left_out",        "one_more"};
constexpr std::array kLevers{"brake", "speed_lever", "clutch", "stopper", "engine", "rudder"};

ordered_json json_of(const Trials& trials, const Change& change) {
    ordered_json json{{"kind", kKinds.at(static_cast<std::size_t>(change.kind))},
                      {"words", change_words(trials, change)},
                      {"time", trials.seconds(change.tick)},
                      {"tick", change.tick}};
    json["was_time"] = change.was_tick ? ordered_json(trials.seconds(*change.was_tick)) : ordered_json();
    if (change.kind <= ChangeKind::order_repeated) return json;
    json["lever"] = kLevers.at(static_cast<std::size_t>(change.lever.kind));
    if (!change.lever.of_helm())
        json["side"] = change.lever.side == exercise::Side::port ? "port" : "starboard";
    json["value"] = change.value;
    json["was_value"] = change.was_value;
    return json;
}

ordered_json json_of(const Sure& sure) {
    const auto one = [](const std::optional<bool>& tried) {
        return tried ? ordered_json(*tried) : ordered_json();
    };
    return {{"sooner", one(sure.sooner)}, {"later", one(sure.later)}, {"more", one(sure.more)},
            {"less", one(sure.less)},     {"water", one(sure.water)}, {"gusts", one(sure.gusts)}};
}

ordered_json json_of(const assess::Result& result, std::size_t criterion) {
    return {{"milli", result.criteria[criterion].milli},
            {"worst", result.criteria[criterion].worst},
            {"points", 0.1 * result.tenths},
            {"outcome", assess::outcome_name(result.outcome)},
            {"reason", result.criteria[criterion].reason}};
}

} // namespace

ordered_json json_of(const Trials& trials, const std::vector<Answer>& answers) {
    ordered_json json{{"lesson", trials.lesson().id},
                      {"points", 0.1 * trials.recorded().tenths},
                      {"outcome", assess::outcome_name(trials.recorded().outcome)},
                      {"lost", ordered_json::array()}};
    for (const Answer& answer : answers) {
        ordered_json one{{"criterion", answer.lost.code},
                         {"must", answer.lost.must},
                         {"time", answer.lost_time},
                         {"was", json_of(trials.recorded(), answer.criterion)},
                         {"words", answer_words(trials, answer)},
                         {"hands", answer.kept         ? "as_recorded"
                                   : answer.taken_over ? "model"
                                                       : "none_helps"}};
        if (answer.kept) {
            one["change"] = json_of(trials, answer.kept->change);
            one["least_steps"] = answer.kept->least_steps;
            one["sure"] = json_of(answer.kept->sure);
            one["chance"] = !answer.kept->sure.stands();
            one["then"] = json_of(answer.kept->result, answer.criterion);
        } else if (answer.taken_over) {
            one["last_moment"] = answer.taken_over->time;
            if (answer.taken_over->first) one["first_otherwise"] = json_of(trials, *answer.taken_over->first);
            one["sure"] = json_of(answer.taken_over->sure);
            one["chance"] = !answer.taken_over->sure.stands();
            one["then"] = json_of(answer.taken_over->result, answer.criterion);
        }
        one["tried"] = answer.tried;
        one["gone_through"] = answer.gone_through;
        json["lost"].push_back(std::move(one));
    }
    return json;
}

} // namespace windlass::whatif
