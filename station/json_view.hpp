#pragma once
// The picture as JSON for machines: each sample as windlass.idl has it, SI and radians as on the wire,
// enumerators by name.

#include "station/picture.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::station {

/// Every field of a sample of a topic. Hashes are text: a reader that keeps numbers as doubles would lose the
/// last bits.
template <class Sample>
nlohmann::json to_json(const Sample& sample);

/// What the picture has, under "status", "truth", "environment", "ship", "bridge", "helm", "alerts" and
/// "orders", and under "port" and "starboard": "forecastle", "anchor", "chain", "windlass" and "levers".
/// "silence": s since the server was heard.
nlohmann::json to_json(const Picture& picture, Clock::time_point now);

} // namespace windlass::station
