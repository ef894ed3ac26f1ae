#include "instructor_console/lesson_files.hpp"

#include "server/config/config.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::console {

namespace fs = std::filesystem;

LessonFile read_lesson_file(const fs::path& file) {
    LessonFile read{.file = file,
                    .root = fs::absolute(file).lexically_normal().parent_path().parent_path(),
                    .def = config::load_exercise(file),
                    .lesson = {}};
    if (read.def.lesson.empty())
        throw ConfigError(file.string() +
                          ": /lesson: is missing: this exercise has no lesson; add one, or begin with "
                          "\"instructor_console lesson new\"");
    std::vector<int> sides;
    for (const exercise::GroundTackleDef& tackle : read.def.tackle)
        sides.push_back(static_cast<int>(tackle.side));
    read.lesson = assess::read_lesson(read.def.lesson, sides);
    return read;
}

std::vector<trainee::Script> load_scripts(const std::vector<fs::path>& files) {
    std::vector<trainee::Script> scripts;
    for (const fs::path& file : files)
        scripts.push_back(trainee::load_script(file, trainee::Eyes::seat));
    return scripts;
}

std::vector<trainee::Script> scripts_of(const LessonFile& file, const assess::LessonRun& run) {
    std::vector<fs::path> scripts;
    for (const std::string& script : run.scripts)
        scripts.push_back(file.root / script);
    return load_scripts(scripts);
}

void check_scripts(const LessonFile& file) {
    std::string faults;
    const auto try_all = [&](const assess::LessonRun& run, const std::string& at) {
        for (const std::string& script : run.scripts)
            try {
                trainee::load_script(file.root / script, trainee::Eyes::seat);
            } catch (const ConfigError& error) {
                faults += fmt::format("{}{}: {}: {}", faults.empty() ? "" : "\n", file.file.string(), at,
                                      error.what());
            }
    };
    try_all(file.lesson.model_run, "/lesson/model_run");
    for (std::size_t k = 0; k < file.lesson.also_right.size(); ++k)
        try_all(file.lesson.also_right[k], fmt::format("/lesson/also_right/{}/script", k));
    for (std::size_t k = 0; k < file.lesson.errors.size(); ++k)
        try_all(file.lesson.errors[k], fmt::format("/lesson/errors/{}/script", k));
    if (!faults.empty()) throw ConfigError(faults);
}

namespace {

/// Marks that would not rank: one that alone fails the lesson, and guards that nothing brings into play.
void doubt_marks(const assess::Lesson& lesson, std::vector<std::string>& all) {
    using assess::CriterionKind;
    for (const assess::Objective& objective : lesson.objectives) {
        int sum = 0;
        for (const assess::Criterion& criterion : lesson.criteria)
            if (criterion.objective == objective.id) sum += criterion.weight;
        for (const assess::Criterion& criterion : lesson.criteria)
            if (criterion.objective == objective.id && !criterion.must &&
                100 * criterion.weight > (100 - objective.least()) * sum)
                all.push_back(fmt::format("/lesson/criteria ({}): is no must, and missed it fails objective "
                                          "{} and the lesson alone: give it less weight, or make it a must",
                                          criterion.id, objective.id));
    }
    for (const assess::Criterion& criterion : lesson.criteria) {
        const bool guards =
            criterion.kind == CriterionKind::limit || criterion.kind == CriterionKind::prohibited;
        if (guards && !criterion.from && !criterion.to)
            all.push_back(fmt::format("/lesson/criteria ({}): is in play before anything has been done; give "
                                      "it a \"from\"",
                                      criterion.id));
    }
}

/// Whether a condition goes by what only the exercise knows: no report, no order, no clock.
bool knows_the_truth(const assess::Condition& when) {
    const auto is_truth = [](const assess::Sign& sign) {
        return sign.kind == assess::SignKind::event || sign.kind == assess::SignKind::moment ||
               sign.kind == assess::SignKind::order_done;
    };
    return std::ranges::any_of(when.signs, is_truth) || std::ranges::any_of(when.either, knows_the_truth) ||
           std::ranges::any_of(when.neither, knows_the_truth);
}

void doubt_orders(const assess::Lesson& lesson, std::vector<std::string>& all) {
    if (lesson.orders.empty() || lesson.bridge_manned) return;
    if (lesson.patience <= 0)
        all.emplace_back("/lesson/patience: is not given: the bridge orders by what is so and asks nothing, "
                         "and may go silent");
    for (const assess::LessonOrder& order : lesson.orders)
        if (lesson.patience > 0 && knows_the_truth(order.when))
            all.push_back(fmt::format("/lesson/orders ({}): hangs on what no bridge can know; let it hang on "
                                      "a report or on what is answered",
                                      order.id));
}

/// Hints that come whatever the hand does.
void doubt_hints(const assess::Lesson& lesson, std::vector<std::string>& all) {
    for (const assess::Hint& hint : lesson.hints) {
        const assess::Condition& when = hint.when;
        if (when.bounds.empty() && when.phases == 0 && when.signs.empty() && when.either.empty() &&
            when.neither.empty())
            all.push_back(
                fmt::format("/lesson/hints ({}): comes by the clock, whatever the hand does; let it "
                            "hang on what he could notice",
                            hint.id));
    }
}

} // namespace

