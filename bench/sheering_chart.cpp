// Every ship at anchor in a steady wind: how far she sheers, how long an eight takes, and what her cable
// carries; and with a second anchor underfoot. docs/ships.md says what to make of it.

#include "bench/program.hpp"
#include "bench/sheering_drawing.hpp"
#include "bench/table_file.hpp"
#include "bench/yaw_damping.hpp"

#include <CLI/CLI.hpp>
#include <fmt/ostream.h>

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace windlass;

namespace {

struct Options {
    bench::TableOptions table;
    std::string chart;
    bool reports = false, damping = false;
    std::vector<double> winds{12, 20};
    std::vector<std::string> ships;
    std::string others; ///< table that has the rows of the ships that are not asked for
};

void print(std::ostream& table, const bench::SheeringRow& row) {
    const rigs::Sheering& s = row.found;
    fmt::print(table, "{},{},{},{:.0f},{:.1f},{:.0f},{:.0f},{:.0f},{:.2f},{:.1f},{:.0f}\n", row.ship.ship,
               row.wind, row.underfoot ? 2 : 1, s.yaw, s.period / 60, s.mean / 1e3, s.peak / 1e3,
               s.ahead / 1e3, s.peak / s.mean, s.peak / s.ahead, s.dragged);
    table.flush();
}

/// A row of an earlier table, and its line as it stands there.
struct Earlier {
    bench::SheeringRow row;
    std::string line;
};

/// What that table has of a ship. Throws std::runtime_error when it cannot be read.
std::vector<Earlier> rows_of(const rigs::AnchoredShip& ship, const std::string& file) {
    std::ifstream table(file);
    if (!table) throw std::runtime_error(file + ": cannot be read");
    std::vector<Earlier> rows;
    for (std::string line; std::getline(table, line);) {
        if (!line.starts_with(ship.ship + ",")) continue;
        std::string text = line.substr(ship.ship.size());
        std::ranges::replace(text, ',', ' ');
        std::istringstream fields(text);
        bench::SheeringRow row;
        row.ship = ship;
        rigs::Sheering& s = row.found;
        int anchors = 0;
        double over_mean = 0, over_ahead = 0;
        if (!(fields >> row.wind >> anchors >> s.yaw >> s.period >> s.mean >> s.peak >> s.ahead >>
              over_mean >> over_ahead >> s.dragged))
            throw std::runtime_error(file + ": not a table of this program: " + line);
        row.underfoot = anchors == 2;
        s.period *= 60, s.mean *= 1e3, s.peak *= 1e3, s.ahead *= 1e3;
        rows.push_back({row, line});
    }
    return rows;
}

void run(const Options& options) {
    bench::TableFile file(options.table);
    std::ostream& table = file.stream();
    fmt::print(table, "ship,wind_m_per_s,anchors,yaw_deg,period_min,mean_kN,peak_kN,ahead_kN,peak_over_mean,"
                      "peak_over_ahead,dragged_m\n");
    std::vector<bench::SheeringRow> rows;
    const auto look = [&](const rigs::AnchoredShip& ship, double wind, bool underfoot) {
        rows.push_back({ship, wind, underfoot, rigs::sheer(ship, rigs::steady_wind(wind), underfoot)});
        print(table, rows.back());
    };
    for (const rigs::AnchoredShip& ship : rigs::anchored_ships()) {
        if (!options.ships.empty() && std::ranges::find(options.ships, ship.ship) == options.ships.end()) {
            if (options.others.empty()) continue;
            for (const auto& [row, line] : rows_of(ship, options.others)) {
                rows.push_back(row);
                table << line << '\n';
            }
            continue;
        }
        for (const double wind : options.winds)
            look(ship, wind, false);
        look(ship, options.winds.back(), true);
    }
    if (!options.chart.empty()) bench::drawing_of(rows).save(options.chart);
}

/// A ship at anchor of whom a report tells how she yawed, and what weather it tells of; docs/ships.md has
/// what of it is our guess.
struct Report {
    std::string name;
    rigs::AnchoredShip ship;
    double sweep = 0; ///< deg, from side to side, as reported
    double wind = 0;  ///< m/s
    /// The same with more and more of the weather, each with all before it.
    std::vector<std::pair<std::string, void (*)(exercise::Weather&)>> more;
};

std::vector<Report> reports() {
    rigs::AnchoredShip pasha_bulker = rigs::anchored_ship("panamax_ballast"),
                       box_ship = rigs::anchored_ship("container_ship_300m");
    pasha_bulker.anchor = "hhp_7425";
    pasha_bulker.cable = 247, box_ship.cable = 220;
    box_ship.depth = 35;
    const auto gusts = [](exercise::Weather& weather) { weather.gust_factor = 1.25; };
    return {
        {"Pasha Bulker",
         pasha_bulker,
         30,
         18,
         {{"gusts", gusts}, {"sea", [](exercise::Weather& w) { w.wave_height = 2.8, w.wave_period = 9; }}}},
        {"box ship",
         box_ship,
         70,
         20.6,
         {{"gusts", gusts},
          {"wind sea", [](exercise::Weather& w) { w.wave_height = 2, w.wave_period = 6; }},
          {"stream", [](exercise::Weather& w) { w.current_speed = 1.3; }}}}};
}

void run_reports(const Options& options) {
    bench::TableFile file(options.table);
    std::ostream& table = file.stream();
    fmt::print(table,
               "report,wind_m_per_s,and,reported_deg,sweep_deg,period_min,mean_kN,peak_kN,dragged_m\n");
    for (const Report& report : reports()) {
        exercise::Weather weather = rigs::steady_wind(report.wind);
        const auto look = [&](const std::string& with) {
            constexpr double kFreshens = 1200; // s: a gale that comes at once drags anchors by her way in it
            const rigs::Sheering s = rigs::sheer(report.ship, weather, false, 60, kFreshens);
            fmt::print(table, "{},{},{},{},{:.0f},{:.1f},{:.0f},{:.0f},{:.0f}\n", report.name, report.wind,
                       with, report.sweep, s.sweep, s.period / 60, s.mean / 1e3, s.peak / 1e3, s.dragged);
            table.flush();
        };
        look("");
        for (const auto& [what, change] : report.more) {
            change(weather);
            look(what);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    std::vector<std::string> known;
    for (const rigs::AnchoredShip& ship : rigs::anchored_ships())
        known.push_back(ship.ship);
    CLI::App app("Lets every ship of docs/ships.md lie to one anchor and, in the strongest wind, to a second "
                 "one underfoot as well; tells yaw, period and load as CSV. Some 10 s for a row. Exit "
                 "codes: 0 done, 1 a run failed or a file cannot be written, 2 bad option.",
                 "sheering_chart");
    bench::add_table_options(app, options.table);
    app.add_option("--chart", options.chart, "file for the chart, SVG; else none");
    app.add_option("--winds", options.winds, "m/s, the strongest last")
        ->check(CLI::Range(1.0, 60.0))
        ->capture_default_str();
    app.add_option("--ships", options.ships, "names in config/ships; else all")->check(CLI::IsMember(known));
    app.add_option("--others", options.others,
                   "an earlier table of the same model, for the rows of the ships that are not asked for");
    app.add_flag("--reports", options.reports,
                 "instead, the ships of which reports tell how they yawed, in more and more of the weather");
    app.add_flag("--damping", options.damping,
                 "instead, the Panamax in ballast with one thing at a time that could damp or steady her");
    return bench::run_program(app, argc, argv, [&] {
        if (options.damping)
            bench::table_of_dampings(bench::TableFile(options.table).stream(), options.winds);
        else
            options.reports ? run_reports(options) : run(options);
    });
}
