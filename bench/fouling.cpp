// How often an anchor that is let go comes to lie foul of its own cable, by the length of the model's links.
// README.md says how to read it.

#include "bench/anchorings.hpp"
#include "bench/program.hpp"
#include "bench/table_file.hpp"
#include "bench/work_in_order.hpp"
#include "rigs/drill.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using namespace windlass;
using namespace windlass::bench;

namespace {

/// Drawn astern until the anchor holds so many times its weight, or has been dragged so far (m).
constexpr double kHolds = 1, kDrawn = 20;
/// An anchor that lies so far (degrees) off its cable's way to the ship then, and has not dug in, lies
/// astray.
constexpr double kAstray = 60, kDugIn = 0.5;

/// How the anchor lies when all is out and has been drawn tight.
struct Lies {
    double links = 0;  ///< m, of the model
    bool foul = false; ///< of its own cable now, as the model calls it
    bool was_foul = false;
    double off_lead = 0;  ///< degrees, level, of the shank from the way to the hawse
    double embedment = 0; ///< 0..1
    double holding = 0;   ///< anchor's weights, that the ground can give
    double dragged = 0;   ///< m
    double largest = 0;   ///< N, that any link has borne

    bool astray() const { return off_lead > kAstray && embedment < kDugIn; }
};

/// All of it at once, brake wide open, and hard on at the end. False when it took longer than ten minutes.
bool run_out(rigs::Drill& drill, int shackles) {
    drill.run(5);
    drill.brake(0);
    if (!drill.run_until([&] { return drill.shackles() > shackles - 0.5; }, 600)) return false;
    drill.brake(1);
    return drill.run_until([&] { return std::abs(drill.windlass().cable_speed) < 0.02; }, 600);
}

/// links: m, 0: as the model's policy has them. Nothing when the cable was not all out in time.
std::optional<Lies> let_go(const DrawnAnchoring& c, double links, bool checked) {
    exercise::ExerciseDef def = definition(c);
    if (links > 0) {
        def.model.adaptive = false;
        def.tackle[0].chain.node_spacing = links;
    }
    rigs::Drill drill(def);
    if (!(checked ? rigs::let_go_and_pay_out(drill, c.shackles) : run_out(drill, c.shackles))) return {};
    const double weight = def.tackle[0].anchor.mass * physics::kGravity;
    drill.engine(-0.3);
    drill.run_until(
        [&] { return drill.anchor().holding_used > kHolds * weight || drill.anchor().dragged > kDrawn; },
        1200);
    drill.engine(0);
    drill.run(60);
    const exercise::AnchorView& anchor = drill.anchor();
    physics::Vec3 shank = anchor.attitude * physics::Vec3::UnitX(),
                  way = drill.chain().nodes.front().cast<double>() - anchor.position;
    shank.z() = way.z() = 0;
    const double cosine = std::clamp(way.normalized().dot(shank.normalized()), -1.0, 1.0);
    return Lies{.links = exercise::modelled_chain(def, def.tackle[0]).node_spacing,
                .foul = anchor.fouled > 0,
                .was_foul = drill.count("anchor.fouled") > 0,
                .off_lead = physics::degrees_from_radians(std::acos(cosine)),
                .embedment = anchor.embedment,
                .holding = anchor.holding_capacity / weight,
                .dragged = anchor.dragged,
                .largest = drill.chain().largest_tension};
}

/// Those of the seed that are let go, the first so many.
std::vector<std::uint64_t> numbers(std::uint64_t seed, std::size_t count) {
    std::vector<std::uint64_t> all;
    for (std::uint64_t k = 0; all.size() < count; ++k)
        if (!drawn_anchoring(seed, k).walked_back) all.push_back(k);
    return all;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Lets go anchors drawn at random, draws their cables tight and tells how each comes to lie, by "
        "the length of the model's links, as CSV. Exit codes: 0 done, 1 a run failed, 2 bad option.",
        "fouling");
    TableOptions options;
    std::uint64_t seed = 1;
    std::size_t count = 50, threads = std::thread::hardware_concurrency();
    std::vector<double> links{0, 0.8, 0.3};
    bool unchecked = false;
    add_table_options(app, options);
    app.add_option("--seed", seed, "of the draw")->capture_default_str();
    app.add_option("--count", count, "let-gos")->capture_default_str();
    app.add_option("--links", links, "m, lengths of the model's links; 0: as its policy has them")
        ->delimiter(',')
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    app.add_flag("--unchecked", unchecked,
                 "all the cable at once, brake wide open, instead of a shackle at a time");
    app.add_option("--threads", threads, "let-gos worked at a time")->check(CLI::Range(1, 64));
    return run_program(app, argc, argv, [&] {
        TableFile file(options);
        std::ostream& table = file.stream();
        fmt::print(table, "number,anchoring,anchor,links,was_foul,foul,off_lead_deg,embedment,holding,"
                          "dragged,largest_kn\n");
        std::vector<std::size_t> foul(links.size()), astray(links.size());
        const std::vector<std::uint64_t> all = numbers(seed, count);
        using ByLinks = std::vector<std::optional<Lies>>;
        const auto work = [&](std::size_t k) {
            ByLinks lies;
            for (const double each : links)
                lies.push_back(let_go(drawn_anchoring(seed, all[k]), each, !unchecked));
            return lies;
        };
        work_in_order(0, all.size(), threads, work, [&](std::size_t k, std::future<ByLinks>& worked) {
            const DrawnAnchoring c = drawn_anchoring(seed, all[k]);
            const ByLinks lies = worked.get();
            for (std::size_t s = 0; s < lies.size(); ++s) {
                if (!lies[s]) throw std::runtime_error(fmt::format("{}: not paid out in time", title(c)));
                const Lies& l = *lies[s];
                foul[s] += l.foul ? 1 : 0;
                astray[s] += l.astray() ? 1 : 0;
                fmt::print(table, "{},\"{}\",{},{:.2f},{},{},{:.0f},{:.2f},{:.2f},{:.1f},{:.0f}\n", all[k],
                           title(c), c.outfit.anchor, l.links, l.was_foul ? 1 : 0, l.foul ? 1 : 0, l.off_lead,
                           l.embedment, l.holding, l.dragged, 1e-3 * l.largest);
            }
            table.flush();
        });
        for (std::size_t s = 0; s < links.size(); ++s)
            fmt::print(table, "# links {}: {} of {} foul, {} astray\n", links[s], foul[s], count, astray[s]);
    });
}
