#include "server/run/lever_ownership.hpp"

#include <utility>

namespace windlass::server {

const char* name(LeverGroup levers) {
    switch (levers) {
    case LeverGroup::port_windlass:
        return "port windlass";
    case LeverGroup::starboard_windlass:
        return "starboard windlass";
    case LeverGroup::helm:
        return "helm";
    }
    return "unknown levers";
}

std::optional<LeverGroup> LeverOwnership::levers_of(const exercise::Order& command) {
    if (const auto* order = std::get_if<exercise::WindlassOrder>(&command)) {
        return order->side == exercise::Side::port ? LeverGroup::port_windlass
                                                   : LeverGroup::starboard_windlass;
    }
    if (std::holds_alternative<exercise::HelmOrder>(command)) return LeverGroup::helm;
    return std::nullopt;
}

std::optional<std::string> LeverOwnership::take(LeverGroup levers, const std::string& source, bool instructor,
                                                double now) {
    Owner& held = owner(levers);
    const bool instructors = held.instructor && !held.source.empty() && now - held.heard <= kInstructorSilent;
    if (instructors && !instructor) return std::nullopt;
    held.heard = now;
    held.instructor = instructor;
    return std::exchange(held.source, source);
}

std::optional<std::string> LeverOwnership::gone(LeverGroup levers, double now) {
    Owner& held = owner(levers);
    if (held.source.empty() || now - held.heard <= kOwnerGone) return std::nullopt;
    return std::exchange(held.source, {});
}

} // namespace windlass::server
