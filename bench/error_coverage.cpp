// Whether the error that the model publishes covers the one that it makes: whole anchorings by the policy
// against links of a quarter of the length and steps of half. README.md says how to read it.

#include "rigs/error_coverage.hpp"
#include "bench/anchorings.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

using namespace windlass::exercise;

namespace {

constexpr double kFiner = 4; ///< links of the reference in one of the policy's
constexpr int kFine = 2;     ///< steps of it in one of the policy's

ExerciseDef finer(const ExerciseDef& def) {
    ExerciseDef fine = def;
    fine.tackle[0].chain.node_spacing = modelled_chain(def, def.tackle[0]).node_spacing / kFiner;
    fine.model.adaptive = false;
    return at_rate(fine, kFine);
}

void print_row(std::ostream& table, const std::string& name, bool tuned, const ErrorCoverage& c,
               const windlass::physics::ModelError& whole) {
    fmt::print(table, "\"{}\",{}", name, tuned ? "tuned on" : "held out");
    for (const Coverage& part : {c.load, c.shape})
        fmt::print(table, ",{:.4f},{:.4f},{:.1f},{:.4f},{:.4f}", part.within, part.within_three, part.worst,
                   part.error, part.estimate);
    fmt::print(table, ",{:.4f},{:.3f}\n", whole.load, whole.shape);
    table.flush();
}

/// What there is to learn from, of each moment.
void write_moments(const std::filesystem::path& file, const Anchoring& anchoring, const ExerciseDef& def,
                   const AnchoringRun& run, const AnchoringRun& reference) {
    std::ofstream to(file);
    if (!to) throw std::runtime_error(file.string() + ": cannot be written");
    fmt::print(to, "# brought_up {} weigh {} end {} hz {} depth {} spacing {}\n", anchoring.brought_up,
               anchoring.weigh, anchoring.end, def.tick_rate_hz, def.environment.depth,
               modelled_chain(def, def.tackle[0]).node_spacing);
    fmt::print(to, "time,gauge,load,reference,cable_out,level,estimate_load,estimate_shape,shape,top_z,top_x,"
                   "top_y,dir_z,anchor_x,anchor_y,reference_anchor_x,reference_anchor_y,reference_cable_out,"
                   "reference_top_x,reference_top_y\n");
    const std::size_t count = std::min(run.moments.size(), reference.moments.size());
    for (std::size_t k = 0; k < count; ++k) {
        const Moment &a = run.moments[k], &b = reference.moments[k];
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
            a.error.shape, shape_distance(a, b), top.z(), top.x(), top.y(), lead.z(), foot.x(), foot.y(),
            rf.x(), rf.y(), b.cable_out, rt.x(), rt.y());
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Holds the error that the model publishes against the one that it makes, over whole "
                 "anchorings; tells the share of moments that are covered as CSV. Exit codes: 0 done, 1 a "
                 "run failed, 2 bad option.");
    std::string out, moments;
    double lying = 240;
    std::size_t first = 0, last = anchoring_cases().size();
    app.add_option("--out", out, "file for the table; else standard output");
    app.add_option("--moments", moments, "folder for a file of every moment of each run");
    app.add_option("--lying", lying, "s between brought up and weighing")->capture_default_str();
    app.add_option("--first", first, "number of the first anchoring")->capture_default_str();
    app.add_option("--last", last, "and of the one after the last")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        std::ofstream file;
        if (!out.empty()) {
            file.open(out);
            if (!file) throw std::runtime_error(out + ": cannot be written");
        }
        std::ostream& table = out.empty() ? std::cout : file;
        fmt::print(table, "anchoring,set");
        for (const char* of : {"load", "shape"})
            fmt::print(table, ",{0}_within,{0}_within_three,{0}_worst,{0}_error,{0}_estimate", of);
        fmt::print(table, ",whole_load,whole_shape\n");
        std::vector<MomentError> all[2];
        for (std::size_t k = first; k < std::min(last, anchoring_cases().size()); ++k) {
            const AnchoringCase& c = anchoring_cases()[k];
            const ExerciseDef def = definition(c), fine = finer(def);
            const Anchoring anchoring = work_anchoring(def, c.shackles, lying, false);
            const AnchoringRun run = run_anchoring(def, anchoring);
            const AnchoringRun reference = run_anchoring(fine, at_rate(anchoring, kFine));
            const std::vector<MomentError> errors = moment_errors(run, reference);
            print_row(table, c.name, c.tuned, coverage(errors),
                      difference(run, reference, 0, anchoring.end, def.tick_rate_hz));
            all[c.tuned].insert(all[c.tuned].end(), errors.begin(), errors.end());
            if (!moments.empty())
                write_moments(std::filesystem::path(moments) / fmt::format("{}.csv", k), anchoring, def, run,
                              reference);
        }
        for (const bool tuned : {true, false})
            if (!all[tuned].empty()) print_row(table, "all", tuned, coverage(all[tuned]), {NAN, NAN});
    } catch (const std::exception& error) {
        fmt::print(stderr, "error_coverage: {}\n", error.what());
        return 1;
    }
    return 0;
}
