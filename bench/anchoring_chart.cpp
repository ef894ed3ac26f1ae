// A whole anchoring computed in many ways: what each costs and how far it is from 1000 links in small steps.
// README.md says how to read it; the model's policy is made from its table.

#include "tests/scenario/whole_anchoring.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <fstream>
#include <iostream>

using namespace windlass::exercise;

namespace {

constexpr double kLinks = 1000; ///< of the reference, when all that is paid out hangs or lies

struct Row {
    std::string name;
    ExerciseDef def;
};

ExerciseDef fixed(ExerciseDef def, double spacing) {
    def.model.adaptive = false;
    def.tackle[0].chain.node_spacing = spacing;
    return def;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Computes a whole anchoring (let go, brought up, lying, weighed) at many link lengths and by the "
        "model's policy; tells cost and difference from the reference as CSV. Exit codes: 0 done, 1 "
        "a run failed, 2 bad option.");
    std::string out;
    double lying = 600;
    int shackles = 6;
    std::vector<double> spacings{0.33, 0.5, 1, 2, 4, 8};
    app.add_option("--out", out, "file for the table; else standard output");
    app.add_option("--lying", lying, "s between brought up and weighing")->capture_default_str();
    app.add_option("--shackles", shackles, "cable paid out")->capture_default_str();
    app.add_option("--spacings", spacings, "m of chain between nodes")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        const ExerciseDef def = let_go_def();
        const Anchoring anchoring = work_anchoring(def, shackles, lying);
        const AnchoringRun reference =
            run_anchoring(fixed(def, shackles * windlass::physics::kShackleLength / kLinks), anchoring);
        std::ofstream file;
        if (!out.empty()) file.open(out);
        std::ostream& table = out.empty() ? std::cout : file;
        fmt::print(table, "model,cost_ms_per_s,cost_ratio,load_rms,shape_rms_m,load_let_go,load_brought_up,"
                          "load_lying,load_weighing,shape_let_go,shape_lying,shape_weighing\n");
        std::vector<Row> rows{
            {"reference", fixed(def, shackles * windlass::physics::kShackleLength / kLinks)},
            {"policy", def}};
        for (const double spacing : spacings)
            rows.push_back({fmt::format("{} m", spacing), fixed(def, spacing)});
        const double seconds = static_cast<double>(anchoring.end) / def.tick_rate_hz;
        for (const Row& row : rows) {
            const AnchoringRun run = row.name == "reference" ? reference : run_anchoring(row.def, anchoring);
            const auto part = [&](std::uint64_t from, std::uint64_t to) {
                return difference(run, reference, from, to, def.tick_rate_hz);
            };
            const auto whole = part(0, anchoring.end), let_go = part(0, anchoring.orders[1].tick),
                       coming = part(anchoring.orders[1].tick, anchoring.brought_up),
                       lies = part(anchoring.brought_up, anchoring.weigh),
                       weighing = part(anchoring.weigh, anchoring.end);
            fmt::print(
                table, "{},{:.4f},{:.1f},{:.5f},{:.3f},{:.5f},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.3f}\n",
                row.name, 1e3 * run.cost / seconds, reference.cost / run.cost, whole.load, whole.shape,
                let_go.load, coming.load, lies.load, weighing.load, let_go.shape, lies.shape, weighing.shape);
            table.flush();
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "anchoring_chart: {}\n", error.what());
        return 1;
    }
    return 0;
}
