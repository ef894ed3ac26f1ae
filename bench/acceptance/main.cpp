// The windlasses of config/ put through IACS UR A3's acceptance runs, the energy of an anchoring with each,
// and what the ground tackle holds: docs/acceptance.md is what this writes.

#include "bench/acceptance/balance.hpp"
#include "bench/acceptance/holding.hpp"
#include "bench/acceptance/ur_a3.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

using namespace windlass;

namespace {

constexpr double kMegajoule = 1e6;
constexpr double kSmallest = 1e3; ///< J, of an account that is shown

void write_findings(std::ostream& out, const lab::Machine& machine) {
    fmt::print(out, "\n### {}\n\n| UR A3 | required | | measured | | |\n|---|---|---|---|---|---|\n",
               machine.name);
    for (const lab::Finding& f : lab::accept(machine)) {
        fmt::print(out, "| {} | {} | {} {:.4g} {} | {:.4g} {} | {} | {} |\n", f.clause, f.requirement,
                   f.bound == lab::Bound::at_least ? "at least" : "at most", f.required, f.unit, f.measured,
                   f.unit, f.met() ? "met" : "**not met**", f.note);
    }
}

void write_balances(std::ostream& out, const std::vector<lab::Balance>& runs) {
    fmt::print(out, "\n| MJ |");
    for (const lab::Balance& run : runs)
        fmt::print(out, " {} |", run.run);
    fmt::print(out, "\n|---|");
    for (std::size_t k = 0; k < runs.size(); ++k)
        fmt::print(out, "---|");
    const auto line = [&](const std::string& name, const auto& value) {
        fmt::print(out, "\n| {} |", name);
        for (const lab::Balance& run : runs)
            fmt::print(out, " {:.3f} |", value(run) / kMegajoule);
    };
    line("given up by weight, motion and stretch", [](const lab::Balance& run) { return run.given_up; });
    for (std::size_t k = 0; k < runs.front().sinks.size(); ++k) {
        const auto used = [&](const lab::Balance& run) { return std::abs(run.sinks[k].joules) >= kSmallest; };
        if (std::any_of(runs.begin(), runs.end(), used))
            line(runs.front().sinks[k].name, [&](const lab::Balance& run) { return run.sinks[k].joules; });
    }
    fmt::print(out, "\n| **not accounted for** |");
    for (const lab::Balance& run : runs)
        fmt::print(out, " {:.2f} % |", 100 * run.open());
    for (std::size_t k = 0; k < runs.front().brake.size(); ++k)
        line("band brake: " + runs.front().brake[k].name,
             [&](const lab::Balance& run) { return run.brake[k].joules; });
    fmt::print(out, "\n| hottest lining, drum |");
    for (const lab::Balance& run : runs)
        fmt::print(out, " {:.0f}, {:.1f} °C |", physics::celsius_from_kelvin(run.lining),
                   physics::celsius_from_kelvin(run.drum));
    fmt::print(out, "\n");
}

void write(std::ostream& out, const std::string& config) {
    fmt::print(out,
               "# Acceptance of windlasses and ground tackle\n\n"
               "Written by `build/release/bin/acceptance --out docs/acceptance.md`; tests hold every line "
               "(`Acceptance`, `Balance`, `HoldingPower`, `Uplift`). BL is the cable's breaking load.\n\n"
               "## IACS UR A3 Rev.1 (2019)\n\n"
               "Pulls are at the gypsy; the anchor hangs in still water, on the cable of docs/physics.md. "
               "The rule's pay-out test gives no speed: here one shackle has run free when the brake goes "
               "hard on.\n");
    const std::vector<lab::Machine> machines = lab::shipped_machines(config);
    for (const lab::Machine& machine : machines)
        write_findings(out, machine);
    fmt::print(out,
               "\n## Where the energy goes\n\n"
               "What weight, motion and stretch of cable and anchor give up, and where it is found again: "
               "each sink is summed from force times speed where it acts. Below zero: put in. Not accounted "
               "for is the difference, as a share of all that was turned over. Accounts below 1 kJ are left "
               "out.\n");
    for (const lab::Machine& machine : machines) {
        fmt::print(out, "\n### {}\n", machine.name);
        write_balances(
            out, {lab::let_go(machine), lab::walk_back(machine), lab::weigh(machine), lab::run_out(machine)});
    }
    lab::write_holding(out);
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Puts every windlass of the config folder through the acceptance runs of IACS UR A3 and closes the "
        "energy of an anchoring with it; then what anchor and cable hold by soil, scope and uplift. Writes "
        "tables in Markdown. Exit codes: 0 done, 1 a run failed, "
        "2 bad option.");
    std::string out, config = WINDLASS_CONFIG_DIR;
    app.add_option("--out", out, "file for the table; else standard output");
    app.add_option("--config", config, "folder with windlasses, chains and anchors")->capture_default_str();
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
        write(out.empty() ? std::cout : file, config);
    } catch (const std::exception& error) {
        fmt::print(stderr, "acceptance: {}\n", error.what());
        return 1;
    }
    return 0;
}
