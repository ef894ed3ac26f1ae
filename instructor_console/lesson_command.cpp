#include "instructor_console/lesson_command.hpp"

#include "instructor_console/hands_table.hpp"
#include "instructor_console/lesson_files.hpp"
#include "instructor_console/played_doubts.hpp"
#include "lesson/hands.hpp"
#include "lesson/play.hpp"
#include "lesson/whatif/words.hpp"
#include "station/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <set>
#include <tuple>

namespace windlass::console {

namespace {

namespace fs = std::filesystem;
using assess::CriterionState;

struct LessonOptions {
    std::vector<fs::path> files, scripts;
    fs::path folder = "config/exercises", from, output;
    std::string id, hand, note, criterion;
    unsigned seed = 1;
    unsigned chances = 1; ///< how often each run is played
    bool told = false;
    bool hands = false;
    bool practice = false;
    bool play = false; ///< check: play them, too
    bool first_must = false;
};

const char* word(CriterionState state) {
    switch (state) {
    case CriterionState::not_in_play:
        return "-";
    case CriterionState::open:
        return "open";
    case CriterionState::met:
        return "met";
    case CriterionState::not_met:
        return "MISSED";
    case CriterionState::overridden:
        return "set";
    }
    return "";
}

std::string time_of(const assess::HintResult& hint, const lesson::Played& played) {
    const assess::Result& result = played.result;
    return station::clock(result.time * static_cast<double>(hint.tick) / static_cast<double>(result.tick));
}

/// As read, or for practice.
exercise::ExerciseDef wanted(const LessonFile& file, const LessonOptions& options) {
    exercise::ExerciseDef def = file.def;
    if (options.practice) def.lesson = assess::for_practice(def.lesson);
    return def;
}

void print(const lesson::Played& played, bool told) {
    if (told)
        for (const lesson::Told& one : played.told)
            std::cout << fmt::format("{:>6} {}: {}\n", station::clock(one.time), one.who, one.text);
    std::cout << fmt::format("{:<22} {:>6} {:>7} {:>5}  {}\n", "criterion", "", "points", "of", "why");
    for (const assess::CriterionResult& one : played.result.criteria)
        std::cout << fmt::format("{:<22} {:>6} {:>7} {:>5}  {}{}\n", one.code, word(one.state),
                                 points(one.weight * one.milli / 100), one.weight, one.must ? "[must] " : "",
                                 one.reason);
    if (played.result.practice)
        std::cout << fmt::format("for practice, hints: {}\n", played.result.hints.size());
    for (const assess::HintResult& one : played.result.hints)
        std::cout << fmt::format("hint {} at {}, to the {}{}: {}\n", one.id, time_of(one, played),
                                 one.forecastle ? "forecastle" : "bridge",
                                 one.criterion.empty() ? "" : ", on " + one.criterion, one.text);
    for (const assess::ObjectiveResult& one : played.result.objectives)
        std::cout << fmt::format("objective {}: {} ({} points) {}\n", one.id,
                                 assess::outcome_name(one.outcome), points(one.tenths), one.text);
    std::cout << fmt::format("{} after {}: {} of 100 points{}{}\n",
                             assess::outcome_name(played.result.outcome), station::clock(played.time),
                             points(played.result.tenths),
                             played.result.abort.empty() ? "" : "; ended: " + played.result.abort,
                             played.stuck.empty() ? "" : "\nthe script was not done: " + played.stuck)
              << std::flush;
}

int run(const LessonOptions& options) {
    const LessonFile file = read_lesson_file(options.files.front());
    const auto scripts =
        options.scripts.empty() ? scripts_of(file, file.lesson.model_run) : load_scripts(options.scripts);
    print(lesson::play(wanted(file, options), scripts, {}, lesson::luck(options.seed - 1)), options.told);
    return station::kOk;
}

int check(const LessonOptions& options) {
    for (const fs::path& path : options.files) {
        const LessonFile file = read_lesson_file(path);
        check_scripts(file);
        std::cout << fmt::format(
            "{}: lesson {} is sound: {} orders, {} criteria, {} typical errors, {} hints\n", path.string(),
            file.lesson.id, file.lesson.orders.size(), file.lesson.criteria.size(), file.lesson.errors.size(),
            file.lesson.hints.size());
        for (const std::string& doubt : doubts(file))
            std::cout << fmt::format("  {}\n", doubt);
        if (options.play)
            for (const std::string& told : played_doubts(file))
                std::cout << fmt::format("  {}\n", told) << std::flush;
    }
    return station::kOk;
}

int list(const LessonOptions& options) {
    for (const fs::path& path : lesson_files(options.folder)) {
        const LessonFile file = read_lesson_file(path);
        std::cout << fmt::format("{:<6} {:<34} {}\n", file.lesson.id, path.filename().string(),
                                 file.lesson.title);
    }
    return station::kOk;
}

int make_new(const LessonOptions& options) {
    const fs::path to = options.output.empty() ? options.folder / (options.id + ".json") : options.output;
    if (fs::exists(to)) throw std::runtime_error(to.string() + ": is there already; give another --output");
    std::ofstream out(to);
    out << new_lesson(options.id, options.from);
    out.close();
    if (!out) throw std::runtime_error(to.string() + ": cannot be written");
    std::cout << fmt::format("{}: written; change it, then: lesson check {}\n", to.string(), to.string());
    return station::kOk;
}

/// Whether a run shows what the lesson says of it. fails: empty for the model run.
bool as_said(const lesson::Played& played, const std::vector<std::string>& fails) {
    if (fails.empty()) return played.result.outcome == assess::Outcome::achieved;
    // What is named is missed, and no other must.
    return played.result.outcome == assess::Outcome::not_yet &&
           std::ranges::all_of(played.result.criteria, [&](const assess::CriterionResult& one) {
               const bool missed = one.state == CriterionState::not_met;
               const bool named = std::ranges::find(fails, one.code) != fails.end();
               return named ? missed : !(missed && one.must);
           });
}

/// "brake (0:41 ...)": what was missed, and why.
std::string missed(const lesson::Played& played) {
    std::string text;
    for (const assess::CriterionResult& one : played.result.criteria)
        if (one.state == CriterionState::not_met)
            text += (text.empty() ? "" : "<br>") + fmt::format("{}: {}", one.code, one.reason);
    return text;
}

/// The hints of an attempt for practice, with their times.
std::string hinted(const lesson::Played& played) {
    if (!played.result.practice) return {};
    std::string text = fmt::format("<br>for practice, hints: {}", played.result.hints.size());
    for (const assess::HintResult& one : played.result.hints)
        text += fmt::format("; {} {}", one.id, time_of(one, played));
    return text;
}

/// What of a run's marks is not always the same.
struct ByChance {
    std::vector<std::string> musts, others; ///< criteria that are met by one luck and not by another
    std::int64_t least = 0, most = 0;       ///< tenths of a point
    int as_said = 0;                        ///< of the attempts

