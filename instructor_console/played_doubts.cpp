#include "instructor_console/played_doubts.hpp"

#include "lesson/cues.hpp"
#include "lesson/ends_of_chance.hpp"
#include "station/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace windlass::console {

namespace {

void doubt_model_run(const LessonFile& file, const std::vector<trainee::Script>& model,
                     std::vector<std::string>& all) {
    const assess::Lesson& lesson = file.lesson;
    std::set<std::size_t> silent;
    const lesson::Played played = lesson::play(file.def, model, [&](const run::Session& session) {
        silent.clear();
        const auto& orders = session.assessor().state().orders;
        for (std::size_t k = 0; k < orders.size(); ++k)
            if (!orders[k].asked_for && !orders[k].skipped) silent.insert(k);
    });
    for (const assess::CriterionResult& one : played.result.criteria)
        if (one.must && !one.met)
            all.push_back(
                fmt::format("/lesson/criteria ({}): is a must, and the model run does not meet it: {}",
                            one.code, one.reason));
    if (!lesson.bridge_manned)
        for (const std::size_t k : silent)
            all.push_back(fmt::format("/lesson/orders ({}): is never given to the model run, nor is what "
                                      "waits for it",
                                      lesson.orders[k].id));
}

/// "brake: 0:41 wanted ...": the musts that a run misses.
std::string missed_musts(const lesson::Played& played) {
    std::string text;
    for (const assess::CriterionResult& one : played.result.criteria)
        if (one.must && !one.met)
            text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", one.code, one.reason);
    return text.empty() ? fmt::format("{}, with {:.1f} points", assess::outcome_name(played.result.outcome),
                                      0.1 * static_cast<double>(played.result.tenths))
                        : text;
}

/// A draw that comes near an end of its bounds is rare, and somebody's all the same.
void doubt_chance(const LessonFile& file, std::vector<std::string>& all) {
    std::vector<assess::LessonRun> right = file.lesson.also_right;
    right.insert(right.begin(), file.lesson.model_run);
    for (const lesson::AtAnEnd& end : lesson::ends_of_chance(file.def)) {
        for (const assess::LessonRun& run : right) {
            const lesson::Played played = lesson::play(end.def, scripts_of(file, run));
            if (played.result.outcome != assess::Outcome::achieved)
                all.push_back(fmt::format("/lesson/faults ({}): there the {} fails: {}", end.which,
                                          run.about.empty() ? "model run" : "run '" + run.about + "'",
                                          missed_musts(played)));
        }
        for (const assess::LessonRun& error : file.lesson.errors)
            if (lesson::play(end.def, scripts_of(file, error)).result.outcome == assess::Outcome::achieved)
                all.push_back(fmt::format("/lesson/faults ({}): there the typical error '{}' is achieved",
                                          end.which, error.about));
    }
}

/// "brake-lining-faded: at 5:12, to be noticed 0.8 s later by the noise of the brake".
std::string words(const lesson::Cue& cue) {
    const std::string at = fmt::format("/lesson/faults ({})", cue.fault);
    if (cue.raised < 0) return at + ": never comes in the model run";
    if (cue.noticed < 0)
        return fmt::format("{}: comes at {}, and nothing that anybody sees, hears or feels is otherwise", at,
                           station::clock(cue.raised));
    return fmt::format("{}: comes at {}, to be noticed {:.1f} s later: {}", at, station::clock(cue.raised),
                       cue.noticed - cue.raised, cue.sign);
}

void doubt_hints(const std::string& run, const std::vector<lesson::Cue>& cues,
                 std::vector<std::string>& all) {
    for (const lesson::Cue& cue : cues)
        if (!cue.hints.empty())
            all.push_back(fmt::format("/lesson/hints ({}): tells of {} before anybody can notice it ({})",
                                      fmt::join(cue.hints, ", "), cue.fault, run));
}

} // namespace

std::vector<std::string> played_doubts(const LessonFile& file) {
    std::vector<std::string> all;
    if (file.lesson.model_run.scripts.empty()) return all;
    const std::vector<trainee::Script> model = scripts_of(file, file.lesson.model_run);
    doubt_model_run(file, model, all);
    doubt_chance(file, all);
    exercise::ExerciseDef practice = file.def;
    practice.lesson = assess::for_practice(practice.lesson);
    const std::vector<lesson::Cue> cues = lesson::cues(practice, model);
    for (const lesson::Cue& cue : cues)
        all.push_back(words(cue));
    doubt_hints("model run", cues, all);
    if (file.lesson.hints.empty()) return all;
    for (const assess::LessonRun& error : file.lesson.errors)
        doubt_hints(error.about, lesson::cues(practice, scripts_of(file, error)), all);
    return all;
}

} // namespace windlass::console
