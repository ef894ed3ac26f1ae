#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/records.hpp"
#include "recorder/debrief/wall_time.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::debrief {

using nlohmann::ordered_json;

namespace {

/// Of the activities and extensions: names, nothing is served there.
constexpr std::string_view kOurs = "urn:windlass:";
constexpr std::string_view kVerbs = "http://adlnet.gov/expapi/verbs/";
constexpr std::string_view kLesson = "http://adlnet.gov/expapi/activities/lesson";
constexpr std::string_view kObjective = "http://adlnet.gov/expapi/activities/objective";

class Statements {
public:
    Statements(const Attempt& attempt, const Actor& actor)
        : attempt_(attempt),
          id_(attempt_id(attempt)),
          actor_{{"objectType", "Agent"},
                 {"account", {{"homePage", actor.home_page}, {"name", actor.pseudonym}}}} {}

    /// at: s of exercise.
    void add(std::string_view verb, const ordered_json& object, ordered_json result, double at,
             bool parent = false) {
        ordered_json context{{"registration", id_}, {"platform", "Windlass"}};
        if (parent) context["contextActivities"] = {{"parent", ordered_json::array({lesson()})}};
        ordered_json statement{
            {"id", uuid_of(fmt::format("{} {} {}", id_, verb, object["id"].get<std::string>()))},
            {"actor", actor_},
            {"verb", {{"id", fmt::format("{}{}", kVerbs, verb)}, {"display", {{"en", verb}}}}},
            {"object", object}};
        if (!result.is_null()) statement["result"] = std::move(result);
        statement["context"] = std::move(context);
        // By the recorder's clock, at the speed at which it was run.
        statement["timestamp"] = iso_time(attempt_.origin.recording_began_unix_ns +
                                          static_cast<std::int64_t>(attempt_.position_of(at) * 1e9));
        all_.push_back(std::move(statement));
    }

    ordered_json lesson() const {
        const bool taught = !attempt_.lesson.title.empty();
        return activity(fmt::format("lesson:{}", attempt_.exercise),
                        taught ? attempt_.lesson.title : attempt_.title, kLesson);
    }
    ordered_json objective(const Achievement& each) const {
        return activity(fmt::format("lesson:{}:objective:{}", attempt_.exercise, each.id),
                        each.text.empty() ? each.id : each.text, kObjective);
    }
    ordered_json take() { return std::move(all_); }

private:
    static ordered_json activity(const std::string& id, const std::string& title, std::string_view type) {
        return {{"objectType", "Activity"},
                {"id", fmt::format("{}{}", kOurs, id)},
                {"definition", {{"name", {{"en", title}}}, {"type", type}}}};
    }

    const Attempt& attempt_;
    std::string id_;
    ordered_json actor_;
    ordered_json all_ = ordered_json::array();
};

/// Points in tenths.
ordered_json score(double points) {
    const double tenths = std::round(points * 10);
    return {{"scaled", tenths / 1000}, {"raw", tenths / 10}, {"min", 0}, {"max", 100}};
}

} // namespace

ordered_json xapi_of(const Attempt& attempt, const Actor& actor) {
    Statements statements(attempt, actor);
    const ordered_json lesson = statements.lesson();
    const std::string lasted = iso_duration(attempt.duration());
    statements.add("initialized", lesson, nullptr, attempt.began);
    const bool ended = !ended_by(attempt).empty();
    if (ended)
        statements.add("completed", lesson, {{"completion", true}, {"duration", lasted}}, attempt.ended);
    if (attempt.assessment && attempt.assessment->finished()) {
        const Assessment& marks = *attempt.assessment;
        const bool passed = marks.outcome() == "achieved";
        const std::string ours(kOurs);
        // Practice shows no competence: it was neither passed nor failed.
        const bool practice = marks.practice();
        ordered_json result{
            {"score", score(marks.score())},
            {"completion", true},
            {"duration", lasted},
            {"extensions",
             {{ours + "extension:score_computed", marks.score_computed()},
              {ours + "extension:overridden", marks.score() != marks.score_computed()},
              {ours + "extension:practice", practice},
              {ours + "extension:hints", marks.hints().size()},
              {ours + "extension:outcome", marks.outcome().to_string()},
              {ours + "extension:assessment_hash", fmt::format("{:016x}", marks.assessment_hash())},
              {ours + "extension:lesson_hash", fmt::format("{:016x}", marks.lesson_hash())}}}};
        if (practice)
            result["response"] = practice_words(attempt);
        else
            result["success"] = passed;
        statements.add(practice ? "experienced"
                       : passed ? "passed"
                                : "failed",
                       lesson, std::move(result), attempt.ended);
        for (const Achievement& each : achievements_of(attempt)) {
            if (practice || each.outcome == "not_shown") continue;
            const bool achieved = each.outcome == "achieved";
            statements.add(achieved ? "passed" : "failed", statements.objective(each),
                           {{"score", score(each.score)}, {"success", achieved}}, attempt.ended, true);
        }
    }
    statements.add("terminated", lesson, {{"duration", lasted}}, attempt.ended);
    return statements.take();
}

} // namespace windlass::debrief
