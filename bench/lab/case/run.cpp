#include "bench/lab/case/run.hpp"

#include "bench/lab/case/processor_time.hpp"
#include "common/json_file.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::lab {
namespace {

Table headings(const std::vector<Probe>& probes) {
    Table table{{"t_s"}, {}};
    for (const Probe& probe : probes)
        table.names.push_back(probe.name + "_" + unit_of(probe.quantity));
    table.columns.resize(table.names.size());
    return table;
}

/// Adds a row; false when it holds something that is no number.
bool write_row(Table& table, double time, const std::vector<Probe>& probes, Meter& meter) {
    table.columns[0].push_back(time);
    bool finite = true;
    for (std::size_t k = 0; k < probes.size(); ++k) {
        const double value = meter.read(probes[k]);
        finite = finite && std::isfinite(value);
        table.columns[k + 1].push_back(value);
    }
    return finite;
}

} // namespace

RunResult run_case(const Case& given, const MethodEntry& entry, int links, double dt,
                   const Progress& progress) {
    const auto method = make_method(entry, given.problem, links, dt, given.settings);
    Meter meter(given.problem, *method);
    RunResult result;
    result.series = headings(given.probes);
    const long total = std::lround(given.problem.duration / dt);
    const long settled = std::lround(given.settle / dt);
    const long stride = std::max(1L, std::lround(given.sample / dt));
    // Between rows the steps run undisturbed, so that looking at the clock costs nothing that counts.
    for (long done = 0;;) {
        if (done >= settled) {
            result.finite = write_row(result.series, (done - settled) * dt, given.probes, meter);
            if (!result.finite) result.stopped = (done - settled) * dt;
        }
        if (progress) progress(double(done) / double(total));
        if (done >= total || !result.finite) break;
        const long next = done < settled ? std::min(settled, done + 1000) : std::min(total, done + stride);
        const double before = processor_seconds();
        for (; done < next; ++done)
            method->step();
        result.seconds += processor_seconds() - before;
        result.steps = done;
    }
    result.simulated = double(result.steps) * dt;
    return result;
}

Comparison compare_with(const Table& series, const ReferenceDef& reference, const Table& measured,
                        const std::string& measured_name) {
    std::size_t column = 1; // its heading is the probe's name and a unit
    while (column + 1 < series.names.size() &&
           series.names[column].substr(0, series.names[column].rfind('_')) != reference.probe)
        ++column;
    const std::vector<double>&times = series.columns[0], &values = series.columns[column];
    Comparison result;
    result.both.names = {"t_s", "computed_" + series.names[column], "measured_" + series.names[column]};
    result.both.columns.resize(3);
    for (std::size_t i = 0; i < measured.rows(); ++i) {
        const double t = measured.columns[0][i] + reference.shift;
        if (t < std::max(reference.from, times.front()) || t > std::min(reference.to, times.back())) continue;
        result.both.columns[0].push_back(t);
        result.both.columns[1].push_back(interpolate(times, values, t));
        result.both.columns[2].push_back(measured.columns[1][i]);
    }
    const std::size_t n = result.both.rows();
    if (n < 2)
        throw ConfigError(measured_name + ": its times, shifted by " + std::to_string(reference.shift) +
                          " s, do not lie within those of the result");
    result.from = result.both.columns[0].front();
    result.to = result.both.columns[0].back();
    const auto figures = [&](const std::vector<double>& v) {
        Comparison::Figures f{v.front(), 0, v.front(), 0};
        for (const double x : v) {
            f.largest = std::max(f.largest, x);
            f.min = std::min(f.min, x);
            f.mean += x / double(n);
            f.low_share += (x < reference.low ? 1.0 : 0.0) / double(n);
        }
        return f;
    };
    result.computed = figures(result.both.columns[1]);
    result.measured = figures(result.both.columns[2]);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
        sum += std::pow(result.both.columns[1][i] - result.both.columns[2][i], 2);
    result.rms = std::sqrt(sum / double(n));
    return result;
}

} // namespace windlass::lab
