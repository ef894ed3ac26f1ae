#include "door/class_history.hpp"

#include "instructor_console/history/history.hpp"
#include "instructor_console/lesson_files.hpp"
#include "recorder/debrief/again.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/wall_time.hpp"

#include <algorithm>
#include <chrono>
#include <map>

namespace windlass::door {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// By which somebody is known in the history: the name that they gave, which has no comma and no @ there.
std::string pseudonym_of(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == ',' || c == '@'; }, ' ');
    return name;
}

/// Files of lessons, as a class is opened with them, by the lessons' ids.
std::map<std::string, std::string> files_of(const json& lessons) {
    std::map<std::string, std::string> files;
    for (const auto& file : lessons.at("files"))
        if (file.at("lesson").is_string()) files.emplace(file.at("lesson"), file.at("name"));
    return files;
}

/// The attempts that recordings of that folder have in the history, by the recordings' names.
std::map<std::string, history::Listed> attempts_of(const fs::path& recordings, history::History& history) {
    const fs::path ours = fs::absolute(recordings).lexically_normal();
    std::map<std::string, history::Listed> found;
    for (history::Listed& each : history.list()) {
        const fs::path recording = each.recording;
        if (recording == (ours / recording.filename()).lexically_normal())
            found[recording.filename()] = std::move(each);
    }
    return found;
}

/// The attempt that it follows from; null: none.
json after(const history::NextLesson& next) {
    if (next.recording.empty()) return nullptr;
    return {{"lesson", next.lesson.id},
            {"recording", fs::path(next.recording).filename().string()},
            {"began_at", next.began_at}};
}

} // namespace

void ClassHistory::put(const AttemptMade& made) const {
    const fs::path folder = recordings_ / made.recording;
    recording::Recording recording({folder});
    std::vector<history::Seated> seats;
    for (const Part& each : made.parts)
        seats.push_back({.pseudonym = pseudonym_of(each.name),
                         .name = each.name,
                         .group = made.class_id,
                         .seat = name_of(each.place),
                         .part = each.judged ? part_words(each) : history::kNotJudged});
    const bool replace = true; // a seat that was another's before the last word of the class
    history::History(history_).add(debrief::read_attempt(recording), seats, folder, replace);
}

ClassHistory::AgainFrom ClassHistory::again_from(const fs::path& recording) const {
    const fs::path folder = recordings_ / recording.filename();
    if (recording.empty() || !fs::exists(folder)) return {.why_not = "its recording is here no more"};
    try {
        recording::Recording read({folder});
        const debrief::Attempt attempt = debrief::read_attempt(read);
        const auto again = debrief::again_of(attempt);
        if (!again) return {.why_not = "what is missing went wrong at no moment"};
        return {.from = {{"recording", recording.filename()},
                         {"position", attempt.position_of(again->from)},
                         {"time", again->from},
                         {"before", debrief::name_of(again->before)},
                         {"seconds", again->seconds},
                         {"lost", again->lost},
                         {"lost_at", again->lost_at},
                         {"standing", again->standing}}};
    } catch (const std::exception&) { // a part of it
        return {.why_not = "its recording cannot be read"};
    }
}

json ClassHistory::next(const std::vector<std::string>& names, const json& lessons) const {
    history::History history(history_);
    const std::vector<history::Offered> offered = console::offered_lessons(exercises_);
    const auto files = files_of(lessons);
    json all = json::array();
    for (const std::string& name : names)
        try {
            if (const auto next = history.next(pseudonym_of(name), offered)) {
                const AgainFrom again = next->practice ? again_from(next->recording) : AgainFrom{};
                all.push_back({{"name", name},
                               {"file", files.at(next->lesson.id)},
                               {"title", next->lesson.title},
                               {"why", next->why},
                               {"practice", next->practice},
                               {"after", after(*next)},
                               {"from", again.from},
                               {"no_from", again.why_not}});
            }
        } catch (const std::invalid_argument&) { // he is in no history: his seat was not recorded
        }
    return all;
}

std::string ClassHistory::judge(const AttemptJudged& judged) const {
    history::History history(history_);
    const auto all = attempts_of(recordings_, history);
    const auto attempt = all.find(judged.recording);
    if (attempt == all.end()) return "the history has no attempt of that recording";
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    try {
        history.confirm(
            attempt->second.attempt,
            {.by = judged.by, .score = judged.points, .outcome = judged.outcome, .note = judged.note},
            debrief::iso_time(std::chrono::nanoseconds(now).count()));
        return "";
    } catch (const std::invalid_argument& why) {
        return why.what();
    }
}

std::vector<AttemptJudged> ClassHistory::words(const std::vector<std::string>& recordings) const {
    history::History history(history_);
    const auto attempts = attempts_of(recordings_, history);
    std::vector<AttemptJudged> all;
    for (const std::string& recording : recordings) {
        const auto its = attempts.find(recording);
        if (its == attempts.end() || its->second.confirmed_by.empty()) continue;
        const auto& [_, one] = *its;
        all.push_back(
            {.recording = recording,
             .by = one.confirmed_by,
             .outcome = one.outcome,
             .points = one.score ? std::optional(static_cast<double>(*one.score) / 10) : std::nullopt,
             .note = one.note});
    }
    return all;
}

std::optional<debrief::LaterWord> ClassHistory::word_on(const std::string& recording) const {
    const auto words = this->words({recording});
    if (words.empty()) return std::nullopt;
    const AttemptJudged& word = words.front();
    return debrief::LaterWord{
        .by = word.by, .points = word.points, .outcome = word.outcome, .note = word.note};
}

} // namespace windlass::door
