// recorder debrief: a recording as a page to talk over, and as tables for machines.

#include "recorder/command.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/records.hpp"
#include "recorder/debrief/scenes.hpp"
#include "recorder/debrief/side_by_side.hpp"
#include "recorder/ghost.hpp"
#include "recorder/remedies.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

namespace windlass::recorder {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct DebriefOptions {
    std::vector<fs::path> paths, over;
    std::size_t run = 0;
    fs::path output, csv, json, xapi;
    std::string station;
    bool what_if = false, no_ghost = false;
    fs::path ghost;
    fs::path config = "config";
    debrief::Actor actor{.home_page = "urn:windlass:trainees", .pseudonym = {}};
};

void write(const fs::path& path, const std::string& text) {
    if (path == "-") {
        std::cout << text << std::flush;
        return;
    }
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!(file << text) || !file.flush())
        throw std::runtime_error(path.string() + ": cannot write: " + std::generic_category().message(errno));
    tell("wrote " + path.string());
}

std::string dumped(const ordered_json& value) {
    return value.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

debrief::Attempt read(const std::vector<fs::path>& paths, std::size_t run, bool& whole, bool pictures) {
    recording::Recording recording(paths);
    auto attempt = debrief::read_attempt(recording, run);
    if (pictures) debrief::read_scenes(recording, attempt);
    for (const auto& damage : recording.damage())
        tell(damage);
    whole = whole && attempt.origin.complete;
    return attempt;
}

/// The lesson as other hands did it: of the recording that is named, else the model run. Nothing: it is not
/// wanted, there was no lesson, or no_ghost says why it cannot be had. Throws std::runtime_error when the
/// recording that is named is of something else.
std::optional<debrief::Attempt> ghost_of(const DebriefOptions& options, const debrief::Attempt& attempt,
                                         bool& whole, std::string& no_ghost) {
    if (!options.ghost.empty()) {
        auto ghost = read({options.ghost}, 0, whole, false);
        if (const std::string why = debrief::unlike(attempt, ghost); !why.empty())
            throw std::runtime_error("--ghost " + options.ghost.string() + ": " + why);
        return ghost;
    }
    if (options.no_ghost || !attempt.assessment) return std::nullopt;
    try {
        recording::Recording recording(options.paths);
        return model_ghost(recording, attempt, options.config);
    } catch (const std::runtime_error& error) {
        no_ghost = error.what();
        tell(fmt::format("the model run is not laid behind the curves: {}", no_ghost));
        return std::nullopt;
    }
}

int debrief_recording(const DebriefOptions& options) {
    bool whole = true;
    debrief::PageOptions page;
    if (!options.station.empty()) page.links = debrief::links_to(options.station);
    const auto attempt = read(options.paths, options.run, whole, true);
    const auto ghost = ghost_of(options, attempt, whole, page.no_ghost);
    if (ghost)
        page.ghost = debrief::Ghost{&*ghost, options.ghost.empty() ? debrief::kModelGhost
                                                                   : "as in " + ghost->origin.recording};
    std::vector<debrief::Attempt> others;
    for (const auto& path : options.over)
        others.push_back(read({path}, 0, whole, false));
    for (const auto& other : others)
        page.over.push_back(&other);
    if (options.what_if) {
        try {
            recording::Recording recording(options.paths);
            page.remedies = remedies_of(recording, options.run, options.config, tell);
        } catch (const std::runtime_error& error) {
            tell(fmt::format("what would have kept lost points is not searched for: {}", error.what()));
        }
    }
    write(options.output.empty() ? fs::path("debrief_" + attempt.origin.recording + ".html") : options.output,
          debrief::page_of(attempt, page));
    if (!options.csv.empty()) write(options.csv, debrief::csv_of(attempt));
    if (!options.json.empty()) write(options.json, dumped(debrief::json_of(attempt)));
    if (!options.xapi.empty()) write(options.xapi, dumped(debrief::xapi_of(attempt, options.actor)));
    return whole ? kOk : kDamaged;
}

struct ClassOptions {
    std::vector<fs::path> recordings;
    std::string title = "A class side by side";
    fs::path output = "class.html";
};

int lay_side_by_side(const ClassOptions& options) {
    bool whole = true;
    std::vector<debrief::Attempt> attempts;
    for (const auto& path : options.recordings)
        attempts.push_back(read({path}, 0, whole, false));
    std::vector<debrief::Beside> all;
    for (const auto& attempt : attempts)
        all.push_back({.who = attempt.origin.recording, .attempt = &attempt});
    write(options.output, debrief::side_by_side_page(options.title, all));
    return whole ? kOk : kDamaged;
}

} // namespace