std::vector<std::string> doubts(const LessonFile& file) {
    const assess::Lesson& lesson = file.lesson;
    std::vector<std::string> all;
    if (lesson.briefing.empty())
        all.emplace_back("/lesson/briefing: the trainee reads nothing before it begins");
    if (!lesson.good && lesson.time_limit <= 0)
        all.emplace_back("/lesson/end: nothing ends it but an instructor");
    if (lesson.model_run.scripts.empty())
        all.emplace_back("/lesson/model_run: nothing shows that it can be done");
    for (const assess::Criterion& criterion : lesson.criteria)
        if (criterion.objective.empty() && criterion.kind != assess::CriterionKind::rubric)
            all.push_back(fmt::format("/lesson/criteria ({}): belongs to no objective", criterion.id));
    for (const assess::Objective& objective : lesson.objectives)
        if (std::ranges::none_of(lesson.criteria, [&](const assess::Criterion& criterion) {
                return criterion.objective == objective.id;
            }))
            all.push_back(fmt::format("/lesson/objectives ({}): no criterion shows it", objective.id));
    doubt_marks(lesson, all);
    doubt_orders(lesson, all);
    doubt_hints(lesson, all);
    return all;
}

std::vector<fs::path> lesson_files(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw std::runtime_error(folder.string() + ": is no folder; name the one with the exercise files");
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json" && read_json(entry.path()).contains("lesson"))
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

bool of_an_accident(std::string_view lesson_id) {
    return lesson_id.starts_with('A');
}

std::vector<history::Offered> offered_lessons(const fs::path& folder) {
    std::vector<history::Offered> all;
    for (const fs::path& path : lesson_files(folder)) {
        const LessonFile file = read_lesson_file(path);
        all.push_back({file.lesson.id, file.lesson.title, file.def.name});
    }
    std::ranges::stable_partition(all, [](const history::Offered& each) { return !of_an_accident(each.id); });
    return all;
}

std::string new_lesson(const std::string& id, const fs::path& from) {
    const nlohmann::ordered_json lesson{
        {"id", id},
        {"title", id + ": what is taught"},
        {"briefing", "Where the ship is, what is wanted, and what counts."},
        {"objectives", {{{"id", "run"}, {"text", "Lets go under control"}, {"stcw", "A-II/5 anchoring"}}}},
        {"moments", {{"bottom", {{"event", "anchor.on_bottom"}}}}},
        {"orders",
         {{{"id", "stand-by"}, {"code", "stand_by"}, {"when", {{"time", 5}}}},
          {{"id", "let-go"}, {"code", "let_go"}},
          {{"id", "hold-on"}, {"code", "hold_on"}, {"value", 4}, {"when", {{"shackles", 3.9}}}}}},
        {"criteria",
         {{{"id", "fall"},
           {"kind", "limit"},
           {"of", "cable_speed"},
           {"max", 5.5},
           {"weight", 30},
           {"objective", "run"},
           {"why", "A lining that runs hot fades"}},
          {{"id", "orders"},
           {"kind", "order"},
           {"orders", {"stand-by", "let-go", "hold-on"}},
           {"weight", 20},
           {"objective", "run"}},
          {{"id", "bottom"},
           {"kind", "report"},
           {"report", "on_the_bottom"},
           {"weight", 10},
           {"objective", "run"}}}},
        {"end", {{"good", {{"event", "anchor.brought_up"}, {"since", 30}}}, {"time", 1200}}}};
    const nlohmann::ordered_json document{{"$schema", "../schema/exercise.schema.json"},
                                          {"from", from.empty() ? "let_go_port_25m" : from.string()},
                                          {"name", id},
                                          {"title", id},
                                          {"lesson", lesson}};
    return document.dump(2) + "\n";
}

} // namespace windlass::console
