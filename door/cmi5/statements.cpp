#include "door/cmi5/statements.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>

namespace windlass::cmi5 {

using nlohmann::json;

namespace {

constexpr const char* kVerbs = "http://adlnet.gov/expapi/verbs/";
constexpr const char* kCmi5 = "https://w3id.org/xapi/cmi5/context/categories/cmi5";
constexpr const char* kMoveOn = "https://w3id.org/xapi/cmi5/context/categories/moveon";
constexpr const char* kMasteryScore = "https://w3id.org/xapi/cmi5/context/extensions/masteryscore";
constexpr const char* kOurs = "urn:windlass:extension:"; // as a debriefing's xAPI has them

std::string iso_time(std::int64_t unix_ms) {
    const std::time_t seconds = unix_ms / 1000;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[32];
    const std::string whole(text, std::strftime(text, sizeof text, "%FT%T", &parts));
    return fmt::format("{}.{:03}Z", whole, unix_ms % 1000);
}

std::string iso_duration(double seconds) {
    return fmt::format("PT{:.2f}S", std::max(0.0, seconds));
}

double tenths(double points) {
    return std::round(points * 10) / 10;
}

double scaled(const Marks& marks) {
    return std::round(marks.score * 10) / 1000;
}

/// What is there stays as it is, and what is ours comes beside it.
void add_category(json& context, const char* id) {
    json& categories = context["contextActivities"]["category"];
    if (categories.is_object()) categories = json::array({categories}); // as one alone may stand
    if (!categories.is_array()) categories = json::array();
    for (const json& each : categories)
        if (each.is_object() && each.value("id", "") == id) return;
    categories.push_back({{"objectType", "Activity"}, {"id", id}});
}

json statement(const About& about, const char* verb, const Stamp& stamp) {
    json context = about.context_template;
    context["registration"] = about.registration;
    if (!context.contains("platform")) context["platform"] = "Windlass";
    add_category(context, kCmi5);
    return {{"id", stamp.id},
            {"actor", about.actor},
            {"verb", {{"id", std::string(kVerbs) + verb}, {"display", {{"en", verb}}}}},
            {"object", {{"objectType", "Activity"}, {"id", about.activity}}},
            {"context", std::move(context)},
            {"timestamp", iso_time(stamp.at_unix_ms)}};
}

json objectives_of(const Marks& marks) {
    json all = json::array();
    for (const Marks::Objective& each : marks.objectives)
        all.push_back({{"id", each.id},
                       {"text", each.text},
                       {"stcw", each.stcw},
                       {"outcome", each.outcome},
                       {"score", tenths(each.score)}});
    return all;
}

} // namespace

Verdict verdict_of(const About& about, const Marks& marks) {
    if (!about.normal || marks.practice || !marks.ended_by_itself) return Verdict::none;
    const bool reached = !about.mastery_score || scaled(marks) >= *about.mastery_score;
    return marks.outcome == "achieved" && reached ? Verdict::passed : Verdict::failed;
}

json initialized(const About& about, const Stamp& stamp) {
    return statement(about, "initialized", stamp);
}

json judged(const About& about, const Marks& marks, Verdict verdict, const Stamp& stamp) {
    const bool passed = verdict == Verdict::passed;
    json made = statement(about, passed ? "passed" : "failed", stamp);
    add_category(made["context"], kMoveOn);
    if (about.mastery_score && !made["context"]["extensions"].contains(kMasteryScore))
        made["context"]["extensions"][kMasteryScore] = *about.mastery_score;
    const std::string ours(kOurs);
    made["result"] = {{"success", passed},
                      {"duration", iso_duration(marks.duration)},
                      {"extensions",
                       {{ours + "points", tenths(marks.score)},
                        {ours + "outcome", marks.outcome},
                        {ours + "objectives", objectives_of(marks)},
                        {ours + "recording", marks.recording},
                        {ours + "recording_sha256", marks.recording_sha256}}}};
    if (passed || !about.mastery_score || scaled(marks) < *about.mastery_score)
        made["result"]["score"] = {{"scaled", scaled(marks)}};
    return made;
}

json completed(const About& about, const Marks& marks, const Stamp& stamp) {
    json made = statement(about, "completed", stamp);
    add_category(made["context"], kMoveOn);
    made["result"] = {{"completion", true}, {"duration", iso_duration(marks.duration)}};
    return made;
}

json terminated(const About& about, double duration, const Stamp& stamp) {
    json made = statement(about, "terminated", stamp);
    made["result"] = {{"duration", iso_duration(duration)}};
    return made;
}

std::vector<json> last_statements(const About& about, const std::optional<Marks>& marks, double duration,
                                  const std::function<Stamp()>& next) {
    std::vector<json> all;
    const Verdict verdict = marks ? verdict_of(about, *marks) : Verdict::none;
    // Of passed and completed a registration has one each, and nothing fails once it was passed.
    if (verdict != Verdict::none && !about.has_passed) all.push_back(judged(about, *marks, verdict, next()));
    if (verdict != Verdict::none && !about.has_completed) all.push_back(completed(about, *marks, next()));
    all.push_back(terminated(about, duration, next()));
    return all;
}

} // namespace windlass::cmi5
