#include "trainee_client/keys.hpp"

#include "station/names.hpp"
#include "station/screen.hpp"

#include <algorithm>
#include <cstdlib>
#include <numbers>

namespace windlass::trainee {

namespace {

constexpr double kBrakeStep = 0.05;
constexpr double kLeverStep = 0.1;
constexpr double kRudderStep = 5 * std::numbers::pi / 180; // rad

/// Moves by one notch and stays within limits; a lever near zero snaps to it, for 0.1 has no exact double.
void notch(double& lever, double step, double low, double high) {
    lever = std::clamp(lever + step, low, high);
    if (std::abs(lever) < std::abs(step) / 2) lever = 0;
}

} // namespace

bool apply_key(int key, station::LeverSet& set) {
    using station::Key;
    auto& [windlass, helm] = set;
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

ReportOrder parse_report(const std::string& typed) {
    const auto begin = typed.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    std::string words = typed.substr(begin, typed.find_last_not_of(' ') - begin + 1);
    ReportOrder report{.text = words};

    std::string name = words;
    if (const auto space = words.find_last_of(' '); space != std::string::npos) {
        char* end = nullptr;
        const double number = std::strtod(words.c_str() + space, &end);
        if (*end == '\0') {
            report.value = number;
            name.resize(words.find_last_not_of(' ', space) + 1);
        }
    }
    std::ranges::replace(name, ' ', '_');
    report.code = station::report_code(name).value_or(REPORT_TEXT);
    if (report.code != REPORT_TEXT) report.text.clear(); // the code says it already
    return report;
}

} // namespace windlass::trainee
