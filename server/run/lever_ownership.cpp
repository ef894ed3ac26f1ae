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

bool LeverOwnership::heard(LeverGroup levers, bool instructor, double now) const {
    const Owner& owner = owners_[static_cast<std::size_t>(levers)];
    return instructor || !owner.instructor || owner.source.empty() || now - owner.heard > kInstructorSilent;
}

std::optional<std::string> LeverOwnership::take(LeverGroup levers, const std::string& source, bool instructor,
                                                double now) {
    Owner& held = owner(levers);
    held.heard = now;
    held.instructor = instructor;
    if (held.source == source) return std::nullopt;
    return std::exchange(held.source, source);
}

std::optional<std::string> LeverOwnership::gone(LeverGroup levers, double now) {
    Owner& held = owner(levers);
    if (held.source.empty() || now - held.heard <= kOwnerGone) return std::nullopt;
    return std::exchange(held.source, {});
}

} // namespace windlass::server