void add_class(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ClassOptions>();
    CLI::App& sub = *app.add_subcommand(
        "class", "recordings of one lesson side by side: marks, criteria, who did what when");
    sub.add_option("recordings", options->recordings, "folders of recordings, one an exercise")
        ->required()
        ->expected(1, 64);
    sub.add_option("--title", options->title, "of the page")->capture_default_str();
    sub.add_option("-o,--output", options->output, "the page; - is stdout")->capture_default_str();
    sub.footer("Of each recording the last run. The page is one file, as a debriefing is.\n"
               "Exit codes: 0 done, 1 failed, 2 bad option, 3 damaged: made of what could be read.");
    sub.callback([&chosen, options] { chosen = [options] { return lay_side_by_side(*options); }; });
}

void add_debrief(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<DebriefOptions>();
    CLI::App& sub =
        *app.add_subcommand("debrief", "a page to talk over: marks, plots, track, orders and reports");
    sub.add_option("recording", options->paths, "folder of a recording, or its MCAP files")->required();
    sub.add_option("-o,--output", options->output, "the page (default: debrief_RECORDING.html); - is stdout");
    sub.add_option(
           "--over", options->over,
           "another recording, an earlier attempt or the model run, laid over the plots; three at most")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    CLI::Option* ghost = sub.add_option(
        "--ghost", options->ghost,
        "another recording of the same lesson, paler behind the curves in place of the model run");
    sub.add_flag("--no-ghost", options->no_ghost, "no model run behind the curves")->excludes(ghost);
    sub.add_option("--run", options->run, "which run of the recording, 1: the first (default: the last)")
        ->check(CLI::Range(1, 1'000'000));
    sub.add_option("--station", options->station,
                   "address that the instructor's station printed: times of the page then open its replay");
    sub.add_flag("--what-if", options->what_if,
                 "says of each lost point what would have kept it: some seconds to a minute or two each");
    sub.add_option("--config", options->config, "folder with the scripts of the lesson's model run")
        ->capture_default_str();
    sub.add_option("--csv", options->csv, "the same as a table, one row a fact");
    sub.add_option("--json", options->json, "the same as one object");
    CLI::Option* trainee =
        sub.add_option("--trainee", options->actor.pseudonym,
                       "pseudonym of the trainee's account, for --xapi; never a mail address");
    sub.add_option("--home-page", options->actor.home_page, "IRI of where that account is")
        ->capture_default_str();
    sub.add_option("--xapi", options->xapi, "statements for a learning record store (xAPI); nothing is sent")
        ->needs(trainee);
    sub.footer("The page is one file, without script and without network; it prints on A4. It tells the "
               "whole truth.\n"
               "Exit codes: 0 done, 1 failed, 2 bad option, 3 damaged: made of what could be read.");
    sub.callback([&chosen, options] {
        if (options->over.size() > 3) throw CLI::ValidationError("--over", "three at most");
        if (options->actor.pseudonym.find('@') != std::string::npos)
            throw CLI::ValidationError("--trainee", "a pseudonym, never a mail address");
        chosen = [options] { return debrief_recording(*options); };
    });
}

} // namespace windlass::recorder
