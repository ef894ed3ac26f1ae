#pragma once
// The types of the topic table, for what has to be compiled once for each: WINDLASS_TOPIC_TYPES(DO).

// clang-format off
#define WINDLASS_TOPIC_TYPES(DO)                                                                             \
    DO(ExerciseStatus) DO(ShipState) DO(AnchorState) DO(ChainState) DO(WindlassLoad) DO(CableForce)          \
    DO(Event) DO(Alert) DO(Assessment) DO(Checkpoint) DO(OrderTaken)                                         \
    DO(WindlassCommand) DO(HelmCommand) DO(OwnShipInput)                                                     \
    DO(ExerciseCommand) DO(RestoreCommand) DO(FaultCommand) DO(Report) DO(AlertCommand)                      \
    DO(ReplayStatus) DO(ReplayCommand)                                                                       \
    DO(ClassroomStatus) DO(ClassroomCommand)
// clang-format on
