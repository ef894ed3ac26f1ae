#include "bench/lab/commands.hpp"
#include "bench/lab/convergence/converge.hpp"
#include "bench/lab/progress_bar.hpp"

#include <fmt/format.h>

#include <memory>

namespace windlass::lab {
namespace {

struct Options {
    std::vector<std::string> cases;
    std::string out, note;
    bool draw_only = false;
    int particles = 1000, sweeps = 100000;
    std::vector<double> dt{1.0 / 60, 1.0 / 600};
    double at = 3, scatter = 0.05;
};

/// The last error not beyond so many iterations, for the table.
const ConvergePoint* after(const ConvergeCurve& curve, int iterations) {
    const ConvergePoint* last = nullptr;
    for (const ConvergePoint& point : curve.points)
        if (point.iterations <= iterations) last = &point;
    return last && last->iterations == iterations ? last : nullptr;
}

void tell(const std::vector<ConvergeCurve>& curves) {
    fmt::print("relative error after 1, 2, 3, 5 and 10 iterations, ms for 10; how far x* is from Newton's\n");
    for (const ConvergeCurve& curve : curves) {
        fmt::print("{:<48} {:<22}", curve.problem, curve.method);
        for (const int n : {1, 2, 3, 5, 10})
            fmt::print(" {:>9.2e}", after(curve, n)->error);
        fmt::print(" {:>8.3f} {:>9.2e}\n", 1e3 * after(curve, 10)->seconds, curve.limit_distance);
    }
}

void run(const Options& options) {
    const std::filesystem::path file = std::filesystem::path(options.out) / "converge.csv";
    if (options.draw_only) {
        const std::vector<ConvergeCurve> curves = read_converge(file);
        draw_converge(std::filesystem::path(file).replace_extension(".svg"), curves);
        return tell(curves);
    }
    std::vector<StepProblem> problems;
    for (const std::string& file : options.cases)
        for (const double dt : options.dt) {
            problems.push_back(step_problem(load_case(file), options.particles, options.at, dt));
            problems.back().title += fmt::format(", step 1/{:.4g} s", 1 / dt);
        }
    if (options.scatter > 0) {
        problems.push_back(scattered(problems.front(), options.scatter));
        problems.back().title = fmt::format("Scattered by {:g} % of a link", 100 * options.scatter);
    }
    std::filesystem::create_directories(options.out);
    std::vector<ConvergeCurve> curves;
    {
        ProgressBar bar;
        for (std::size_t k = 0; k < problems.size(); ++k) {
            const auto some =
                converge(problems[k], MethodSettings{}.k_stretch, options.sweeps, [&](double share) {
                    bar.show((static_cast<double>(k) + share) / static_cast<double>(problems.size()),
                             problems[k].title);
                });
            curves.insert(curves.end(), some.begin(), some.end());
        }
    }
    write_converge(file, curves, notes_after(file, true, options.note));
    draw_converge(std::filesystem::path(file).replace_extension(".svg"), curves);
    tell(curves);
}

} // namespace

void add_converge(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "converge", "draws the error of PBD's sweeps and of Newton's method within one step of a case");
    command->add_option("CASE", options->cases, "case files; each is run up to --at by production")
        ->required();
    command->add_option("--out", options->out, "folder for converge.csv and converge.svg")
        ->type_name("DIR")
        ->required();
    command->add_option("--particles", options->particles, "particles of the line")
        ->type_name("N")
        ->check(CLI::Range(3, 100000))
        ->capture_default_str();
    command->add_option("--sweeps", options->sweeps, "most sweeps of PBD")
        ->type_name("N")
        ->check(CLI::Range(10, 100000000))
        ->capture_default_str();
    command->add_option("--at", options->at, "s, when the step begins")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--dt", options->dt, "s, steps; each makes a problem of each case")
        ->type_name("S")
        ->check(CLI::Range(1e-6, 1.0))
        ->capture_default_str();
    command
        ->add_option("--scatter", options->scatter,
                     "a further problem: the first case scattered by this share of a link; 0: none")
        ->type_name("SHARE")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    add_note(*command, options->note);
    command->add_flag("--draw-only", options->draw_only, "no runs: draws what DIR has");
    command->callback([options] { run(*options); });
}

} // namespace windlass::lab
