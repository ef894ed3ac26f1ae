#pragma once

#include <cstdint>
#include <string>

namespace windlass::debrief {

/// ISO 8601 in UTC: "2026-11-22T15:04:05Z".
std::string iso_time(std::int64_t unix_ns);
/// For people: "2026-11-22 15:04:05 UTC".
std::string wall_time(std::int64_t unix_ns);
/// ISO 8601: "PT7M12.5S".
std::string iso_duration(double seconds);

} // namespace windlass::debrief
