#include "server/run/lever_ownership.hpp"

#include <algorithm>
#include <utility>

namespace windlass::run {

namespace {

/// s that the next hand is waited for when one has let go or is given up: it speaks each 0.05 s.
constexpr double kNextHand = 0.2;

} // namespace

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

std::optional<LeverOwnership::Hand> LeverOwnership::take(LeverGroup levers, const ReceivedOrder& from) {
    Owner& held = owner(levers);
    const bool instructors = held.instructor && !held.source.empty() && now_ <= held.given_up_at();
    if (instructors && !from.instructor) return std::nullopt;
    // DDS may tell of a writer's end before its last word is taken: that word does not bring it back.
    const bool late = held.left && held.writer == from.writer;
    const bool let_go = held.let_go() && held.instructor && !from.instructor;
    const bool goes_on = held.source == from.source && held.instructor == from.instructor;
    held.found_free = held.source.empty() || (goes_on && held.found_free);
    held.heard = now_;
    held.writer = from.writer;
    held.instructor = from.instructor;
    if (!late) held.left.reset();
    return Hand{.source = std::exchange(held.source, from.source), .let_go = let_go};
}

void LeverOwnership::leave(const WriterKey& writer) {
    for (Owner& held : owners_)
        if (held.writer == writer && !held.left) held.left = now_;
}

void LeverOwnership::come(const WriterKey& writer) {
    for (Owner& held : owners_)
        if (held.writer == writer) held.left.reset();
}

std::optional<LeverOwnership::Hand> LeverOwnership::gone(LeverGroup levers) {
    Owner& held = owner(levers);
    if (held.source.empty() || now_ <= held.given_up_at() + kNextHand) return std::nullopt;
    return Hand{std::exchange(held.source, {}), held.let_go(), held.instructor, held.found_free};
}

bool LeverOwnership::is_elsewhere(LeverGroup levers, const std::string& source) const {
    return std::ranges::any_of(kAllLeverGroups, [&](LeverGroup other) {
        const Owner& held = owners_[static_cast<std::size_t>(other)];
        const bool other_place = (other == LeverGroup::helm) != (levers == LeverGroup::helm);
        return other_place && held.source == source && !held.left && now_ <= held.given_up_at();
    });
}

double LeverOwnership::longest_silence() const {
    double longest = 0;
    for (const Owner& held : owners_)
        if (!held.source.empty()) longest = std::max(longest, now_ - held.heard);
    return longest;
}

} // namespace windlass::run
