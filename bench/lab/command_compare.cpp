#include "bench/lab/commands.hpp"
#include "bench/lab/compare_charts.hpp"
#include "bench/lab/progress_bar.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace windlass::lab {
namespace {

void tell(const Suite& suite, const std::vector<SuiteRow>& rows) {
    for (const double limit : {0.01, 0.001}) {
        fmt::print("least cost within {:g} %: links, method, steps in a second, ms for a simulated second\n",
                   100 * limit);
        for (const CheapestRun& run : cheapest_runs(suite, rows, limit))
            fmt::print("{:6} {:<14} {:6} {:9.3g}\n", run.nodes, run.method, run.rate, run.cost);
    }
}

void compare(const std::string& suite_file, const std::filesystem::path& folder) {
    const Suite suite = load_suite(suite_file);
    std::filesystem::create_directories(folder);
    const std::vector<SuiteRow> rows = [&] {
        ProgressBar bar;
        return run_suite(
            suite, [&](double share, const std::string& what) { bar.show(share, what); },
            [&](const std::vector<SuiteRow>& some) { write_rows(folder / "work_precision.csv", some); });
    }();
    for (const SuiteCase& one : suite.cases)
        draw_work_precision(suite, one, rows, folder / ("work_precision_" + one.name + ".svg"));
    draw_cost(suite, rows, folder / "cost_nodes.svg");
    tell(suite, rows);
}

} // namespace

void add_compare(CLI::App& app) {
    struct Options {
        std::string suite, out;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("compare", "runs every method over a suite of cases and draws error against cost");
    command->add_option("SUITE", options->suite, "suite file (JSON; bench/schema/suite.schema.json)")
        ->required();
    command->add_option("--out", options->out, "folder for the data and charts; made when it is not there")
        ->type_name("DIR")
        ->required();
    command->callback([options] { compare(options->suite, options->out); });
}

} // namespace windlass::lab
