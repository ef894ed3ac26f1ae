#pragma once
// The picture as JSON for machines: SI and radians as on the wire; the keys are the names of windlass.idl.

#include "station/picture.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::station {

nlohmann::json to_json(const ExerciseStatus& status);
nlohmann::json to_json(const ExerciseTruth& truth);
nlohmann::json to_json(const EnvironmentState& environment);
nlohmann::json to_json(const FaultStatus& fault);
nlohmann::json to_json(const Alert& alert);
nlohmann::json to_json(const BridgeOrder& order);
nlohmann::json to_json(const Event& event);     ///< its code as "event"
nlohmann::json to_json(const SeatEvent& event); ///< its code as "seat_event"

/// Status, views and truth, by side where a topic is, in one object; a topic that is not heard is left out.
/// silence is in seconds.
nlohmann::json to_json(const Picture& picture, Clock::time_point now);

} // namespace windlass::station
