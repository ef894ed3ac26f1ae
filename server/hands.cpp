#include "server/hands.hpp"

#include <utility>

namespace windlass::server {

const char* name(Levers levers) {
    switch (levers) {
    case Levers::port_windlass:
        return "port windlass";
    case Levers::starboard_windlass:
        return "starboard windlass";
    case Levers::helm:
        return "helm";
    }
    return "unknown levers";
}

std::optional<Levers> Hands::levers_of(const exercise::Command& command) {
    if (const auto* order = std::get_if<exercise::WindlassOrder>(&command)) {
        return order->side == exercise::Side::port ? Levers::port_windlass : Levers::starboard_windlass;
    }
    if (std::holds_alternative<exercise::HelmOrder>(command)) return Levers::helm;
    return std::nullopt;
}

std::optional<std::string> Hands::take(Levers levers, const std::string& source, double now) {
    Hand& held = hand(levers);
    held.heard = now;
    if (held.source == source) return std::nullopt;
    return std::exchange(held.source, source);
}

std::optional<std::string> Hands::gone(Levers levers, double now) {
    Hand& held = hand(levers);
    if (held.source.empty() || now - held.heard <= kHandGone) return std::nullopt;
    return std::exchange(held.source, {});
}

} // namespace windlass::server
