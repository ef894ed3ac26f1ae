#include "bench/lab/accuracy/suite.hpp"

#include "common/json_schema.hpp"
#include "embedded/suite_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::lab {
namespace {

using Json = nlohmann::json;

SuiteCase read_case(const Json& given, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / given.at("case").get<std::string>();
    SuiteCase one{.name = given.value("name", file.stem().string()),
                  .given = load_case(file, given.value("set", std::vector<std::string>())),
                  .nodes = given.at("nodes"),
                  .rates = given.at("rates"),
                  .drawn = given.value("drawn", given.at("nodes").get<std::vector<int>>()),
                  .reference_rate = given.at("reference_rate"),
                  .until = given.value("until", 1e9),
                  .bar = given.value("bar", "")};
    if (given.contains("title")) one.given.title = given.at("title");
    if (given.contains("duration"))
        one.given.problem.duration = one.given.settle + given.at("duration").get<double>();
    return one;
}

} // namespace

std::vector<std::string> Suite::bars() const {
    std::vector<std::string> names;
    for (const SuiteCase& one : cases)
        if (!one.bar.empty() && std::find(names.begin(), names.end(), one.bar) == names.end())
            names.push_back(one.bar);
    return names;
}

Suite load_suite(const std::filesystem::path& file) {
    static const JsonSchema schema(embedded::suite_schema);
    const Json document = read_json(file);
    schema.check(document, file.string());
    Suite suite;
    suite.max_seconds = document.value("max_seconds", suite.max_seconds);
    for (const MethodEntry& method : methods())
        if (!document.contains("methods")) suite.methods.push_back(&method);
    const Json names = document.value("methods", Json::array());
    for (std::size_t i = 0; i < names.size(); ++i) {
        suite.methods.push_back(find_method(names[i].get<std::string>()));
        if (suite.methods.back() == nullptr)
            throw ConfigError(fmt::format("{}: /methods/{}: {} is not allowed: a method of chain_lab list",
                                          file.string(), i, names[i].dump()));
    }
    for (const Json& given : document.at("cases"))
        suite.cases.push_back(read_case(given, file.parent_path()));
    for (std::size_t i = 0; i < suite.cases.size(); ++i) {
        const SuiteCase& one = suite.cases[i];
        if (const int max = *std::max_element(one.rates.begin(), one.rates.end()); max >= one.reference_rate)
            throw ConfigError(fmt::format("{}: /cases/{}/rates: {} is not allowed: below reference_rate, {}",
                                          file.string(), i, max, one.reference_rate));
        for (std::size_t k = 0; k < i; ++k)
            if (one.name == suite.cases[k].name)
                throw ConfigError(fmt::format("{}: /cases/{}/case: {} is not allowed: a name comes once",
                                              file.string(), i, one.name));
    }
    return suite;
}

} // namespace windlass::lab
