#include "instructor_console/history/history_command.hpp"

#include "instructor_console/history/history.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/wall_time.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <iostream>

namespace windlass::history {

using nlohmann::ordered_json;

namespace {

std::int64_t unix_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

std::vector<Seated> seated(const HistoryOptions& options) {
    std::vector<Seated> all;
    for (std::size_t i = 0; i < options.trainees.size(); ++i) {
        const std::string& text = options.trainees[i];
        const auto equals = text.find('=');
        Seated each{.pseudonym = text.substr(0, equals),
                    .name = equals == text.npos ? "" : text.substr(equals + 1),
                    .group = options.group};
        if (i < options.seats.size()) each.seat = options.seats[i];
        all.push_back(std::move(each));
    }
    return all;
}

void tell(bool as_json, const std::string& text, ordered_json more) {
    if (!as_json) {
        std::cout << text << std::endl;
        return;
    }
    ordered_json done{{"ok", true}, {"done", text}};
    done.update(more);
    std::cout << done << std::endl;
}

void add(History& history, const HistoryOptions& options, bool as_json) {
    recording::Recording recording({options.recording});
    const auto attempt = debrief::read_attempt(recording, options.run);
    const std::string id = history.add(attempt, seated(options), options.recording, options.replace);
    std::string text =
        fmt::format("attempt {} at {} is in {}", id.substr(0, 8), attempt.exercise, options.file.string());
    if (!attempt.origin.complete) text += "; a part of its recording could not be read";
    tell(as_json, text, {{"attempt", id}, {"complete", attempt.origin.complete}});
}

void list(History& history, const HistoryOptions& options, bool as_json) {
    const auto all = history.list({.trainee = options.trainee, .lesson = options.lesson});
    ordered_json rows = ordered_json::array();
    for (const Listed& each : all) {
        rows.push_back(
            {{"attempt", each.attempt},
             {"began_at", each.began_at},
             {"lesson", each.lesson},
             {"title", each.title},
             {"trainees", each.trainees},
             {"score", each.score ? ordered_json(static_cast<double>(*each.score) / 10) : ordered_json()},
             {"outcome", each.outcome},
             {"hints", each.hints},
             {"ended", each.ended},
             {"confirmed_by", each.confirmed_by},
             {"note", each.note},
             {"recording", each.recording}});
    }
    if (as_json) {
        std::cout << rows << std::endl;
        return;
    }
    fmt::print("{:8}  {:20}  {:24}  {:>6}  {:21}  {:12}  {}\n", "attempt", "begun", "lesson", "points",
               "outcome", "confirmed by", "trainees");
    const auto outcome = [](const Listed& each) {
        if (each.outcome == "practice")
            return fmt::format("for practice, {} hint{}", each.hints, each.hints == 1 ? "" : "s");
        return each.outcome.empty() ? std::string("-") : each.outcome;
    };
    for (const Listed& each : all)
        fmt::print("{:8}  {:20}  {:24}  {:>6}  {:21}  {:12}  {}\n", each.attempt.substr(0, 8), each.began_at,
                   each.lesson,
                   each.score ? fmt::format("{:.1f}", static_cast<double>(*each.score) / 10) : "-",
                   outcome(each), each.confirmed_by.empty() ? "-" : each.confirmed_by, each.trainees);
    std::fflush(stdout);
}

void tell_next(History& history, const HistoryOptions& options, bool as_json,
               const std::vector<Offered>& offered) {
    const auto next = history.next(options.trainee, offered);
    if (!next) return tell(as_json, "all lessons are achieved", {{"lesson", nullptr}});
    std::string text = fmt::format("{} {}{}\n{}", next->lesson.id, next->lesson.title,
                                   next->practice ? ", for practice" : "", next->why);
    if (!next->recording.empty())
        text += fmt::format("\nwhat would have kept each point: recorder whatif {}", next->recording);
    tell(as_json, text,
         {{"lesson", next->lesson.id},
          {"title", next->lesson.title},
          {"why", next->why},
          {"recording", next->recording},
          {"began_at", next->began_at},
          {"practice", next->practice}});
}

void write_csv(History& history, const HistoryOptions& options) {
    const std::string csv = history.csv(options.with_names);
    if (options.output == "-") {
        std::cout << csv << std::flush;
        return;
    }
    std::ofstream file(options.output, std::ios::binary | std::ios::trunc);
    if (!(file << csv) || !file.flush()) throw std::runtime_error(options.output.string() + ": cannot write");
}

void erase(History& history, const HistoryOptions& options, bool as_json) {
    const auto erased = history.erase(options.trainee, debrief::iso_time(unix_ns()));
    std::string text =
        fmt::format("{} is {} from now on; marks stay, of nobody", options.trainee, erased.pseudonym);
    for (const std::string& recording : erased.recordings)
        text += fmt::format("\nnot erased, may show who it was: {}", recording);
    tell(as_json, text, {{"pseudonym", erased.pseudonym}, {"recordings", erased.recordings}});
}

void keep(History& history, const HistoryOptions& options, bool as_json) {
    constexpr double day = 86400e9; // ns
    const auto removed =
        history.keep_since(debrief::iso_time(unix_ns() - static_cast<std::int64_t>(options.days * day)));
    tell(as_json,
         fmt::format("{} attempt{} older than {:g} days removed", removed, removed == 1 ? "" : "s",
                     options.days),
         {{"removed", removed}});
}

} // namespace

void add_history(CLI::App& app, HistoryOptions& options, const std::function<void()>& chosen) {
    using What = HistoryOptions::What;
    CLI::App* history =
        app.add_subcommand("history", "who did which lesson when, and how it went: a file on this computer");
    history->fallthrough();
    history->require_subcommand(1);
    history->add_option("--file", options.file, "the file (SQLite)")->capture_default_str();
    const auto add = [&](const char* name, const char* text, What what) -> CLI::App& {
        CLI::App* sub = history->add_subcommand(name, text);
        sub->fallthrough();
        sub->callback([&options, chosen, what] {
            if (what == What::add && !options.seats.empty() &&
                options.seats.size() != options.trainees.size())
                throw CLI::ValidationError("--seat", "one for each --trainee, or none");
            options.what = what;
            chosen();
        });
        return *sub;
    };
    CLI::App& put = add("add", "put a recorded attempt in, or bring it up to date", What::add);
    put.add_option("recording", options.recording, "folder of a recording, or its MCAP file")
        ->required()
        ->check(CLI::ExistingPath);
    put.add_option("--run", options.run, "which run of it, 1: the first (default: the last)")
        ->check(CLI::Range(1, 1'000'000));
    put.add_option("--trainee", options.trainees,
                   "PSEUDONYM or PSEUDONYM=NAME of who had a seat; may be given several times")
        ->required();
    put.add_option("--seat", options.seats, "of that trainee (default: forecastle); each has his own");
    put.add_flag("--replace", options.replace, "who has a seat already gives way to who is named now");
    put.add_option("--group", options.group, "class or crew");

    CLI::App& show = add("list", "the attempts, by time", What::list);
    show.add_option("--trainee", options.trainee, "of that pseudonym");
    show.add_option("--lesson", options.lesson, "of that lesson or exercise, by name");

    CLI::App& next = add("next", "the lesson that somebody should do next, and why", What::next);
    next.add_option("trainee", options.trainee, "pseudonym")->required();
    next.add_option("--lessons", options.lessons,
                    "folder of the lessons that are offered: by their names, accidents last")
        ->check(CLI::ExistingDirectory)
        ->capture_default_str();

    CLI::App& confirm = add("confirm", "an assessor's word on an attempt", What::confirm);
    confirm.add_option("attempt", options.attempt, "its id, or enough of its beginning")->required();
    confirm.add_option("--by", options.by, "who says so")->required();
    confirm
        .add_option("--score", options.score,
                    "0..100 (default: as it stands, by an assessor's word or computed)")
        ->check(CLI::Range(0.0, 100.0));
    confirm.add_option("--outcome", options.outcome,
                       "achieved, not_yet or not_shown (default: as a --score has it by the lesson's pass, "
                       "else as it stands)");
    confirm.add_option("--note", options.note, "why; 10 characters at least")->required();

    CLI::App& csv = add("export", "all of it as CSV, a row for each seat", What::write_csv);
    csv.add_flag("--csv", options.csv, "the form; there is no other yet");
    csv.add_option("--output", options.output, "file; - is stdout")->capture_default_str();
    csv.add_flag("--with-names", options.with_names, "and not only pseudonyms");

    CLI::App& gone =
        add("erase", "take a person out: name, group and pseudonym; marks stay, of nobody", What::erase);
    gone.add_option("trainee", options.trainee, "pseudonym")->required();

    CLI::App& kept = add("keep", "remove what is older", What::keep);
    kept.add_option("days", options.days, "to keep")->required()->check(CLI::Range(0.0, 36500.0));
    history->footer(
        "Nothing leaves this computer unless it is exported. Recordings are files of their own, and stay.");
}

void carry_out(const HistoryOptions& options, bool as_json,
               const std::function<std::vector<Offered>(const std::filesystem::path&)>& offered) {
    using What = HistoryOptions::What;
    if (options.what != What::add && !std::filesystem::exists(options.file))
        throw std::runtime_error(options.file.string() +
                                 ": there is no history yet; `history add` begins one");
    History history(options.file);
    switch (options.what) {
    case What::add:
        return add(history, options, as_json);
    case What::list:
        return list(history, options, as_json);
    case What::next:
        return tell_next(history, options, as_json, offered(options.lessons));
    case What::confirm:
        return tell(as_json,
                    fmt::format("confirmed by {}: {}", options.by,
                                history.confirm(options.attempt,
                                                {options.by, options.score, options.outcome, options.note},
                                                debrief::iso_time(unix_ns()))),
                    {});
    case What::write_csv:
        return write_csv(history, options);
    case What::erase:
        return erase(history, options, as_json);
    case What::keep:
        return keep(history, options, as_json);
    }
}

} // namespace windlass::history
