#pragma once
// The types of the topic table, for what has to be compiled once for each: WINDLASS_TOPIC_TYPES(DO).

// clang-format off
#define WINDLASS_TOPIC_TYPES(DO) \
    DO(ShipState) DO(AnchorState) DO(ChainState) DO(WindlassLoad) DO(CableForce) DO(ForecastleView) \
    DO(BridgeView) DO(Daylight) DO(LightsAndShapes) DO(ExerciseStatus) DO(ExerciseTruth) DO(EnvironmentState) DO(SeaState) \
    DO(SceneDescription) DO(SeabedDescription) DO(Chart) DO(Landmarks) DO(Event) DO(SeatEvent) DO(Question) DO(Answer) DO(Alert) \
    DO(BridgeOrder) DO(Assessment) DO(Prediction) DO(Checkpoint) DO(OrderTaken) DO(WindlassCommand) \
    DO(HelmCommand) DO(OwnShipInput) DO(ExerciseCommand) DO(EnvironmentCommand) DO(FaultCommand) \
    DO(Report) DO(BridgeOrderCommand) DO(WatchCircle) DO(LightsAndShapesCommand) DO(DeckWorkCommand) DO(AlertCommand) DO(AssessmentCommand) \
    DO(RestoreCommand) DO(ReplayStatus) DO(ReplayCommand) DO(ClassroomStatus) DO(ClassroomCommand)
// clang-format on
