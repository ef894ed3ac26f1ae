#include "bench/lab/case/run.hpp"
#include "bench/lab/commands.hpp"
#include "bench/lab/draw/chart.hpp"
#include "bench/lab/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace windlass::lab {
namespace {

struct RunOptions {
    std::string case_file, method = "production", out, reference;
    std::vector<std::string> assignments;
    int links = 0;
    double dt = 0;
};

void tell_comparison(const Comparison& c, double low) {
    fmt::print("from {:g} to {:g} s   {:>10} {:>10} {:>10} {:>14}\n", c.from, c.to, "largest", "mean",
               "least", fmt::format("below {:g}", low));
    for (const auto& [name, f] : {std::pair("computed", c.computed), std::pair("measured", c.measured)})
        fmt::print("{:<18} {:>10.4g} {:>10.4g} {:>10.4g} {:>12.1f} %\n", name, f.largest, f.mean, f.min,
                   100 * f.low_share);
    fmt::print("root mean square of the difference: {:.4g}\n", c.rms);
}

void draw_comparison(const Comparison& c, const std::string& title, const std::filesystem::path& file) {
    const auto curve = [&](const char* name, std::size_t column, const char* colour) {
        Curve one{.name = name, .points = {}, .colour = colour};
        for (std::size_t i = 0; i < c.both.rows(); ++i)
            one.points.push_back({c.both.columns[0][i], c.both.columns[column][i]});
        return one;
    };
    Svg svg(1000, 360);
    const std::string heading = c.both.names[1].substr(c.both.names[1].find('_') + 1);
    const std::size_t unit = heading.rfind('_');
    draw(svg,
         {.title = title,
          .x = {"time, s", false, c.from, c.to},
          .y = {heading.substr(0, unit) + ", " + heading.substr(unit + 1), false},
          .curves = {curve("measured", 2, "#888888"), curve("computed", 1, "#d55e00")}},
         {0, 0}, 1000, 360);
    svg.save(file);
}

int run(const RunOptions& options) {
    const Case given = load_case(options.case_file, options.assignments);
    const auto& all = methods();
    const auto method =
        std::find_if(all.begin(), all.end(), [&](const MethodEntry& m) { return m.name == options.method; });
    const int links = options.links > 0 ? options.links : given.links;
    const double dt = options.dt > 0 ? options.dt : given.dt;
    for (const Probe& probe : given.probes)
        if (probe.node.value_or(0) > links)
            throw std::invalid_argument(
                fmt::format("probe {}: node {} is not allowed: 0 to {}, the number of links", probe.name,
                            *probe.node, links));
    // Read before the work begins: a name that is wrong should not cost a run.
    Table measured;
    if (!options.reference.empty()) measured = read_table(options.reference, 2, 2);

    const RunResult result = [&] {
        ProgressBar bar;
        return run_case(given, *method, links, dt, [&](double share) { bar.show(share, options.method); });
    }();
    write_table(options.out, result.series);
    fmt::print("{}: {:.4g} ms of processor time for a simulated second, {:.0f} times faster than real time\n",
               options.method, 1000 * result.seconds / result.simulated, result.simulated / result.seconds);
    if (!result.finite) {
        fmt::print(stderr, "chain_lab: {} blew up at {:g} s; {} ends there\n", options.method, result.stopped,
                   options.out);
        return kBlewUp;
    }
    if (!options.reference.empty()) {
        const Comparison c = compare_with(result.series, given.reference, measured, options.reference);
        tell_comparison(c, given.reference.low);
        draw_comparison(c, fmt::format("{}: {}, {} links, {:g} s", given.title, options.method, links, dt),
                        std::filesystem::path(options.out).replace_extension(".svg"));
    }
    return kDone;
}

} // namespace

void add_run(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<RunOptions>();
    CLI::App* command = app.add_subcommand("run", "computes one case and writes what its probes read as CSV");
    std::vector<std::string> names;
    for (const MethodEntry& method : methods())
        names.push_back(method.name);
    command->add_option("CASE", options->case_file, "case file (JSON; bench/schema/case.schema.json)")
        ->required();
    command->add_option("--method", options->method, "one of chain_lab list")
        ->type_name("NAME")
        ->check(CLI::IsMember(names))
        ->capture_default_str();
    command->add_option("--nodes", options->links, "links; default: what the case says")
        ->type_name("N")
        ->check(CLI::Range(2, 100000));
    command->add_option("--dt", options->dt, "s, step; default: what the case says")
        ->type_name("S")
        ->check(CLI::Range(1e-9, 10.0));
    command->add_option("--out", options->out, "CSV to write")->type_name("FILE")->required();
    command
        ->add_option("--reference", options->reference,
                     "measured series to compare with (CSV: time, value); draws both beside the CSV, as SVG")
        ->type_name("FILE");
    command
        ->add_option("--set", options->assignments,
                     "changes a field of the case, e.g. line.damping_time=0.001 or settings.iterations=20")
        ->type_name("FIELD=VALUE")
        ->allow_extra_args(false);
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace windlass::lab
