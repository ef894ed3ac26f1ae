#include "server/config/config_landmarks.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <set>

namespace windlass::config {
namespace {

using Json = nlohmann::json;

/// From one bearing clockwise to another, 0 to 360 degrees.
double clockwise(double from, double to) {
    return to < from ? to + 360 - from : to - from;
}

/// Each flash after the one before it, and the last over before the next period begins.
void check_light(const Json& mark, const std::string& at, std::vector<std::string>& faults) {
    const bool lit = mark.value("light", "none") != "none";
    const double period = mark.value("period", 0.0);
    const Json flashes = mark.value("flashes", Json::array());
    if (!lit && (period > 0 || !flashes.empty()))
        faults.push_back(fmt::format("{}/light: none is not allowed: it has a period or flashes", at));
    if ((period > 0) != !flashes.empty())
        faults.push_back(
            fmt::format("{}/flashes: {} is not allowed: a period and flashes, or neither of them (a fixed "
                        "light)",
                        at, flashes.dump()));
    double over = 0; // s, when the one before is
    for (std::size_t k = 0; k < flashes.size(); ++k) {
        const double begin = flashes[k][0], end = begin + flashes[k][1].get<double>();
        if (begin < over || end <= begin || end > period)
            faults.push_back(fmt::format(
                "{}/flashes/{}: {} is not allowed: after the one before it, which is over at {} s, "
                "and over within the period, {} s",
                at, k, flashes[k].dump(), over, period));
        over = end;
    }
}

/// Of a light alone, each of another colour than its own, and none in another.
void check_sectors(const Json& mark, const std::string& at, std::vector<std::string>& faults) {
    const Json sectors = mark.value("sectors", Json::array());
    const std::string light = mark.value("light", "none");
    std::vector<std::pair<double, double>> taken; // degrees: where it begins, how far it goes clockwise
    for (std::size_t k = 0; k < sectors.size(); ++k) {
        const double from = sectors[k]["from_deg"], to = sectors[k]["to_deg"];
        const double wide = clockwise(from, to);
        const std::string place = fmt::format("{}/sectors/{}", at, k);
        if (light == "none" || sectors[k]["light"] == light)
            faults.push_back(
                fmt::format("{}/light: {} is not allowed: {}", place, sectors[k]["light"].dump(),
                            light == "none" ? "the mark has no light" : "the light's own colour"));
        if (wide == 0)
            faults.push_back(
                fmt::format("{}/to_deg: {} is not allowed: another bearing than from_deg", place, to));
        for (const auto& [begin, far] : taken)
            if (clockwise(begin, from) < far || clockwise(from, begin) < wide)
                faults.push_back(
                    fmt::format("{}: {} to {} is not allowed: within another sector, which begins at {}",
                                place, from, to, begin));
        taken.emplace_back(from, wide);
    }
}

/// The wire counts bytes where the schema counts characters.
void check_name(const Json& named, const std::string& at, std::vector<std::string>& faults) {
    constexpr std::size_t kMaxName = 32;
    if (named["name"].get_ref<const std::string&>().size() > kMaxName)
        faults.push_back(fmt::format("{}/name: {} is not allowed: at most {} bytes of UTF-8", at,
                                     named["name"].dump(), kMaxName));
}

} // namespace

std::vector<std::string> landmark_faults(const std::string& landmarks) {
    std::vector<std::string> faults;
    if (landmarks.empty()) return faults;
    const Json document = Json::parse(landmarks);
    const auto list = [&](const char* name) { return document.value(name, Json::array()); };
    const Json coasts = list("coasts"), marks = list("marks"), transits = list("transits");
    for (std::size_t k = 0; k < coasts.size(); ++k)
        if (const std::size_t shore = coasts[k]["shore"].size(), ridge = coasts[k]["ridge"].size();
            ridge != shore)
            faults.push_back(fmt::format(
                "/landmarks/coasts/{}/ridge: {} points is not allowed: {}, as shore has", k, ridge, shore));
    std::set<std::string> names;
    for (std::size_t k = 0; k < marks.size(); ++k) {
        const std::string at = fmt::format("/landmarks/marks/{}", k);
        if (!names.insert(marks[k]["name"]).second)
            faults.push_back(
                fmt::format("{}/name: {} is not allowed: another mark has it", at, marks[k]["name"].dump()));
        check_name(marks[k], at, faults);
        check_light(marks[k], at, faults);
        check_sectors(marks[k], at, faults);
    }
    for (std::size_t k = 0; k < transits.size(); ++k) {
        check_name(transits[k], fmt::format("/landmarks/transits/{}", k), faults);
        for (const char* end : {"front", "rear"})
            if (!names.contains(transits[k][end]))
                faults.push_back(
                    fmt::format("/landmarks/transits/{}/{}: {} is not allowed: the name of a mark", k, end,
                                transits[k][end].dump()));
        if (transits[k]["front"] == transits[k]["rear"])
            faults.push_back(
                fmt::format("/landmarks/transits/{}/rear: {} is not allowed: another mark than front", k,
                            transits[k]["rear"].dump()));
    }
    return faults;
}

} // namespace windlass::config
