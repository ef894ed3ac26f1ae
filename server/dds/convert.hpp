#pragma once
// Snapshot -> IDL types. Fields go by their names (wire_fields.hpp); what is computed here (shackles,
// utilisation, angles from the attitude) is plain arithmetic on one field's neighbours. Reuses the memory of
// the target.

#include "server/assess/result.hpp"
#include "server/run/prediction.hpp"
#include "server/run/status.hpp"

#include "idl/types.hpp"

namespace windlass::dds {

void convert(const exercise::Snapshot& from, const run::RunStatus& run, ExerciseStatus& to);
void convert(const exercise::Snapshot& from, const run::RunStatus& run, ExerciseTruth& to);
void convert(const exercise::Snapshot& from, EnvironmentState& to);
void convert(const exercise::Snapshot& from, ShipState& to);
void convert(const exercise::Snapshot& from, CableForce& to);
void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, AnchorState& to);
void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, ChainState& to);
void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, WindlassLoad& to);
void convert(const exercise::ExerciseEvent& from, Event& to);
void convert(const run::AlertView& from, Alert& to);
void convert(const run::CheckpointView& from, Checkpoint& to);
void convert(const run::QuestionView& from, Question& to);
void convert(const run::PredictionView& from, Prediction& to);
void convert(const assess::Result& from, Assessment& to);
void convert(const exercise::BridgeOrderView& from, std::uint64_t run, BridgeOrder& to);

} // namespace windlass::dds
