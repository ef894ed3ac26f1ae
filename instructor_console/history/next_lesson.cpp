#include "instructor_console/history/next_lesson.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace windlass::history {

namespace {

using nlohmann::json;

/// One attempt of his.
struct Done {
    std::string attempt, outcome, recording, exercise, began_at;
    json lesson; ///< of its file; an object without members where none was attached to the recording
    bool practice;
    bool in_part; ///< another had the seat before or after him: it shows nobody's competence
    bool all;     ///< every objective was achieved, or an assessor's word stands on the whole

    bool is_achieved() const { return outcome == "achieved" && all; }
};

std::vector<Done> done_by(Database& database, const std::string& pseudonym) {
    if (database.run("SELECT id FROM trainee WHERE pseudonym = ?", {pseudonym}).empty())
        throw std::invalid_argument(fmt::format("\"{}\": there is no trainee of that pseudonym", pseudonym));
    std::vector<Done> all;
    for (const Row& row : database.run(
             "SELECT attempt.id, coalesce(outcome_final, outcome), recording, lesson.name, "
             "lesson.json, practice, min(part <> ''), outcome_final IS NOT NULL OR NOT EXISTS (SELECT "
             "1 FROM objective WHERE objective.attempt = attempt.id AND objective.outcome <> "
             "'achieved'), began_at FROM attempt "
             "JOIN lesson ON lesson.hash = lesson_hash JOIN seat ON seat.attempt = attempt.id "
             "JOIN trainee ON trainee.id = seat.trainee WHERE pseudonym = ? AND part <> ? GROUP BY "
             "attempt.id "
             "ORDER BY began_at, attempt.id",
             {pseudonym, std::string(kNotJudged)})) {
        const json file = json::parse(text_of(row[4]), nullptr, false);
        json lesson = file.is_object() ? file.value("lesson", json::object()) : json::object();
        all.push_back({text_of(row[0]), text_of(row[1]), text_of(row[2]), text_of(row[3]), text_of(row[8]),
                       std::move(lesson), integer_of(row[5]) == 1, integer_of(row[6]) == 1,
                       integer_of(row[7]) == 1});
    }
    return all;
}

/// "not yet: takes the weight from the motor; not shown: ..."; empty: every objective was achieved.
std::string missing(Database& database, const Done& of) {
    std::string text;
    for (const Row& row : database.run(
             "SELECT id, outcome FROM objective WHERE attempt = ? AND outcome <> 'achieved'", {of.attempt})) {
        std::string said = text_of(row[0]);
        for (const json& objective : of.lesson.value("objectives", json::array()))
            if (objective.value("id", "") == said) said = objective.value("text", said);
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ",
                            text_of(row[1]) == "not_shown" ? "not shown" : "not yet", said);
    }
    return text;
}

std::string why_again(Database& database, const Done& last) {
    const bool achieved = last.outcome == "achieved";
    if (achieved && last.in_part)
        return "another had the seat before or after; now alone, from beginning to end";
    if (achieved && last.practice) return "done for practice; now as a test, without hints";
    const std::string objectives = missing(database, last);
    return objectives.empty() ? "it was not achieved" : objectives;
}

} // namespace

std::optional<NextLesson> next_lesson(Database& database, const std::string& pseudonym,
                                      const std::vector<Offered>& offered) {
    const std::vector<Done> all = done_by(database, pseudonym);
    std::set<std::string> achieved, tried;
    for (const Done& each : all) {
        tried.insert(each.exercise);
        if (!each.practice && !each.in_part && each.is_achieved()) achieved.insert(each.exercise);
    }
    const auto open = [&](const Offered& lesson) { return !achieved.contains(lesson.exercise); };
    if (!all.empty()) {
        const Done& last = all.back();
        const auto again = std::ranges::find(offered, last.exercise, &Offered::exercise);
        if (again != offered.end() && open(*again))
            return {{*again, why_again(database, last), last.recording, last.began_at,
                     last.outcome != "achieved"}};
    }
    const auto first = std::ranges::find_if(offered, open);
    if (first == offered.end()) return std::nullopt;
    return {{*first,
             tried.contains(first->exercise) ? "tried before, and not achieved in all of it" : "not done yet",
             "", "", false}};
}

} // namespace windlass::history
