#include "server/exercise/talk/report_text.hpp"

#include "server/exercise/talk/bridge_orders.hpp"

#include <array>
#include <cstdio>

namespace windlass::exercise {

namespace {

std::string figure(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
}

} // namespace

std::string report_text(const ReportMade& report) {
    static constexpr std::array kWords{"",
                                       "standing by",
                                       "anchor ready",
                                       "anchor let go",
                                       "shackles on deck",
                                       "shackles in the water",
                                       "cable leading",
                                       "brought up",
                                       "heaving",
                                       "short stay",
                                       "up and down",
                                       "anchor aweigh",
                                       "clear anchor",
                                       "foul anchor",
                                       "anchor home",
                                       "dragging",
                                       "order repeated",
                                       "anchor on the bottom",
                                       "shackles in the pipe",
                                       "cable growing",
                                       "weight on the cable",
                                       "turns in the cable",
                                       "secured",
                                       "does not run",
                                       "brake does not hold",
                                       "no power",
                                       "stand clear",
                                       "defect"};
    static_assert(kWords.size() == static_cast<std::size_t>(ReportCode::defect) + 1);
    static constexpr std::array kStays{"", "up and down", "short stay", "medium stay", "long stay"};
    static constexpr std::array kGrowing{"", "slack", "growing", "tight"};
    static constexpr std::array kWeights{"", "none", "moderate", "much", "too much"};
    std::string line;
    const auto add = [&](const std::string& part) {
        if (!part.empty()) line += (line.empty() ? "" : ", ") + part;
    };
    const std::string words = kWords.at(static_cast<std::size_t>(report.code));
    const bool counted = report.code == ReportCode::shackles_on_deck ||
                         report.code == ReportCode::shackles_in_water ||
                         report.code == ReportCode::shackles_in_pipe || report.code == ReportCode::turns;
    add(counted ? figure(report.value) + ' ' + words : words);
    if (report.code == ReportCode::order_repeated) {
        if (report.order_number > 0) line += ' ' + std::to_string(report.order_number);
        add(order_words(report.order_code, report.side, report.value));
    } else if (report.order_number > 0) {
        add("to order " + std::to_string(report.order_number));
    }
    if (report.lead > 0) add(std::to_string(report.lead) + " o'clock");
    add(kStays.at(static_cast<std::size_t>(report.stay)));
    add(kGrowing.at(static_cast<std::size_t>(report.growing)));
    add(kWeights.at(static_cast<std::size_t>(report.weight)));
    add(report.text);
    return "reported: " + line;
}

} // namespace windlass::exercise
