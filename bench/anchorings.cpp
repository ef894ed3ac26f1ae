#include "bench/anchorings.hpp"

#include "server/config/config.hpp"

#include <fmt/core.h>

#include <array>

namespace windlass::bench {

namespace {

constexpr const char* kPanamax = "bulk_carrier_225m";
constexpr const char* kCape = "capesize_ballast";

constexpr std::array kCases{
    //            name                tuned depth soil   ship   sh. walked wind swell
    AnchoringCase{"25 m sand", true, 25, "sand", kPanamax, 6, false, 8, 0},
    AnchoringCase{"15 m mud", true, 15, "mud", kPanamax, 4, false, 8, 0},
    AnchoringCase{"40 m gravel", true, 40, "gravel", kPanamax, 7, false, 10, 0},
    AnchoringCase{"60 m clay", true, 60, "clay", kPanamax, 7, true, 8, 0},
    AnchoringCase{"20 m sand, cape", true, 20, "sand", kCape, 5, false, 8, 0},
    AnchoringCase{"35 m mud, cape", true, 35, "mud", kCape, 6, false, 6, 0},
    AnchoringCase{"30 m sand, swell", true, 30, "sand", kPanamax, 6, false, 10, 2},
    AnchoringCase{"25 m gravel, cape, swell", true, 25, "gravel", kCape, 5, false, 8, 1.5},
    AnchoringCase{"18 m gravel", false, 18, "gravel", kPanamax, 5, false, 9, 0},
    AnchoringCase{"30 m mud", false, 30, "mud", kPanamax, 6, false, 7, 0},
    AnchoringCase{"35 m sand", false, 35, "sand", kPanamax, 7, false, 8, 0},
    AnchoringCase{"80 m sand", false, 80, "sand", kPanamax, 8, true, 8, 0},
    AnchoringCase{"50 m mud, cape", false, 50, "mud", kCape, 7, true, 7, 0},
    AnchoringCase{"15 m gravel, cape", false, 15, "gravel", kCape, 4, false, 7, 0},
    AnchoringCase{"30 m sand, cape", false, 30, "sand", kCape, 6, false, 9, 0},
    AnchoringCase{"20 m mud, swell", false, 20, "mud", kPanamax, 5, false, 9, 1.5},
    AnchoringCase{"45 m sand, swell", false, 45, "sand", kPanamax, 7, false, 10, 2.5},
    AnchoringCase{"35 m gravel, cape, swell", false, 35, "gravel", kCape, 6, false, 8, 2},
    AnchoringCase{"60 m gravel, cape", false, 60, "gravel", kCape, 8, true, 8, 0},
    AnchoringCase{"25 m clay, swell", false, 25, "clay", kPanamax, 6, false, 9, 1.5},
};

} // namespace

std::span<const AnchoringCase> anchoring_cases() {
    return kCases;
}

exercise::ExerciseDef definition(const AnchoringCase& c) {
    const bool cape = std::string(c.ship) == kCape;
    const std::string text = fmt::format(
        R"({{"from": "let_go_port_25m", "name": "coverage", "title": "{}",
             "environment": {{"depth": {}, "soil": "{}", "wind_speed": {}, "swell_height": {}, "swell_period": 10}},
             "ship": {{"from": "{}"}},
             "tackle": [{{"side": "port", "windlass": {{"from": "{}"}}, "chain": {{"from": "{}"}},
                          "anchor": {{"from": "{}"}}, "cable_out": 5, "brake": 1, "clutch_in": {},
                          "stopper_closed": false}}]}})",
        c.name, c.depth, c.soil, c.wind, c.swell, c.ship, cape ? "electric_100mm" : "electric_78mm",
        cape ? "stud_link_100mm_k3" : "stud_link_78mm_k3", cape ? "stockless_16900" : "stockless_9900",
        c.walked_back);
    return config::parse_exercise(text, c.name, WINDLASS_CONFIG_DIR);
}

} // namespace windlass::bench
