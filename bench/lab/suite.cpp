#include "bench/lab/suite.hpp"

#include "embedded/suite_schema.hpp"
#include "server/exercise/json_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

namespace windlass::lab {
namespace {

using exercise::ConfigError;
using Json = nlohmann::json;

constexpr const char* kTooLong = "too long";

SuiteCase read_case(const Json& given, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / given.at("case").get<std::string>();
    SuiteCase one{.name = file.stem().string(),
                  .given = load_case(file),
                  .nodes = given.at("nodes"),
                  .rates = given.at("rates"),
                  .drawn = given.value("drawn", given.at("nodes").get<std::vector<int>>()),
                  .reference_rate = given.at("reference_rate"),
                  .until = given.value("until", 1e9),
                  .bar = given.value("bar", false)};
    if (given.contains("duration"))
        one.given.problem.duration = one.given.settle + given.at("duration").get<double>();
    return one;
}

/// The ladder of a line: what is asked for, and the rates just above c/l.
std::vector<int> ladder(const SuiteCase& one, int links) {
    std::set<int> rates(one.rates.begin(), one.rates.end());
    const physics::ChainDef& line = one.given.problem.line;
    const double wave = std::sqrt(line.stiffness / line.mass_per_metre) * links / one.given.problem.length;
    for (const double margin : {1.0, 1.15})
        if (const int rate = kSampleRate * int(std::ceil(margin * wave / kSampleRate));
            rate <= *rates.rbegin())
            rates.insert(rate);
    return {rates.begin(), rates.end()};
}

const MethodEntry* find_method(const std::string& name) {
    const auto& all = methods();
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const MethodEntry& m) { return m.name == name; });
    return at == all.end() ? nullptr : &*at;
}

SuiteRow measure(const SuiteCase& one, const MethodEntry& method, int links, int rate, double most_seconds,
                 const Trace& converged) {
    SuiteRow row{one.name, method.name, links, rate, 0, {}, ""};
    try {
        const TraceLimits limits{one.until, most_seconds};
        Trace run = trace(one.given, method, links, rate, limits);
        row.cost = run.cost;
        // A short run is timed again: the least of three has the least of the machine's other work in it.
        for (int again = 0;
             again < 2 && run.end == Trace::End::whole && run.cost * one.given.problem.duration < 100;
             ++again)
            row.cost = std::min(row.cost, trace(one.given, method, links, rate, limits).cost);
        row.errors = errors_of(run, converged, one.until);
        if (run.end == Trace::End::blew_up) row.end = "blew up";
        if (run.end == Trace::End::too_long) row.end = kTooLong;
    } catch (const std::invalid_argument& error) {
        row.end = error.what();
    }
    return row;
}

} // namespace

Suite load_suite(const std::filesystem::path& file) {
    static const exercise::JsonSchema schema(embedded::suite_schema);
    const Json document = exercise::read_json(file);
    schema.check(document, file.string());
    Suite suite;
    suite.most_seconds = document.value("most_seconds", suite.most_seconds);
    for (const MethodEntry& method : methods())
        if (!document.contains("methods")) suite.methods.push_back(&method);
    const Json names = document.value("methods", Json::array());
    for (std::size_t i = 0; i < names.size(); ++i) {
        suite.methods.push_back(find_method(names[i]));
        if (suite.methods.back() == nullptr)
            throw ConfigError(fmt::format("{}: /methods/{}: {} is not allowed: a method of chain_lab list",
                                          file.string(), i, names[i].dump()));
    }
    for (const Json& given : document.at("cases"))
        suite.cases.push_back(read_case(given, file.parent_path()));
    return suite;
}

std::vector<SuiteRow> run_suite(const Suite& suite,
                                const std::function<void(double share, const std::string& what)>& progress,
                                const std::function<void(const std::vector<SuiteRow>&)>& keep) {
    std::vector<SuiteRow> rows;
    double total = 0, done = 0;
    for (const SuiteCase& one : suite.cases)
        for (const int links : one.nodes)
            total += double(ladder(one, links).size() * suite.methods.size());
    const MethodEntry& production = *find_method("production");
    for (const SuiteCase& one : suite.cases)
        for (const int links : one.nodes) {
            progress(done / total, fmt::format("{}, {} links: converged run", one.name, links));
            const Trace converged = trace(one.given, production, links, one.reference_rate, {one.until, 1e9});
            const int half = one.reference_rate / 2 / kSampleRate * kSampleRate;
            for (const auto& [name, rate] :
                 {std::pair("production", half), std::pair("leapfrog", one.reference_rate)})
                if (const MethodEntry* method = find_method(name)) {
                    rows.push_back(measure(one, *method, links, rate, 1e9, converged));
                    rows.back().method = kReferenceCheck + std::string(": ") + name;
                }
            for (const MethodEntry* method : suite.methods) {
                bool too_long = false; // more steps take no less time
                for (const int rate : ladder(one, links)) {
                    progress(done++ / total,
                             fmt::format("{}, {} links: {} at {}/s", one.name, links, method->name, rate));
                    rows.push_back(too_long
                                       ? SuiteRow{one.name, method->name, links, rate, 0, {}, kTooLong}
                                       : measure(one, *method, links, rate, suite.most_seconds, converged));
                    too_long = rows.back().end == kTooLong;
                }
            }
            keep(rows);
        }
    return rows;
}

void write_rows(const std::filesystem::path& file, const std::vector<SuiteRow>& rows) {
    std::ofstream out(file);
    out << "case,nodes,method,steps_per_s,cost_ms_per_s,tension_error,position_error,link_error,peak_error,"
           "end\n";
    for (const SuiteRow& row : rows) {
        std::string end = row.end;
        std::replace(end.begin(), end.end(), ',', ';');
        const bool whole = end.empty();
        out << fmt::format("{},{},{},{},", row.case_name, row.nodes, row.method, row.rate)
            << (whole ? fmt::format("{:.4g},{:.3e},{:.3e},{:.3e},{:.3e},\n", row.cost, row.errors.tension,
                                    row.errors.position, row.errors.link, row.errors.peak)
                      : fmt::format(",,,,,{}\n", end));
    }
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
}

} // namespace windlass::lab