    std::string text(unsigned attempts) const {
        if (attempts < 2) return {};
        std::string said = fmt::format("<br>by chance: {} to {} points, as the lesson says {} of {}",
                                       points(least), points(most), as_said, attempts);
        if (!others.empty()) said += fmt::format("; decides {}", fmt::join(others, ", "));
        if (!musts.empty()) said += fmt::format("; **decides the must {}**", fmt::join(musts, ", "));
        return said;
    }
};

/// The same hands with other luck each time: lesson::luck.
ByChance play_again(const exercise::ExerciseDef& def, const assess::LessonRun& run,
                    const std::vector<trainee::Script>& scripts, const lesson::Played& first,
                    unsigned attempts) {
    ByChance found;
    found.least = found.most = first.result.tenths;
    found.as_said = as_said(first, run.fails);
    std::set<std::string> musts, others;
    for (unsigned k = 1; k < attempts; ++k) {
        const lesson::Played again = lesson::play(def, scripts, {}, lesson::luck(k));
        found.least = std::min<std::int64_t>(found.least, again.result.tenths);
        found.most = std::max<std::int64_t>(found.most, again.result.tenths);
        found.as_said += as_said(again, run.fails);
        for (std::size_t i = 0; i < first.result.criteria.size(); ++i) {
            const auto& [was, is] = std::tie(first.result.criteria[i], again.result.criteria.at(i));
            if (was.state != is.state) (was.must ? musts : others).insert(was.code);
        }
    }
    found.musts.assign(musts.begin(), musts.end());
    found.others.assign(others.begin(), others.end());
    return found;
}

/// Generic hands, one line each: what the lesson made of it, and what it should.
bool try_hands(const LessonFile& file, HandsTable& table) {
    bool all = true;
    const auto model = scripts_of(file, file.lesson.model_run);
    for (const lesson::Hand& hand : lesson::hands(file.lesson, model)) {
        const lesson::Played played = lesson::play(file.def, hand.parts);
        const std::string fault = lesson::fault_of(hand, played);
        all = all && fault.empty();
        table.add(file.lesson.id, hand, played);
        std::cout << fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", file.lesson.id, hand.name,
                                 lesson::should_name(hand.should), points(played.result.tenths),
                                 assess::outcome_name(played.result.outcome), station::clock(played.time),
                                 fault.empty() ? played.result.abort : "**" + fault + "**")
                  << std::flush;
    }
    return all;
}

/// One generic hand at one lesson, with its marks.
int one_hand(const LessonOptions& options) {
    if (options.files.size() != 1) throw std::runtime_error("--hand: give one file of a lesson");
    const LessonFile file = read_lesson_file(options.files.front());
    const auto model = scripts_of(file, file.lesson.model_run);
    std::string names;
    for (const lesson::Hand& hand : lesson::hands(file.lesson, model)) {
        names += " " + hand.name;
        if (hand.name != options.hand) continue;
        print(lesson::play(file.def, hand.parts, {}, lesson::luck(options.seed - 1)), options.told);
        return station::kOk;
    }
    throw std::runtime_error("--hand: " + options.hand + ": allowed here:" + names);
}

int hands(const LessonOptions& options) {
    if (!options.hand.empty()) return one_hand(options);
    const auto open = [&](std::ios::openmode mode) {
        std::ofstream out(options.output, mode);
        if (!out) throw std::runtime_error(options.output.string() + ": cannot be written");
        return out;
    };
    if (!options.output.empty()) open(std::ios::app); // what cannot be written is told before all is played
    bool all = true;
    HandsTable table;
    std::cout << "| lesson | hand | should | points | outcome | time | |\n|---|---|---|---|---|---|---|\n";
    for (const fs::path& path : options.files.empty() ? lesson_files(options.folder) : options.files)
        all = try_hands(read_lesson_file(path), table) && all;
    if (options.output.empty())
        std::cout << "\n" << table.table();
    else if (!(open(std::ios::trunc) << table.document(options.output.string(), options.note)).flush())
        throw std::runtime_error(options.output.string() + ": cannot be written");
    return all ? station::kOk : station::kFailed;
}

int attempt(const LessonOptions& options) {
    if (options.hands || !options.hand.empty()) return hands(options);
    bool all = true;
    std::cout
        << "| lesson | run | points | outcome | time | what it lost, and why |\n|---|---|---|---|---|---|\n";
    for (const fs::path& path : options.files.empty() ? lesson_files(options.folder) : options.files) {
        const LessonFile file = read_lesson_file(path);
        std::vector<assess::LessonRun> runs = file.lesson.also_right;
        runs.insert(runs.end(), file.lesson.errors.begin(), file.lesson.errors.end());
        if (!file.lesson.model_run.scripts.empty()) runs.insert(runs.begin(), file.lesson.model_run);
        for (const assess::LessonRun& one : runs) {
            const auto scripts = scripts_of(file, one);
            const exercise::ExerciseDef def = wanted(file, options);
            const lesson::Played played = lesson::play(def, scripts);
            const ByChance by_chance = play_again(def, one, scripts, played, options.chances);
            const bool good = as_said(played, one.fails) && by_chance.musts.empty();
            all = all && good;
            std::cout << fmt::format("| {} | {} | {} | {}{} | {} | {} |\n", file.lesson.id,
                                     one.about.empty() ? "done right" : one.about,
                                     points(played.result.tenths),
                                     assess::outcome_name(played.result.outcome),
                                     good ? "" : " **not as the lesson says**", station::clock(played.time),
                                     missed(played) + hinted(played) + by_chance.text(options.chances))
                      << std::flush;
        }
    }
    return all ? station::kOk : station::kFailed;
}

/// Of what an attempt lost, in the order in which it did, what is asked about: all, one by its id, or the
/// must that it lost first (where it lost none, what it lost first).
std::vector<std::string> asked_about(const whatif::Trials& trials, const LessonOptions& options) {
    std::vector<std::string> lost = whatif::lost_criteria(trials);
    if (!options.criterion.empty())
        std::erase_if(lost, [&](const std::string& code) { return code != options.criterion; });
    if (!options.first_must || lost.size() < 2) return lost;
    const auto& all = trials.recorded().criteria;
    const auto must = std::ranges::find_if(lost, [&](const std::string& code) {
        return std::ranges::find(all, code, &assess::CriterionResult::code)->must;
    });
    return {must == lost.end() ? lost.front() : *must};
}

/// What would have kept each point that the typical errors lose, a row of a table each.
int what_if(const LessonOptions& options) {
    std::cout
        << "| lesson | error | lost | what if | marks | branches | s |\n|---|---|---|---|---|---|---|\n";
    for (const fs::path& path : options.files.empty() ? lesson_files(options.folder) : options.files) {
        const LessonFile file = read_lesson_file(path);
        const auto model = scripts_of(file, file.lesson.model_run);
        for (const assess::LessonRun& error : file.lesson.errors) {
            whatif::Attempt attempt;
            lesson::play(file.def, scripts_of(file, error),
                         [&](const run::Session& session) { whatif::put_down(attempt, session); });
            whatif::Trials trials(attempt, model);
            for (const std::string& code : asked_about(trials, options)) {
                const std::clock_t began = std::clock();
                const whatif::Answer answer = whatif::what_if(trials, code);
                std::cout << fmt::format("| {} | {} | {}{} | {} | {} | {} | {:.1f} |\n", file.lesson.id,
                                         error.about, code, answer.lost.must ? " (must)" : "",
                                         whatif::remedy_words(trials, answer),
                                         whatif::marks_words(trials, answer), answer.tried,
                                         static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC)
                          << std::flush;
            }
        }
    }
    return station::kOk;
}

} // namespace

