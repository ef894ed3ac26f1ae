#include "recorder/debrief/records.hpp"

#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/moments.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/debrief/wall_time.hpp"
#include "recorder/recording/sha256.hpp"
#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::debrief {

using nlohmann::ordered_json;

std::string uuid_of(std::string_view text) {
    std::string hex = recording::sha256(text).substr(0, 32);
    hex[12] = '8';                                                               // version
    hex[16] = "89ab"[(hex[16] >= 'a' ? hex[16] - 'a' + 10 : hex[16] - '0') & 3]; // variant
    return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4),
                       hex.substr(16, 4), hex.substr(20));
}

std::string attempt_id(const Attempt& attempt) {
    return uuid_of(fmt::format("attempt {} {}", attempt.origin.sha256, attempt.origin.run));
}

std::string ended_by(const Attempt& attempt) {
    switch (attempt.assessment ? attempt.assessment->ending() : LESSON_GOES_ON) {
    case LESSON_DONE:
        return "good";
    case LESSON_TIME_UP:
        return "time";
    case LESSON_BROKEN_OFF:
        return "abort";
    case LESSON_ENDED_EARLY:
        return attempt.state == RUN_STOPPED_BY_FAULT ? "abort" : "instructor";
    case LESSON_GOES_ON:
        break;
    }
    if (attempt.state == RUN_STOPPED_BY_FAULT) return "abort";
    return attempt.state == RUN_FINISHED ? "instructor" : "";
}

namespace {

/// Points are given in tenths.
double tenths(double points) {
    return std::round(points * 10) / 10;
}

/// A field of RFC 4180, in quotes where it has to be.
std::string field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

class Table {
public:
    explicit Table(const Attempt& attempt) : attempt_(attempt) {}

    void add(std::string_view section, std::optional<double> time, int side, std::string_view name,
             std::optional<double> value, std::string_view unit, std::string_view text) {
        text_ += fmt::format("{},{},{},{},{},{},{},{}\r\n", section, time ? fmt::format("{:.3f}", *time) : "",
                             time ? fmt::format("{:.3f}", attempt_.position_of(*time)) : "",
                             side == SIDE_PORT || side == SIDE_STARBOARD ? station::side_name(side) : "",
                             field(name), value ? fmt::format("{}", *value) : "", unit, field(text));
    }
    const std::string& text() const { return text_; }

private:
    const Attempt& attempt_;
    std::string text_ = "section,time (s),recorded (s),side,name,value,unit,text\r\n";
};

/// The latest word of the assessor on the whole; nullptr: not confirmed.
const AssessorWord* confirmation(const Attempt& attempt) {
    const AssessorWord* last = nullptr;
    for (const AssessorWord& word : attempt.words)
        if (word.command.criterion().size() == 0 && word.command.verdict() == VERDICT_CONFIRMED) last = &word;
    return last;
}

/// null: of a limit that was never looked at.
ordered_json worst_of(const Criterion& criterion) {
    if (criterion.kind() == CRITERION_LIMIT && !was_looked_at(criterion)) return nullptr;
    return criterion.worst();
}

ordered_json criteria_json(const Attempt& attempt) {
    ordered_json all = ordered_json::array();
    for (const Mark& mark : judgement_of(attempt).marks) {
        const Criterion& criterion = *mark.criterion;
        ordered_json each{{"code", criterion.code().to_string()},
                          {"text", criterion.text().to_string()},
                          {"kind", station::name(criterion.kind())},
                          {"state", station::name(criterion.state())},
                          {"must", criterion.must()},
                          {"objective", criterion.objective().to_string()},
                          {"weight", criterion.weight()},
                          {"milli_computed", criterion.milli()},
                          {"milli", criterion.counted()},
                          {"counts", criterion.counts()},
                          {"met", criterion.met()},
                          {"hinted", was_hinted(attempt, criterion)},
                          {"points_lost", mark.lost},
                          {"limit", criterion.limit()},
                          {"worst", worst_of(criterion)},
                          {"unit", criterion.unit().to_string()},
                          {"time_outside", criterion.time_outside()},
                          {"time", mark.time},
                          {"reason", criterion.reason().to_string()}};
        if (mark.word != nullptr)
            each["assessor"] = {{"by", mark.word->by}, {"note", mark.word->command.note().to_string()}};
        all.push_back(std::move(each));
    }
    return all;
}

ordered_json assessment_json(const Attempt& attempt) {
    if (!attempt.assessment) return nullptr;
    const Assessment& assessment = *attempt.assessment;
    ordered_json objectives = ordered_json::array();
    for (const Achievement& each : achievements_of(attempt))
        objectives.push_back({{"id", each.id},
                              {"text", each.text},
                              {"stcw", each.stcw},
                              {"score", tenths(each.score)},
                              {"pass", each.pass},
                              {"outcome", each.outcome}});
    ordered_json hints = ordered_json::array();
    for (const HintGiven& hint : assessment.hints())
        hints.push_back({{"time", attempt.time_of(hint.tick())},
                         {"id", hint.id().to_string()},
                         {"seat", hint.forecastle() ? "forecastle" : "bridge"},
                         {"criterion", hint.criterion().to_string()},
                         {"text", hint.text().to_string()}});
    const AssessorWord* confirmed = confirmation(attempt);
    return {{"score", tenths(assessment.score())},
            {"score_computed", tenths(assessment.score_computed())},
            {"finished", assessment.finished()},
            {"pass", assessment.pass()},
            {"outcome", assessment.outcome().to_string()},
            {"abort", assessment.abort().to_string()},
            {"lesson_hash", fmt::format("{:016x}", assessment.lesson_hash())},
            {"assessment_hash", fmt::format("{:016x}", assessment.assessment_hash())},
            {"confirmed_by", confirmed == nullptr ? ordered_json() : ordered_json(confirmed->by)},
            {"practice", assessment.practice()},
            {"hints", std::move(hints)},
            {"objectives", std::move(objectives)},
            {"criteria", criteria_json(attempt)}};
}

std::string done_words(const OrderSaid& order) {
    if (order.question) return "";
    if (order.done_before)
        return "; carried out at " + station::clock(*order.done_before) + ", before it was said again";
    if (!order.judged) return "";
    return order.done ? "; carried out at " + station::clock(*order.done) : "; not carried out";
}

ordered_json optional(std::optional<double> value) {
    return value ? ordered_json(*value) : ordered_json();
}

} // namespace

