// recorder blind: sheets by which masters mark recordings without seeing our marks, and how far they agree
// with us.

#include "recorder/command.hpp"

#include "recorder/blind/answers.hpp"
#include "recorder/blind/sheet.hpp"
#include "recorder/resimulate/resimulation.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <system_error>

namespace windlass::recorder {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct SheetsOptions {
    std::vector<fs::path> recordings;
    fs::path output, key;
    std::uint64_t seed = 0;
};

struct AgreeOptions {
    fs::path key, json;
    std::vector<fs::path> forms;
};

void write_blind(const fs::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!(file << text) || !file.flush())
        throw std::runtime_error(path.string() + ": cannot write: " + std::generic_category().message(errno));
}

/// In an order that only the seed knows; the same on every machine.
template <class T>
void shuffle_by(std::uint64_t seed, std::vector<T>& things) {
    std::mt19937_64 chance(seed);
    for (std::size_t left = things.size(); left > 1; --left)
        std::swap(things[left - 1], things[chance() % left]);
}

int make_sheets(SheetsOptions options) {
    if (fs::exists(options.output) && !fs::is_empty(options.output))
        throw std::runtime_error(options.output.string() +
                                 " is not empty: forms that are filled in may lie there");
    if (options.key.empty()) options.key = (options.output / "").parent_path().string() + "_key.json";
    if (fs::exists(options.key)) throw std::runtime_error(options.key.string() + " is there already");
    shuffle_by(options.seed, options.recordings);
    ordered_json key{
        {"format", blind::kKeyFormat}, {"seed", options.seed}, {"sheets", ordered_json::object()}};
    fs::create_directories(options.output);
    for (std::size_t i = 0; i < options.recordings.size(); ++i) {
        const auto sheet = blind::read_sheet(options.recordings[i]);
        const std::string code = fmt::format("S{:02}", i + 1);
        write_blind(options.output / (code + ".html"), blind::page_of(sheet, code));
        write_blind(options.output / (code + ".csv"), blind::form_of(sheet, code));
        ordered_json marks = ordered_json::object();
        for (const blind::Question& question : sheet.questions)
            marks[question.item] = question.ours ? ordered_json(*question.ours) : ordered_json();
        key["sheets"][code] = {
            {"recording", options.recordings[i].string()},
            {"sha256", sheet.attempt.origin.sha256},
            {"run", sheet.attempt.origin.run},
            {"lesson", sheet.lesson.id},
            {"assessment_hash", fmt::format("{:016x}", sheet.attempt.assessment->assessment_hash())},
            {"points", 0.1 * sheet.computed.tenths_computed},
            {"outcome", assess::outcome_name(sheet.computed.outcome)},
            {"marks", std::move(marks)}};
    }
    write_blind(options.key, key.dump(2) + "\n");
    tell(fmt::format("wrote {} sheets to {}; their key, which nobody who marks may see, is {}",
                     options.recordings.size(), options.output.string(), options.key.string()));
    return kOk;
}

/// A row of what is told: whose marks of what stand beside each other.
struct Told {
    std::string item, who;
    blind::Agreement found;
};

/// Of one item: each rater beside us, their mean, each pair of raters, their mean.
void compare(const blind::Rater& ours, const std::vector<blind::Rater>& raters, const std::string& item,
             std::vector<Told>& rows) {
    const std::string name = item.empty() ? "all criteria" : item;
    const auto add = [&](const std::string& mean,
                         const std::vector<std::pair<std::string, blind::Beside>>& couples) {
        std::vector<blind::Beside> all;
        for (const auto& [who, couple] : couples) {
            rows.push_back({name, who, blind::agreement({couple})});
            all.push_back(couple);
        }
        if (all.size() > 1) rows.push_back({name, mean, blind::agreement(all)});
    };
    std::vector<std::pair<std::string, blind::Beside>> with_us, among;
    for (std::size_t i = 0; i < raters.size(); ++i) {
        with_us.emplace_back(fmt::format("{} - {}", ours.name, raters[i].name),
                             blind::beside(ours, raters[i], item));
        for (std::size_t k = i + 1; k < raters.size(); ++k)
            among.emplace_back(fmt::format("{} - {}", raters[i].name, raters[k].name),
                               blind::beside(raters[i], raters[k], item));
    }
    add("ours - each, mean", with_us);
    add("each - each, mean", among);
}