void add_lesson(CLI::App& app, const std::function<void(std::function<int()>)>& chosen) {
    auto options = std::make_shared<LessonOptions>();
    CLI::App* lesson =
        app.add_subcommand("lesson", "lesson files on this computer: check, play, begin a new one");
    lesson->fallthrough();
    lesson->require_subcommand(1);
    const auto add = [&](const char* name, const char* text, int (*work)(const LessonOptions&)) {
        CLI::App* sub = lesson->add_subcommand(name, text);
        sub->fallthrough();
        sub->callback([options, chosen, work] { chosen([options, work] { return work(*options); }); });
        return sub;
    };
    CLI::App* sub = add("check", "whether files are sound: each mistake with its place and a remedy", check);
    sub->add_option("file", options->files, "exercise files with a lesson")->required();
    sub->add_flag(
        "--play", options->play,
        "play the model run, too: musts and orders that it never meets, when each fault could first "
        "be noticed, and all runs at the ends of what the lesson leaves to chance");
    sub = add("list", "the lessons of a folder", list);
    sub->add_option("folder", options->folder, "of exercise files")->capture_default_str();
    sub = add("new", "write a lesson to begin with", make_new);
    sub->add_option("id", options->id, "its short name, e.g. L30")->required();
    sub->add_option("--from", options->from, "exercise whose ship and sea it has; default: let_go_port_25m");
    sub->add_option("--folder", options->folder, "of exercise files")->capture_default_str();
    sub->add_option("--output", options->output, "file; default: ID.json in the folder");
    sub = add("run", "play a lesson at once and print its marks", run);
    sub->add_option("file", options->files, "exercise file with a lesson")->required()->expected(1);
    sub->add_option("--script", options->scripts,
                    "scripts of trainees, one for each windlass; default: the lesson's model run");
    sub->add_flag("--told", options->told, "print what was said and done, too");
    const auto add_seed = [&](CLI::App* command, const char* text) {
        command->add_option("--seed", options->seed, text)->check(CLI::Range(1, 1000))->capture_default_str();
    };
    const auto add_practice = [&](CLI::App* command) {
        command->add_flag("--practice", options->practice,
                          "with the lesson's hints, as it is played for practice");
    };
    add_practice(sub);
    add_seed(sub, "of what the attempt leaves to chance, with as many millimetres of water, other gusts, and "
                  "hands up to 1.5 s later");
    sub = add("try", "play model run and typical errors, and say whether they show what the lesson says",
              attempt);
    sub->add_option("file", options->files, "exercise files; default: every lesson of the folder");
    sub->add_option("--folder", options->folder, "of exercise files")->capture_default_str();
    add_practice(sub);
    sub->add_flag("--hands", options->hands,
                  "hands that the author did not write instead: idle, repeating, crying, too far, ...");
    sub->add_option("--output", options->output,
                    "with --hands: file for the table of lessons and hands; else standard output");
    sub->add_option("--note", options->note, "written above that table: date, machine, commit");
    sub->add_option("--hand", options->hand, "one of these hands by its name, with its marks");
    sub->add_flag("--told", options->told, "with --hand: print what was said and done, too");
    add_seed(sub, "with --hand: as of lesson run");
    sub->add_option("--chances", options->chances,
                    "how often each run is played, each time with another seed: which marks chance decides")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    sub = add("whatif", "what would have kept each point that the typical errors lose; long", what_if);
    sub->add_option("file", options->files, "exercise files; default: every lesson of the folder");
    sub->add_option("--folder", options->folder, "of exercise files")->capture_default_str();
    sub->add_option("--criterion", options->criterion, "only this one, by its id");
    sub->add_flag("--first-must", options->first_must, "of each error only the must that it lost first");
}

} // namespace windlass::console
