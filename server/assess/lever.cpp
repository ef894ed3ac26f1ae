#include "server/assess/lever.hpp"

#include "server/physics/base/units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace windlass::assess {

double place_of(const Lever& lever, const exercise::WindlassOrder& windlass,
                const exercise::HelmOrder& helm) {
    switch (lever.kind) {
    case LeverKind::brake:
        return windlass.brake;
    case LeverKind::speed:
        return windlass.speed_lever;
    case LeverKind::clutch:
        return windlass.clutch_in ? 1 : 0;
    case LeverKind::stopper:
        return windlass.stopper_closed ? 1 : 0;
    case LeverKind::engine:
        return helm.engine;
    case LeverKind::rudder:
        return helm.rudder;
    }
    return 0;
}

std::string lever_words(const Lever& lever, bool two_sides) {
    const std::string side = lever.of_helm() || !two_sides        ? ""
                             : lever.side == exercise::Side::port ? "port "
                                                                  : "starboard ";
    switch (lever.kind) {
    case LeverKind::brake:
        return "the " + side + "wheel";
    case LeverKind::speed:
        return "the " + side + "speed lever";
    case LeverKind::clutch:
        return "the " + side + "clutch";
    case LeverKind::stopper:
        return "the " + side + "stopper";
    case LeverKind::engine:
        return "the engine";
    case LeverKind::rudder:
        return "the rudder";
    }
    return "";
}

std::string value_words(const Lever& lever, double value) {
    const double percent = 0.1 * std::round(1000 * std::abs(value));
    switch (lever.kind) {
    case LeverKind::brake:
        return value >= 0.995   ? "hard on"
               : value <= 0.005 ? "wide open"
                                : fmt::format("{:.3g} % on", percent);
    case LeverKind::speed:
        return percent == 0 ? "at stop" : fmt::format("{:.3g} % {}", percent, value > 0 ? "heave" : "lower");
    case LeverKind::clutch:
        return value > 0.5 ? "in gear" : "out of gear";
    case LeverKind::stopper:
        return value > 0.5 ? "closed" : "off";
    case LeverKind::engine:
        return percent == 0 ? "stopped" : fmt::format("{:.3g} % {}", percent, value > 0 ? "ahead" : "astern");
    case LeverKind::rudder:
        return fmt::format("{:.0f} deg to {}", physics::degrees_from_radians(std::abs(value)),
                           value >= 0 ? "starboard" : "port");
    }
    return "";
}

} // namespace windlass::assess