ordered_json json_of(const std::vector<Told>& rows) {
    ordered_json all = ordered_json::array();
    for (const Told& row : rows) {
        const blind::Agreement& found = row.found;
        ordered_json one{{"item", row.item},     {"who", row.who},      {"recordings", found.recordings},
                         {"pairs", found.pairs}, {"same", found.same},  {"difference", found.difference},
                         {"kappa", nullptr},     {"interval", nullptr}, {"undetermined", found.undetermined}};
        if (found.kappa) one["kappa"] = *found.kappa;
        if (found.interval) one["interval"] = *found.interval;
        all.push_back(std::move(one));
    }
    return {{"kappa", "Cohen's, quadratic weights"},
            {"interval", "95 %, jackknife over recordings, Fisher's z, Student's t"},
            {"rows", std::move(all)}};
}

int agree(const AgreeOptions& options) {
    const blind::Key key = blind::read_key(options.key);
    const blind::Rater ours = blind::ours_of(key);
    const auto raters = blind::read_forms(options.forms, key);
    std::set<std::string> items;
    for (const auto& [sheet, marks] : key)
        for (const auto& [item, mark] : marks)
            if (item != blind::kOverall) items.insert(item);
    std::vector<Told> rows;
    for (const std::string& item : items)
        compare(ours, raters, item, rows);
    compare(ours, raters, "", rows);
    compare(ours, raters, blind::kOverall, rows);
    std::cout << fmt::format("{:<24} {:<24} {:>4} {:>5} {:>7} {:>6}  kappa, quadratic weights (95 %)\n",
                             "item", "who", "n", "pairs", "same", "diff");
    for (const Told& row : rows) {
        const blind::Agreement& found = row.found;
        std::string kappa = found.kappa ? fmt::format("{:.2f}", *found.kappa) : "undetermined";
        if (found.interval)
            kappa += fmt::format(" ({:.2f} to {:.2f})", (*found.interval)[0], (*found.interval)[1]);
        if (!found.undetermined.empty()) kappa += "; " + found.undetermined;
        std::cout << fmt::format("{:<24} {:<24} {:>4} {:>5} {:>5.0f} % {:>+6.2f}  {}\n", row.item, row.who,
                                 found.recordings, found.pairs, 100 * found.same, found.difference, kappa);
    }
    std::cout << "n: recordings; diff: mean of the first less the second, in steps of the scale; "
                 "docs/validity.md\n";
    if (!options.json.empty()) write_blind(options.json, json_of(rows).dump(2) + "\n");
    return kOk;
}

} // namespace

void add_blind(CLI::App& app, Command& chosen) {
    CLI::App& sub =
        *app.add_subcommand("blind", "is the mark right? masters mark recordings without seeing ours");
    sub.require_subcommand(1);
    sub.footer("docs/validity.md says how such a study is made, and what its figures mean.");

    auto sheets = std::make_shared<SheetsOptions>();
    CLI::App& make =
        *sub.add_subcommand("sheets", "a sheet of each recording, as a page and a form to be filled in");
    make.add_option("recording", sheets->recordings,
                    "folders of recordings; of each the last attempt at a lesson")
        ->required();
    make.add_option("-o,--output", sheets->output, "folder of the sheets, new or empty")->required();
    make.add_option("--seed", sheets->seed, "of the order of the sheets; tell it to nobody who marks")
        ->required();
    make.add_option("--key", sheets->key,
                    "what ties sheets to recordings and to our marks (default: FOLDER_key.json)");
    make.callback([&chosen, sheets] {
        chosen = [sheets] {
            try {
                return make_sheets(*sheets);
            } catch (const Gap& gap) {
                tell(gap.what());
                return static_cast<int>(kDamaged);
            }
        };
    });

    auto agreement = std::make_shared<AgreeOptions>();
    CLI::App& take =
        *sub.add_subcommand("agree", "takes the forms in again: how far raters agree with us, and they "
                                     "with each other");
    take.add_option("key", agreement->key, "as sheets has written it")->required();
    take.add_option("form", agreement->forms, "forms that are filled in, of one rater or of several")
        ->required();
    take.add_option("--json", agreement->json, "the same as one object");
    take.callback([&chosen, agreement] { chosen = [agreement] { return agree(*agreement); }; });
}

} // namespace windlass::recorder
