#pragma once
// What a replay is asked to do: checked before it is done.

#include "idl/wire.hpp"

#include <map>
#include <optional>

namespace windlass::recorder {

/// Keeps the serials of those who ask, so that what is old or comes twice is refused.
class OrderCheck {
public:
    /// Nothing when the command may be carried out; otherwise topic, sender, field, value and what is
    /// allowed. duration in s, of the recording.
    std::optional<std::string> refusal(const ReplayCommand& command, const wire::WriterId& writer,
                                       double duration);

private:
    std::map<std::pair<wire::WriterId, std::string>, std::uint64_t> serials_;
};

} // namespace windlass::recorder
