#include "recorder/replay/orders.hpp"

#include "recorder/replay/playhead.hpp"

#include <fmt/format.h>

namespace windlass::recorder {

namespace {

struct Range {
    double low, high;
    const char* unit;
};

std::optional<Range> range_of(ReplayAction action, double duration) {
    switch (action) {
    case REPLAY_SEEK:
        return Range{0, duration, " s"};
    case REPLAY_SPEED:
        return Range{Playhead::kSlowest, Playhead::kFastest, ""};
    case REPLAY_LOOP:
        return Range{0, 1, ""};
    default:
        return std::nullopt;
    }
}

} // namespace

std::optional<std::string> OrderCheck::refusal(const ReplayCommand& command, const wire::WriterId& writer,
                                               double duration) {
    const std::string source = command.origin().source().to_string();
    const auto refuse = [&](const std::string& field, const std::string& value, const std::string& allowed) {
        return fmt::format("ReplayCommand from {}: {} = {} refused; allowed: {}", source, field, value,
                           allowed);
    };
    const auto action = static_cast<std::uint32_t>(command.action());
    if (action > REPLAY_STOP)
        return refuse("action", std::to_string(action), fmt::format("0..{}", static_cast<int>(REPLAY_STOP)));
    if (const auto range = range_of(command.action(), duration))
        if (!(command.value() >= range->low && command.value() <= range->high)) // NaN is neither
            return refuse("value", fmt::format("{}", command.value()),
                          fmt::format("{:g}..{:g}{}", range->low, range->high, range->unit));

    constexpr std::size_t kMaxSenders = 256; // of a flood of names, all begin anew
    if (serials_.size() > kMaxSenders) serials_.clear();
    auto& last = serials_[{writer, source}];
    if (command.origin().serial() <= last)
        return refuse("origin.serial", std::to_string(command.origin().serial()),
                      "above " + std::to_string(last));
    last = command.origin().serial();
    return std::nullopt;
}

} // namespace windlass::recorder
