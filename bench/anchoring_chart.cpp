// A whole anchoring computed in many ways: what each costs and how far it is from 1000 links in small steps.
// README.md says how to read it; the model's policy is made from its table.

#include "bench/program.hpp"
#include "bench/table_file.hpp"
#include "rigs/whole_anchoring.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

using namespace windlass;
using namespace windlass::bench;

namespace {

constexpr double kLinks = 1000; ///< of the reference, in all the cable that is paid out
constexpr int kFine = 4;        ///< steps of the reference in one of the exercise

struct Row {
    std::string name;
    exercise::ExerciseDef def;
};

exercise::ExerciseDef fixed(exercise::ExerciseDef def, double spacing) {
    def.model.adaptive = false;
    def.tackle[0].chain.node_spacing = spacing;
    return def;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Computes a whole anchoring (let go, brought up, lying, weighed) at many link lengths and by the "
        "model's policy; tells cost and difference from the reference as CSV. Exit codes: 0 done, 1 "
        "a run failed, 2 bad option.",
        "anchoring_chart");
    windlass::bench::TableOptions options;
    double lying = 600;
    int shackles = 6;
    std::vector<double> spacings{0.33, 0.84, 1.25, 2, 4, 8};
    windlass::bench::add_table_options(app, options);
    app.add_option("--lying", lying, "s between brought up and weighing")->capture_default_str();
    app.add_option("--shackles", shackles, "cable paid out")->capture_default_str();
    app.add_option("--spacings", spacings, "m of chain between nodes")->capture_default_str();
    return run_program(app, argc, argv, [&] {
        const exercise::ExerciseDef def = rigs::let_go_def();
        const rigs::Anchoring anchoring = rigs::work_anchoring(def, shackles, lying);
        const double finest = shackles * windlass::physics::kShackleLength / kLinks;
        const exercise::ExerciseDef thousand = fixed(def, finest);
        exercise::ExerciseDef deeper = thousand;
        deeper.environment.depth += 1e-3;
        const rigs::AnchoringRun reference =
            rigs::run_anchoring(rigs::at_rate(thousand, kFine), rigs::at_rate(anchoring, kFine));
        const rigs::AnchoringRun plain = rigs::run_anchoring(thousand, anchoring);

        windlass::bench::TableFile file(options);
        std::ostream& table = file.stream();
        fmt::print(table, "model,cost_ms_per_s,reference_costs,thousand_links_cost,load,shape_m,load_let_go,"
                          "load_coming_up,load_lying,load_weighing,shape_lying_m\n");
        std::vector<Row> rows{{"1000 links in a millimetre more water", deeper}, {"policy", def}};
        for (const double spacing : spacings)
            rows.push_back({fmt::format("links of {} m", spacing), fixed(def, spacing)});
        const double seconds = static_cast<double>(anchoring.end) / def.tick_rate_hz;
        const auto print = [&](const std::string& name, const rigs::AnchoringRun& run) {
            const auto part = [&](std::uint64_t from, std::uint64_t to) {
                return rigs::difference(run, reference, from, to, def.tick_rate_hz);
            };
            const std::uint64_t checked = anchoring.orders[1].tick;
            const auto whole = part(0, anchoring.end), lies = part(anchoring.brought_up, anchoring.weigh);
            fmt::print(table, "{},{:.3f},{:.1f},{:.1f},{:.4f},{:.3f},{:.4f},{:.4f},{:.4f},{:.4f},{:.3f}\n",
                       name, 1e3 * run.cost / seconds, reference.cost / run.cost, plain.cost / run.cost,
                       whole.load, whole.shape, part(0, checked).load,
                       part(checked, anchoring.brought_up).load, lies.load,
                       part(anchoring.weigh, anchoring.end).load, lies.shape);
            table.flush();
        };
        print(fmt::format("reference: 1000 links, {} steps a second", kFine * def.tick_rate_hz), reference);
        print("1000 links", plain);
        for (const Row& row : rows)
            print(row.name, rigs::run_anchoring(row.def, anchoring));
    });
}