std::string csv_of(const Attempt& attempt) {
    Table table(attempt);
    for (const Figure& each : figures_of(attempt))
        table.add("figure", {}, -1, each.id, each.value, each.unit, each.words);
    for (const Mark& mark : judgement_of(attempt).marks)
        table.add("criterion", mark.time, -1, mark.criterion->code().to_string(),
                  mark.criterion->counted() / 10.0, "%", mark.criterion->reason().to_string());
    for (const Moment& each : moments_of(attempt))
        table.add("moment", each.time, each.side, "", {}, "", each.what);
    for (const OrderSaid& each : orders_said(attempt))
        table.add("order", each.given, -1, fmt::format("{}", each.number),
                  each.repeated ? std::optional(*each.repeated - each.given) : std::nullopt, "s",
                  each.words + ": " + each.state + done_words(each));
    for (const ReportSaid& each : reports_said(attempt))
        table.add("report", each.time, each.side, each.code, each.delay, each.delay ? "s" : "",
                  each.words + (each.truth.empty() ? "" : "; truth: " + each.truth));
    for (const Event& each : attempt.events)
        table.add("event", each.time(), each.side(), each.code().to_string(), each.value(), "",
                  each.text().to_string());
    return table.text();
}

ordered_json json_of(const Attempt& attempt) {
    const Origin& origin = attempt.origin;
    ordered_json figures = ordered_json::object(), moments = ordered_json::array(),
                 orders = ordered_json::array(), reports = ordered_json::array(),
                 events = ordered_json::array();
    for (const Figure& each : figures_of(attempt))
        figures[each.id] = {{"value", each.value}, {"unit", each.unit}};
    for (const Moment& each : moments_of(attempt))
        moments.push_back({{"time", each.time},
                           {"recorded", attempt.position_of(each.time)},
                           {"side", station::side_name(each.side)},
                           {"what", each.what}});
    for (const OrderSaid& each : orders_said(attempt))
        orders.push_back({{"number", each.number},
                          {"given", each.given},
                          {"order", each.words},
                          {"by", each.by},
                          {"state", each.state},
                          {"repeated", optional(each.repeated)},
                          {"judged", each.judged},
                          {"done", optional(each.done)},
                          {"answered", optional(each.answered)},
                          {"answer", each.answer}});
    for (const ReportSaid& each : reports_said(attempt))
        reports.push_back({{"time", each.time},
                           {"code", each.code},
                           {"report", each.words},
                           {"by", each.by},
                           {"value", each.value},
                           {"true_value", optional(each.true_value)},
                           {"truth", each.truth},
                           {"delay", optional(each.delay)},
                           {"milli", each.milli ? ordered_json(*each.milli) : ordered_json()}});
    for (const Event& each : attempt.events)
        events.push_back({{"time", each.time()},
                          {"code", each.code().to_string()},
                          {"severity", station::name(each.severity())},
                          {"side", station::side_name(each.side())},
                          {"value", each.value()},
                          {"text", each.text().to_string()}});
    return {{"attempt", attempt_id(attempt)},
            {"recording", origin.recording},
            {"recording_sha256", origin.sha256},
            {"run", origin.run},
            {"complete", origin.complete},
            {"exercise", attempt.exercise},
            {"title", attempt.title},
            {"definition_hash", fmt::format("{:016x}", attempt.definition_hash)},
            {"began", iso_time(origin.began_unix_ns)},
            {"duration", attempt.duration()},
            {"lesson_over", optional(attempt.lesson_over())},
            {"ended", ended_by(attempt)},
            {"figures", std::move(figures)},
            {"assessment", assessment_json(attempt)},
            {"moments", std::move(moments)},
            {"orders", std::move(orders)},
            {"reports", std::move(reports)},
            {"events", std::move(events)}};
}

} // namespace windlass::debrief
