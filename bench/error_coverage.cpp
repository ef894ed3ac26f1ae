// Whether the error that the model publishes covers the one that it makes: whole anchorings by the policy
// against links of a quarter of the length and steps of half. README.md says how to read it.

#include "rigs/error_coverage.hpp"
#include "bench/anchorings.hpp"
#include "bench/program.hpp"
#include "bench/table_file.hpp"
#include "bench/work_in_order.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace windlass;
using namespace windlass::bench;

namespace {

constexpr double kFiner = 4;   ///< links of the reference in one of the policy's
constexpr int kFine = 2;       ///< steps of it in one of the policy's
constexpr double kLuck = 1e-3; ///< m more of water, which should make no difference

exercise::ExerciseDef finer(const exercise::ExerciseDef& def) {
    exercise::ExerciseDef fine = def;
    fine.tackle[0].chain.node_spacing = exercise::modelled_chain(def, def.tackle[0]).node_spacing / kFiner;
    fine.model.adaptive = false;
    return rigs::at_rate(fine, kFine);
}

/// What one anchoring shows.
struct Found {
    std::vector<rigs::MomentError> errors{};
    windlass::physics::ModelError whole{};
    double cost_ms_per_s = 0; ///< of the policy, processor time for a simulated second
    /// Over the whole, of the reference from itself in a millimetre more water; empty where not looked at.
    std::optional<windlass::physics::ModelError> luck{};
};

void print_row(std::ostream& table, const std::string& name, const Found& found) {
    const rigs::ErrorCoverage c = rigs::coverage(found.errors);
    fmt::print(table, "\"{}\",{:.4f}", name, c.estimated);
    for (const rigs::Coverage& part : {c.load, c.shape})
        fmt::print(table, ",{:.4f},{:.4f},{:.1f},{:.4f},{:.4f}", part.within, part.within_three, part.worst,
                   part.error, part.estimate);
    fmt::print(table, ",{:.4f},{:.3f},{:.3f}", found.whole.load, found.whole.shape, found.cost_ms_per_s);
    if (found.luck) fmt::print(table, ",{:.4f},{:.3f}", found.luck->load, found.luck->shape);
    fmt::print(table, "\n");
    table.flush();
}

/// What there is to learn from, of each moment.
void write_moments(const std::filesystem::path& file, const rigs::Anchoring& anchoring,
                   const exercise::ExerciseDef& def, const rigs::AnchoringRun& run,
                   const rigs::AnchoringRun& reference) {
    std::ofstream to(file);
    if (!to) throw std::runtime_error(file.string() + ": cannot be written");
    fmt::print(to, "# brought_up {} weigh {} end {} hz {} depth {} spacing {}\n", anchoring.brought_up,
               anchoring.weigh, anchoring.end, def.tick_rate_hz, def.environment.depth,
               exercise::modelled_chain(def, def.tackle[0]).node_spacing);
    fmt::print(to, "time,gauge,load,reference,cable_out,level,estimate_load,estimate_shape,shape,top_z,top_x,"
                   "top_y,dir_z,anchor_x,anchor_y,reference_anchor_x,reference_anchor_y,reference_cable_out,"
                   "reference_top_x,reference_top_y\n");
    const std::size_t count = std::min(run.moments.size(), reference.moments.size());
    for (std::size_t k = 0; k < count; ++k) {
        const rigs::Moment &a = run.moments[k], &b = reference.moments[k];
        const auto &first = a.nodes.front(), &last = a.nodes.back(), &second = a.nodes[1],
                   &before_last = a.nodes[a.nodes.size() - 2];
        const bool top_first = first.z() > last.z();
        const auto top = top_first ? first : last, below = top_first ? second : before_last,
                   foot = top_first ? last : first;
        const auto rf = top_first ? b.nodes.back() : b.nodes.front(),
                   rt = top_first ? b.nodes.front() : b.nodes.back();
        const windlass::physics::Vec3 lead = (below - top).normalized();
        fmt::print(
            to,
            "{:.1f},{:.0f},{:.0f},{:.0f},{:.3f},{},{:.5f},{:.4f},{:.4f},{:.2f},{:.3f},{:.3f},{:.4f},{:.3f},"
            "{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n",
            a.time, a.gauge, a.load, b.load, a.cable_out, static_cast<int>(a.level), a.error.load,
            a.error.shape, rigs::shape_distance(a, b), top.z(), top.x(), top.y(), lead.z(), foot.x(),
            foot.y(), rf.x(), rf.y(), b.cable_out, rt.x(), rt.y());
    }
}

/// Works one of the anchorings twice, for luck three times. Its moments go to a file of that folder, if there
/// is one.
Found look_at(std::uint64_t seed, std::size_t number, double lying, bool luck,
              const std::filesystem::path& moments) {
    const DrawnAnchoring c = drawn_anchoring(seed, number);
    const exercise::ExerciseDef def = definition(c);
    const rigs::Anchoring anchoring = rigs::work_anchoring(def, c.shackles, lying, false);
    const rigs::AnchoringRun run = rigs::run_anchoring(def, anchoring);
    exercise::ExerciseDef fine = finer(def);
    const rigs::AnchoringRun reference = rigs::run_anchoring(fine, rigs::at_rate(anchoring, kFine));
    if (!moments.empty())
        write_moments(moments / fmt::format("{}.csv", number), anchoring, def, run, reference);
    const auto whole = [&](const rigs::AnchoringRun& other) {
        return rigs::difference(other, reference, 0, anchoring.end, def.tick_rate_hz);
    };
    Found found{.errors = rigs::moment_errors(run, reference),
                .whole = whole(run),
                .cost_ms_per_s = 1e3 * run.cost * def.tick_rate_hz / static_cast<double>(anchoring.end)};
    if (luck) {
        fine.environment.depth += kLuck;
        found.luck = whole(rigs::run_anchoring(fine, rigs::at_rate(anchoring, kFine)));
    }
    return found;
}

/// All together: every moment counts alike, every anchoring's whole (root mean square) and cost (mean) alike.
Found together(const std::vector<Found>& founds) {
    using windlass::physics::ModelError;
    const auto count = static_cast<double>(founds.size());
    const auto mean_square = [&](const auto& error_of) {
        ModelError sum;
        for (const Found& found : founds) {
            const ModelError& error = error_of(found);
            sum.load += error.load * error.load, sum.shape += error.shape * error.shape;
        }
        return ModelError{std::sqrt(sum.load / count), std::sqrt(sum.shape / count)};
    };
    Found all{.whole = mean_square([](const Found& found) { return found.whole; })};
    if (founds.front().luck) all.luck = mean_square([](const Found& found) { return *found.luck; });
    for (const Found& found : founds) {
        all.errors.insert(all.errors.end(), found.errors.begin(), found.errors.end());
        all.cost_ms_per_s += found.cost_ms_per_s / count;
    }
    return all;
}

/// Whether the load errs more where more steps have friction of the step's start: a line for each share.
void print_by_friction(std::ostream& table, const std::vector<Found>& founds) {
    double above = -1;
    for (const double most : {0.0, 0.05, 0.1, 0.2, 0.3, 1.0}) {
        std::vector<rigs::MomentError> moments;
        for (const Found& found : founds)
            std::ranges::copy_if(
                found.errors, std::back_inserter(moments),
                [&](double share) { return share > above && share <= most; }, &rigs::MomentError::friction);
        above = most;
        if (moments.empty()) continue;
        const rigs::Coverage load = rigs::coverage(moments).load;
        fmt::print(table,
                   "# {} moments with friction of the step's start in at most {} of their steps: load within "
                   "{:.4f}, within three times {:.4f}, error {:.4f}, estimate {:.4f}\n",
                   moments.size(), most, load.within, load.within_three, load.error, load.estimate);
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Holds the error that the model publishes against the one that it makes, over whole "
                 "anchorings; tells the share of moments that are covered as CSV. Exit codes: 0 done, 1 a "
                 "run failed, 2 bad option.",
                 "error_coverage");
    windlass::bench::TableOptions options;
    std::string moments;
    double lying = 240;
    bool luck = false;
    std::uint64_t seed = 1;
    std::size_t first = 0, last = 40, threads = std::thread::hardware_concurrency();
    windlass::bench::add_table_options(app, options);
    app.add_option("--moments", moments, "folder for a file of every moment of each run");
    app.add_option("--lying", lying, "s between brought up and weighing")->capture_default_str();
    app.add_option("--seed", seed, "of the draw")->capture_default_str();
    app.add_option("--first", first, "number of the first anchoring")->capture_default_str();
    app.add_option("--last", last, "and of the one after the last")->capture_default_str();
    app.add_flag("--luck", luck, "what a millimetre more of water makes of the finer links, too");
    app.add_option("--threads", threads, "anchorings worked at a time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    return run_program(app, argc, argv, [&] {
        windlass::bench::TableFile file(options);
        std::ostream& table = file.stream();
        fmt::print(table, "anchoring,estimated");
        for (const char* of : {"load", "shape"})
            fmt::print(table, ",{0}_within,{0}_within_three,{0}_worst,{0}_error,{0}_estimate", of);
        fmt::print(table, ",whole_load,whole_shape,cost_ms_per_s{}\n", luck ? ",luck_load,luck_shape" : "");
        std::vector<Found> founds;
        std::size_t within_budget = 0;
        const auto work = [&](std::size_t k) { return look_at(seed, k, lying, luck, moments); };
        work_in_order(first, last, threads, work, [&](std::size_t k, std::future<Found>& look) {
            const std::string name = title(drawn_anchoring(seed, k));
            try {
                founds.push_back(look.get());
            } catch (const std::runtime_error& why) { // her cable parts, say, or she drags for good
                fmt::print(table, "# {}: {}\n", name, why.what());
                return;
            }
            const windlass::physics::ModelError& whole = founds.back().whole;
            const windlass::physics::ModelError& budget = exercise::kModelBudget;
            within_budget += whole.load <= budget.load && whole.shape <= budget.shape ? 1 : 0;
            print_row(table, name, founds.back());
        });
        if (!founds.empty()) print_row(table, "all", together(founds));
        print_by_friction(table, founds);
        fmt::print(table, "# within the budget of load and shape: {} of {}\n", within_budget, founds.size());
    });
}
