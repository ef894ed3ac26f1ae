#include "bench/lab/stability/stability_suite.hpp"

#include "common/json_schema.hpp"
#include "embedded/stability_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::lab {
namespace {

using Json = nlohmann::json;

/// A suite that is being read.
struct Source {
    std::string name;
    std::filesystem::path folder;

    [[noreturn]] void refuse(const std::string& pointer, const Json& value,
                             const std::string& allowed) const {
        throw ConfigError(fmt::format("{}: {}: {} is not allowed: {}", name, pointer, value.dump(), allowed));
    }
    Case read_case(const Json& file) const { return load_case(folder / file.get<std::string>()); }
};

StabilityMethod read_method(const Json& given, const std::string& at, const Source& source) {
    StabilityMethod method;
    const Json& name = given.is_object() ? given.at("method") : given;
    method.entry = find_method(name.get<std::string>());
    if (method.entry == nullptr) source.refuse(at, name, "a method of chain_lab list");
    method.name = name.get<std::string>();
    if (!given.is_object()) return method;
    method.name = given.value("name", method.name);
    method.settings.iterations = given.value("iterations", 0);
    return method;
}

/// A map whose lines are one case with a quantity changed.
void read_lines(const Json& given, const std::string& at, const Source& source, StabilityMap& map) {
    const auto axis = given.at("axis").get<std::string>();
    if (!given.contains("case") || !given.contains("values"))
        source.refuse(at, given, "a case and values, as its axis is " + axis);
    const Case base = source.read_case(given.at("case"));
    if (axis == "mass_ratio" && base.problem.lower.kind != EndKind::mass)
        source.refuse(at + "/case", given.at("case"), "a case with a mass at its lower end");
    const int links = given.value("nodes", base.links);
    for (std::size_t i = 0; i < given.at("values").size(); ++i) {
        const Json& value = given.at("values")[i];
        const double number = value.get<double>();
        StabilityLine line{fmt::format("{:g}", number), base, links};
        if (axis == "mass_ratio") line.given = with_mass_ratio(base, links, number);
        if (axis == "stiffness") line.given.problem.line.stiffness *= number;
        if (axis == "nodes") {
            if (number != int(number) || number < 2)
                source.refuse(fmt::format("{}/values/{}", at, i), value, "a whole number of 2 or more links");
            line.links = int(number);
        }
        map.lines.push_back(std::move(line));
    }
}

StabilityMap read_map(const Json& given, const std::string& at, const Source& source) {
    const auto axis = given.at("axis").get<std::string>();
    StabilityMap map{.name = given.at("name"), .title = given.at("title"), .axis = {}, .lines = {}};
    if (axis == "event") {
        if (!given.contains("events")) source.refuse(at, given, "events, as its axis is event");
        for (const Json& event : given.at("events")) {
            const Case base = source.read_case(event.at("case"));
            map.lines.push_back({event.at("label"), base, given.value("nodes", base.links)});
        }
        return map;
    }
    map.axis = axis == "mass_ratio" ? "anchor / link mass" : axis == "nodes" ? "links" : "EA / chain's";
    read_lines(given, at, source, map);
    return map;
}

} // namespace

Case with_mass_ratio(Case given, int links, double ratio) {
    Problem& problem = given.problem;
    const double link = problem.line.mass_per_metre * problem.length / links, max = problem.lower.mass;
    const double anchor = std::min(max, ratio * link), lighter = anchor / (ratio * link);
    problem.lower.mass = anchor;
    problem.lower.weight *= anchor / max;
    problem.line.mass_per_metre *= lighter;
    problem.line.displacement *= lighter;
    return given;
}

StabilitySuite load_stability(const std::filesystem::path& file) {
    static const JsonSchema schema(embedded::stability_schema);
    const Json document = read_json(file);
    schema.check(document, file.string());
    const Source source{file.string(), file.parent_path()};
    StabilitySuite suite;
    suite.max_seconds = document.value("max_seconds", suite.max_seconds);
    suite.rates = document.at("rates").get<std::vector<int>>();
    const auto once = [&](const auto& list, const std::string& at) {
        for (std::size_t i = 0; i + 1 < list.size(); ++i)
            if (list[i].name == list.back().name) source.refuse(at, list.back().name, "a name comes once");
    };
    const Json& names = document.at("methods");
    for (std::size_t i = 0; i < names.size(); ++i) {
        suite.methods.push_back(read_method(names[i], fmt::format("/methods/{}", i), source));
        once(suite.methods, fmt::format("/methods/{}", i));
    }
    const Json& maps = document.at("maps");
    for (std::size_t i = 0; i < maps.size(); ++i) {
        suite.maps.push_back(read_map(maps[i], fmt::format("/maps/{}", i), source));
        once(suite.maps, fmt::format("/maps/{}", i));
    }
    return suite;
}

} // namespace windlass::lab
