#include "bench/lab/accuracy/compare_charts.hpp"
#include "bench/lab/commands.hpp"
#include "bench/lab/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

namespace windlass::lab {
namespace {

struct Options {
    std::string suite, out, note;
    Selection selection;
    bool draw_only = false;
};

const CheapestRun* find(const std::vector<CheapestRun>& runs, const std::string& method, int nodes) {
    const auto at = std::find_if(runs.begin(), runs.end(), [&](const CheapestRun& run) {
        return run.method == method && run.nodes == nodes;
    });
    return at == runs.end() ? nullptr : &*at;
}

/// A table for each bar and limit: methods down, links across, and how production stands to leapfrog.
void tell(const Suite& suite, const std::vector<SuiteRow>& rows) {
    for (const std::string& bar : suite.bars())
        for (const double limit : kLimits) {
            const std::vector<CheapestRun> runs = cheapest_runs(suite, rows, bar, limit);
            std::set<int> nodes;
            for (const SuiteCase& one : suite.cases)
                if (one.bar == bar) nodes.insert(one.nodes.begin(), one.nodes.end());
            fmt::print("{}: ms for a simulated second (at steps in a second) within {:g} % in {}\n{:<18}",
                       bar, 100 * limit, cases_of(suite, bar), "links");
            for (const int n : nodes)
                fmt::print(" {:>17}", n);
            for (const MethodEntry* method : suite.methods) {
                fmt::print("\n{:<18}", method->name);
                for (const int n : nodes) {
                    const CheapestRun* run = find(runs, method->name, n);
                    fmt::print(" {:>17}", run ? fmt::format("{:.3g} ({})", run->cost, run->rate) : "-");
                }
            }
            fmt::print("\n{:<18}", "leapfrog = 1");
            for (const int n : nodes) {
                const CheapestRun *ours = find(runs, "production", n), *theirs = find(runs, "leapfrog", n);
                fmt::print(" {:>17}",
                           ours && theirs ? fmt::format("{:.2f}", ours->cost / theirs->cost) : "-");
            }
            fmt::print("\n\n");
        }
}

/// What was chosen must be there. Throws CLI::ValidationError.
template <typename T>
void check_choice(const char* option, const std::vector<T>& chosen, const std::vector<T>& allowed) {
    for (const T& one : chosen)
        if (std::find(allowed.begin(), allowed.end(), one) == allowed.end())
            throw CLI::ValidationError(option, fmt::format("{} is not in the suite", one));
}

void check(const Suite& suite, const Selection& selection) {
    std::vector<std::string> names, cases;
    std::vector<int> nodes;
    for (const MethodEntry* method : suite.methods)
        names.push_back(method->name);
    for (const SuiteCase& one : suite.cases) {
        cases.push_back(one.name);
        nodes.insert(nodes.end(), one.nodes.begin(), one.nodes.end());
    }
    check_choice("--methods", selection.methods, names);
    check_choice("--cases", selection.cases, cases);
    check_choice("--nodes", selection.nodes, nodes);
}

void compare(const Options& options) {
    const Suite suite = load_suite(options.suite);
    const Selection& selection = options.selection;
    check(suite, selection);
    const std::filesystem::path folder = options.out;
    std::filesystem::create_directories(folder);
    std::vector<SuiteRow> rows;
    for (const SuiteCase& one : suite.cases) {
        const std::vector<SuiteRow> some = read_rows(rows_file(folder, one.name), one.name);
        rows.insert(rows.end(), some.begin(), some.end());
    }
    if (!options.draw_only) {
        const bool anew = selection.methods.empty() && selection.nodes.empty() && !selection.missing;
        std::map<std::string, Notes> notes;
        for (const SuiteCase& one : suite.cases)
            if (selection.cases.empty() || std::ranges::count(selection.cases, one.name) > 0)
                notes[one.name] = notes_after(rows_file(folder, one.name), anew, options.note);
        ProgressBar bar;
        run_suite(
            suite, selection, rows, [&](double share, const std::string& what) { bar.show(share, what); },
            [&] {
                for (const auto& [name, told] : notes)
                    write_rows(rows_file(folder, name), suite, name, rows, told);
            });
    }
    for (const SuiteCase& one : suite.cases)
        draw_work_precision(suite, one, rows, rows_file(folder, one.name).replace_extension(".svg"));
    draw_cost(suite, rows, folder / "cost_nodes.svg");
    tell(suite, rows);
}

} // namespace

void add_compare(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("compare", "runs every method over a suite of cases and draws error against cost");
    command->add_option("SUITE", options->suite, "suite file (JSON; bench/schema/suite.schema.json)")
        ->required();
    command->add_option("--out", options->out, "folder for the data and charts; made when it is not there")
        ->type_name("DIR")
        ->required();
    command->add_option("--methods", options->selection.methods, "only these; what DIR has of others stays")
        ->type_name("A,B")
        ->delimiter(',');
    command->add_option("--cases", options->selection.cases, "only these, by their names in the suite")
        ->type_name("A,B")
        ->delimiter(',');
    command->add_option("--nodes", options->selection.nodes, "only these numbers of links")
        ->type_name("N,M")
        ->delimiter(',');
    command->add_flag("--resume", options->selection.missing, "only runs that DIR does not have yet");
    add_note(*command, options->note);
    command->add_flag("--draw-only", options->draw_only, "no runs: draws what DIR has");
    command->callback([options] { compare(*options); });
}

} // namespace windlass::lab
