#include "trainee_client/keys.hpp"

#include "station/names.hpp"
#include "station/screen.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <span>
#include <sstream>
#include <vector>

namespace windlass::trainee {

namespace {

constexpr double kBrakeStep = 0.05;
constexpr double kLeverStep = 0.1;
constexpr double kRudderStep = 5 * words::units::degree; // rad

} // namespace

bool apply_key(int key, station::LeverSet& set) {
    using station::Key;
    auto& [windlass, helm] = set;
    // Moves by one notch and stays within limits; a lever near zero snaps to it, for 0.1 has no exact double.
    const auto notch = [](double& lever, double step, double low, double high) {
        lever = std::clamp(lever + step, low, high);
        if (std::abs(lever) < std::abs(step) / 2) lever = 0;
    };
    switch (key) {
    case int(Key::up):
        notch(windlass.brake, kBrakeStep, 0, 1);
        return true;
    case int(Key::down):
        notch(windlass.brake, -kBrakeStep, 0, 1);
        return true;
    case '0':
        windlass.brake = 0;
        return true;
    case 'b':
        windlass.brake = 1;
        return true;
    case int(Key::right):
        notch(windlass.speed_lever, kLeverStep, -1, 1);
        return true;
    case int(Key::left):
        notch(windlass.speed_lever, -kLeverStep, -1, 1);
        return true;
    case 'x':
        windlass.speed_lever = 0;
        return true;
    case 'c':
        windlass.clutch_in = !windlass.clutch_in;
        return true;
    case 't':
        windlass.stopper_closed = !windlass.stopper_closed;
        return true;
    case 'e':
        windlass.emergency_stop = !windlass.emergency_stop;
        return true;
    case 'w':
        notch(helm.engine, kLeverStep, -1, 1);
        return true;
    case 's':
        notch(helm.engine, -kLeverStep, -1, 1);
        return true;
    case 'a':
        notch(helm.rudder, -kRudderStep, -7 * kRudderStep, 7 * kRudderStep);
        return true;
    case 'd':
        notch(helm.rudder, kRudderStep, -7 * kRudderStep, 7 * kRudderStep);
        return true;
    case ',':
        notch(helm.bow_thruster, -kLeverStep, -1, 1);
        return true;
    case '.':
        notch(helm.bow_thruster, kLeverStep, -1, 1);
        return true;
    default:
        return false;
    }
}

namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream{text};
    return {std::istream_iterator<std::string>{stream}, {}};
}

std::optional<double> number_in(const std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    return end != word.c_str() && *end == '\0' && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The longest of the first words, joined by '_', that `known` knows; they are taken from the front.
template <class Known>
auto take_name(std::span<const std::string>& words, Known known) {
    for (std::size_t count = words.size(); count > 0; --count) {
        std::string name;
        for (const std::string& word : words.first(count))
            name += (name.empty() ? "" : "_") + word;
        if (const auto found = known(name)) {
            words = words.subspan(count);
            return found;
        }
    }
    return decltype(known(std::string{})){};
}

/// One more of what a report may say; false when the next word is none of it.
bool take_detail(std::span<const std::string>& words, ReportOrder& report) {
    if (const auto number = number_in(words.front())) {
        const bool hour = report.code == REPORT_LEAD;
        if (hour && (*number != std::floor(*number) || *number < 1 || *number > 12)) return false;
        if (hour)
            report.lead = static_cast<int>(*number);
        else
            report.value = *number;
        words = words.subspan(1);
        return true;
    }
    if (report.code == REPORT_LEAD) {
        if (const auto stay = take_name(words, station::stay_given)) {
            report.stay = *stay;
            if (!words.empty() && words.front() == "stay") words = words.subspan(1);
            return true;
        }
    }
    if (report.code == REPORT_GROWING)
        if (const auto growing = take_name(words, station::growing)) {
            report.growing = *growing;
            return true;
        }
    if (report.code == REPORT_WEIGHT)
        if (const auto weight = take_name(words, station::cable_weight)) {
            report.weight = *weight;
            return true;
        }
    if (words.front() == "o'clock") {
        words = words.subspan(1);
        return true;
    }
    return false;
}

bool counts(ReportCode code) {
    return code == REPORT_SHACKLES_ON_DECK || code == REPORT_SHACKLES_IN_WATER ||
           code == REPORT_SHACKLES_IN_PIPE || code == REPORT_TURNS;
}

} // namespace

ReportOrder parse_report(const std::string& typed) {
    const std::vector<std::string> all = words_of(typed);
    std::span<const std::string> words{all};
    ReportOrder report;
    // "3 shackles in water" as well as "shackles in water 3".
    const auto first = words.empty() ? std::nullopt : number_in(words.front());
    if (first) words = words.subspan(1);
    if (const auto code = take_name(words, station::report_code); code && *code != REPORT_ORDER_REPEATED) {
        report.code = *code;
        report.value = first.value_or(0);
        while (!words.empty())
            if (!take_detail(words, report)) break;
        if (words.empty() && report.code != REPORT_TEXT) return report; // the code says it all
    }
    std::string text;
    for (const std::string& word : all)
        text += (text.empty() ? "" : " ") + word;
    return {.side = {}, .order = {}, .text = text};
}

std::string left_open(const ReportOrder& report) {
    if (counts(report.code) && report.value == 0) return "how many?";
    if (report.code == REPORT_LEAD && report.stay == STAY_NOT_GIVEN)
        return "short, medium, long, up and down?";
    if (report.code == REPORT_LEAD && report.lead == 0 && report.stay != STAY_GIVEN_UP_AND_DOWN)
        return "which hour, 1 to 12?";
    if (report.code == REPORT_GROWING && report.growing == GROWING_NOT_GIVEN) return "slack, growing, tight?";
    if (report.code == REPORT_WEIGHT && report.weight == WEIGHT_NOT_GIVEN)
        return "none, moderate, much, too much?";
    return "";
}

std::optional<ReportOrder> parse_repeat(const std::string& typed, const BridgeOrder& order) {
    ReportOrder report{.code = REPORT_ORDER_REPEATED,
                       .side = {},
                       .order = order.code(),
                       .order_number = order.number(),
                       .text = {}};
    for (const std::string& word : words_of(typed)) {
        const auto says = [&word](std::string_view name) { return name.starts_with(word); };
        if (const auto number = number_in(word))
            report.value = *number;
        else if (says("port"))
            report.side = SIDE_PORT;
        else if (says("starboard"))
            report.side = SIDE_STARBOARD;
        else if (says("both"))
            report.side = -1;
        else
            return std::nullopt;
    }
    return report.side ? std::optional(report) : std::nullopt;
}

} // namespace windlass::trainee
