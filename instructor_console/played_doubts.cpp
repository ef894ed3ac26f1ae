#include "instructor_console/played_doubts.hpp"

#include "lesson/cues.hpp"
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
