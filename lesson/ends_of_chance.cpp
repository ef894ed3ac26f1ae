#include "lesson/ends_of_chance.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace windlass::lesson {

namespace {

using nlohmann::json;

/// Which of a lesson's faults come in kinds, by the name of the choice.
std::map<std::string, std::vector<std::size_t>> kinds_of(const json& faults) {
    std::map<std::string, std::vector<std::size_t>> kinds;
    for (std::size_t k = 0; k < faults.size(); ++k)
        if (const std::string name = faults[k].value("one_of", ""); !name.empty()) kinds[name].push_back(k);
    return kinds;
}

/// Without those of each choice that are not the number-th of its kinds, or its last.
json of_one_kind(const json& faults, std::size_t number) {
    json kept = faults;
    for (const auto& [name, all] : kinds_of(faults))
        for (std::size_t k = 0; k < all.size(); ++k)
            if (k != std::min(number, all.size() - 1)) kept[all[k]] = nullptr;
    std::erase(kept.get_ref<json::array_t&>(), json());
    return kept;
}

bool draws(const json& faults, const char* bounds) {
    return std::ranges::any_of(faults, [&](const json& one) { return one.contains(bounds); });
}

void set_to_end(json& faults, const char* bounds, std::size_t end) {
    for (json& one : faults)
        if (one.contains(bounds)) one[bounds] = {one[bounds][end], one[bounds][end]};
}

constexpr const char *kDelay = "delay", *kSeverity = "severity_between";

} // namespace

std::vector<AtAnEnd> ends_of_chance(const exercise::ExerciseDef& def) {
    std::vector<AtAnEnd> all;
    if (def.lesson.empty()) return all;
    json lesson = json::parse(def.lesson);
    const json faults = lesson.value("faults", json::array());
    std::size_t kinds = 1;
    for (const auto& [name, of_it] : kinds_of(faults))
        kinds = std::max(kinds, of_it.size());
    const bool moment = draws(faults, kDelay), severity = draws(faults, kSeverity);
    if (!moment && !severity && kinds == 1) return all;
    constexpr std::array kMoments{"soonest", "latest"}, kSeverities{"weakest", "strongest"};
    for (std::size_t kind = 0; kind < kinds; ++kind)
        for (std::size_t late = 0; late < (moment ? 2U : 1U); ++late)
            for (std::size_t strong = 0; strong < (severity ? 2U : 1U); ++strong) {
                json at_end = of_one_kind(faults, kind);
                set_to_end(at_end, kDelay, late);
                set_to_end(at_end, kSeverity, strong);
                lesson["faults"] = at_end;
                AtAnEnd& one = all.emplace_back(AtAnEnd{{}, def});
                one.def.lesson = lesson.dump();
                const auto add = [&](bool drawn, const std::string& word) {
                    if (drawn) one.which += (one.which.empty() ? "" : ", ") + word;
                };
                add(moment, kMoments[late]);
                add(severity, kSeverities[strong]);
                add(kinds > 1, fmt::format("kind {} of {}", kind + 1, kinds));
            }
    return all;
}

} // namespace windlass::lesson
