#pragma once
// What an instructor's pages need beside the wire: recordings, the debriefing, exercise files.

#include "station/gateway/gateway.hpp"
#include "station/options.hpp"

namespace windlass::console {

/// The gateway's options for instructors' pages. recordings and exercises: folders.
gateway::GatewayOptions instructor_pages(const station::SessionOptions& session,
                                         const std::filesystem::path& recordings,
                                         const std::filesystem::path& exercises);

} // namespace windlass::console
