#pragma once
// The picture as JSON for machines: SI and radians as on the wire; the keys are the names of windlass.idl.

#include "station/picture.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::station {

nlohmann::json to_json(const ExerciseStatus& status);
nlohmann::json to_json(const Event& event);
nlohmann::json to_json(const FaultStatus& fault);

/// Status, ship and both sides in one object; a topic not yet heard is left out. silence is in seconds.
nlohmann::json to_json(const Picture& picture, Clock::time_point now);

} // namespace windlass::station
