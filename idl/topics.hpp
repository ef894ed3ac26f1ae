#pragma once
// The topic table in code. The same table for people and for foreign clients is topics.md; a test
// compares the two.

#include "idl/types.hpp"

#include <array>
#include <string>

namespace windlass::wire {

/// One row of the topic table: what both ends of a topic must agree on.
struct TopicInfo {
    const char* name; ///< of the topic
    const char* type; ///< windlass::vN::<type>, N being the wire's version
    bool from_server; ///< true: server -> all; false: clients -> server
    double rate;      ///< Hz at time scale 1; 0: when something changes
    bool keyed = false;
    bool reliable = false;
    bool transient_local = false; ///< a late joiner gets the kept samples
    int depth = 4;                ///< KEEP_LAST, of each instance
    int instances = 1;            ///< most instances (keys) that are kept
    bool exclusive = false;       ///< the writer with the highest ownership strength is heard
    double deadline = 0;          ///< s between samples, after which ownership falls back; 0: none
};

/// A row that knows its type.
template <class T>
struct Topic : TopicInfo {};

/// The IDL's name of a type of this version ("ShipState"), as it goes over the wire and stands in recordings.
inline std::string type_name(const std::string& type) {
    return "windlass::v" + std::to_string(WIRE_VERSION) + "::" + type;
}
/// Of a row's type.
inline std::string type_name(const TopicInfo& info) {
    return type_name(info.type);
}

namespace topics {

/// s of silence after which a weaker hand's word counts, and nobody's hand is shown any more. Only one who
/// speaks gains by it: a hand that is alone is given up later (common/hand_silence.hpp).
inline constexpr double kCommandDeadline = 1;

/// Long enough for a sample that is late at 10 Hz.
inline constexpr double kShipDeadline = 0.2;

// Streams: the newest sample is the only one of interest.
inline constexpr Topic<ShipState> ship_state{
    {.name = "ShipState", .type = "ShipState", .from_server = true, .rate = 60}};
inline constexpr Topic<AnchorState> anchor_state{{.name = "AnchorState",
                                                  .type = "AnchorState",
                                                  .from_server = true,
                                                  .rate = 60,
                                                  .keyed = true,
                                                  .instances = 2}};
inline constexpr Topic<ChainState> chain_state{{.name = "ChainState",
                                                .type = "ChainState",
                                                .from_server = true,
                                                .rate = 60,
                                                .keyed = true,
                                                .instances = 2}};
inline constexpr Topic<WindlassLoad> windlass_load{{.name = "WindlassLoad",
                                                    .type = "WindlassLoad",
                                                    .from_server = true,
                                                    .rate = 100,
                                                    .keyed = true,
                                                    .instances = 2}};
inline constexpr Topic<CableForce> cable_force{
    {.name = "CableForce", .type = "CableForce", .from_server = true, .rate = 60}};
inline constexpr Topic<ForecastleView> forecastle_view{{.name = "ForecastleView",
                                                        .type = "ForecastleView",
                                                        .from_server = true,
                                                        .rate = 30,
                                                        .keyed = true,
                                                        .instances = 2}};
inline constexpr Topic<ForecastleView> forecastle_camera{{.name = "ForecastleCamera",
                                                          .type = "ForecastleView",
                                                          .from_server = true,
                                                          .rate = 10,
                                                          .keyed = true,
                                                          .instances = 2}};
inline constexpr Topic<BridgeView> bridge_view{
    {.name = "BridgeView", .type = "BridgeView", .from_server = true, .rate = 10}};

// State and log: nothing is lost, and a late joiner sees what stands.
inline constexpr Topic<ExerciseStatus> exercise_status{{.name = "ExerciseStatus",
                                                        .type = "ExerciseStatus",
                                                        .from_server = true,
                                                        .rate = 5,
                                                        .reliable = true,
                                                        .transient_local = true,
                                                        .depth = 1}};
inline constexpr Topic<ExerciseTruth> exercise_truth{{.name = "ExerciseTruth",
                                                      .type = "ExerciseTruth",
                                                      .from_server = true,
                                                      .rate = 5,
                                                      .reliable = true,
                                                      .transient_local = true,
                                                      .depth = 1}};
inline constexpr Topic<EnvironmentState> environment_state{{.name = "EnvironmentState",
                                                            .type = "EnvironmentState",
                                                            .from_server = true,
                                                            .rate = 5,
                                                            .reliable = true,
                                                            .transient_local = true,
                                                            .depth = 1}};
inline constexpr Topic<Daylight> daylight{{.name = "Daylight",
                                           .type = "Daylight",
                                           .from_server = true,
                                           .rate = 5,
                                           .reliable = true,
                                           .transient_local = true,
                                           .depth = 1}};
inline constexpr Topic<LightsAndShapes> lights_and_shapes{{.name = "LightsAndShapes",
                                                           .type = "LightsAndShapes",
                                                           .from_server = true,
                                                           .rate = 5,
                                                           .reliable = true,
                                                           .transient_local = true,
                                                           .depth = 1}};
inline constexpr Topic<SeaState> sea_state{{.name = "SeaState",
                                            .type = "SeaState",
                                            .from_server = true,
                                            .rate = 0,
                                            .reliable = true,
                                            .transient_local = true,
                                            .depth = 1}};
inline constexpr Topic<SceneDescription> scene_description{{.name = "SceneDescription",
                                                            .type = "SceneDescription",
                                                            .from_server = true,
                                                            .rate = 0,
                                                            .reliable = true,
                                                            .transient_local = true,
                                                            .depth = 1}};
inline constexpr Topic<SeabedDescription> seabed_description{{.name = "SeabedDescription",
                                                              .type = "SeabedDescription",
                                                              .from_server = true,
                                                              .rate = 0,
                                                              .reliable = true,
                                                              .transient_local = true,
                                                              .depth = 1}};
inline constexpr Topic<Chart> chart{{.name = "Chart",
                                     .type = "Chart",
                                     .from_server = true,
                                     .rate = 0,
                                     .reliable = true,
                                     .transient_local = true,
                                     .depth = 1}};
inline constexpr Topic<Landmarks> landmarks{{.name = "Landmarks",
                                             .type = "Landmarks",
                                             .from_server = true,
                                             .rate = 0,
                                             .reliable = true,
                                             .transient_local = true,
                                             .depth = 1}};
inline constexpr Topic<Event> event{{.name = "Event",
                                     .type = "Event",
                                     .from_server = true,
                                     .rate = 0,
                                     .reliable = true,
                                     .transient_local = true,
                                     .depth = 1000}};
/// What is noticed on the forecastle.
inline constexpr Topic<SeatEvent> forecastle_event{{.name = "ForecastleEvent",
                                                    .type = "SeatEvent",
                                                    .from_server = true,
                                                    .rate = 0,
                                                    .reliable = true,
                                                    .transient_local = true,
                                                    .depth = 1000}};
/// What is noticed on the bridge.
inline constexpr Topic<SeatEvent> bridge_event{{.name = "BridgeEvent",
                                                .type = "SeatEvent",
                                                .from_server = true,
                                                .rate = 0,
                                                .reliable = true,
                                                .transient_local = true,
                                                .depth = 1000}};
inline constexpr Topic<SeatEvent> forecastle_instruction{{.name = "ForecastleInstruction",
                                                          .type = "SeatEvent",
                                                          .from_server = true,
                                                          .rate = 0,
                                                          .reliable = true,
                                                          .transient_local = true,
                                                          .depth = 100}};
inline constexpr Topic<SeatEvent> bridge_instruction{{.name = "BridgeInstruction",
                                                      .type = "SeatEvent",
                                                      .from_server = true,
                                                      .rate = 0,
                                                      .reliable = true,
                                                      .transient_local = true,
                                                      .depth = 100}};
inline constexpr Topic<Question> forecastle_question{{.name = "ForecastleQuestion",
                                                      .type = "Question",
                                                      .from_server = true,
                                                      .rate = 0,
                                                      .reliable = true,
                                                      .transient_local = true,
                                                      .depth = 1}};
inline constexpr Topic<Question> bridge_question{{.name = "BridgeQuestion",
                                                  .type = "Question",
                                                  .from_server = true,
                                                  .rate = 0,
                                                  .reliable = true,
                                                  .transient_local = true,
                                                  .depth = 1}};
/// Of the lesson's model hands, what the seat's own levers and gauges would show; the rest is 0.
inline constexpr Topic<ForecastleView> forecastle_ghost{{.name = "ForecastleGhost",
                                                         .type = "ForecastleView",
                                                         .from_server = true,
                                                         .rate = 10,
                                                         .keyed = true,
                                                         .instances = 2}};
inline constexpr Topic<BridgeView> bridge_ghost{
    {.name = "BridgeGhost", .type = "BridgeView", .from_server = true, .rate = 10}};
/// Of the bridge's panel.
inline constexpr Topic<Alert> alert{{.name = "Alert",
                                     .type = "Alert",
                                     .from_server = true,
                                     .rate = 0,
                                     .keyed = true,
                                     .reliable = true,
                                     .transient_local = true,
                                     .depth = 1,
                                     .instances = 256}};
/// Of the forecastle's panel.
inline constexpr Topic<Alert> forecastle_alert{{.name = "ForecastleAlert",
                                                .type = "Alert",
                                                .from_server = true,
                                                .rate = 0,
                                                .keyed = true,
                                                .reliable = true,
                                                .transient_local = true,
                                                .depth = 1,
                                                .instances = 64}};
/// For instructors alone: what no panel of a ship has.
inline constexpr Topic<Alert> server_alert{{.name = "ServerAlert",
                                            .type = "Alert",
                                            .from_server = true,
                                            .rate = 0,
                                            .keyed = true,
                                            .reliable = true,
                                            .transient_local = true,
                                            .depth = 1,
                                            .instances = 64}};
inline constexpr Topic<BridgeOrder> bridge_order{{.name = "BridgeOrder",
                                                  .type = "BridgeOrder",
                                                  .from_server = true,
                                                  .rate = 0,
                                                  .keyed = true,
                                                  .reliable = true,
                                                  .transient_local = true,
                                                  .depth = 1,
                                                  .instances = 1000}};
inline constexpr Topic<Assessment> assessment{{.name = "Assessment",
                                               .type = "Assessment",
                                               .from_server = true,
                                               .rate = 1,
                                               .reliable = true,
                                               .transient_local = true,
                                               .depth = 1}};
inline constexpr Topic<Assessment> seat_assessment{{.name = "SeatAssessment",
                                                    .type = "Assessment",
                                                    .from_server = true,
                                                    .rate = 0,
                                                    .reliable = true,
                                                    .transient_local = true,
                                                    .depth = 1}};
inline constexpr Topic<Prediction> prediction{{.name = "Prediction",
                                               .type = "Prediction",
                                               .from_server = true,
                                               .rate = 0,
                                               .reliable = true,
                                               .transient_local = true,
                                               .depth = 1}};
inline constexpr Topic<Checkpoint> checkpoint{{.name = "Checkpoint",
                                               .type = "Checkpoint",
                                               .from_server = true,
                                               .rate = 0,
                                               .reliable = true,
                                               .transient_local = true,
                                               .depth = 1}};
inline constexpr Topic<OrderTaken> order_taken{{.name = "OrderTaken",
                                                .type = "OrderTaken",
                                                .from_server = true,
                                                .rate = 0,
                                                .reliable = true,
                                                .transient_local = true,
                                                .depth = 1000}};

// Levers: resent at 10 Hz or more while a client holds them. An instructor's go out on topics of their own,
// which no trainee may write and the server prefers; strength decides among equals only.
inline constexpr Topic<WindlassCommand> windlass_command{{.name = "WindlassCommand",
                                                          .type = "WindlassCommand",
                                                          .from_server = false,
                                                          .rate = 10,
                                                          .keyed = true,
                                                          .reliable = true,
                                                          .depth = 8,
                                                          .instances = 2,
                                                          .exclusive = true,
                                                          .deadline = kCommandDeadline}};
inline constexpr Topic<WindlassCommand> instructor_windlass_command{{.name = "InstructorWindlassCommand",
                                                                     .type = "WindlassCommand",
                                                                     .from_server = false,
                                                                     .rate = 10,
                                                                     .keyed = true,
                                                                     .reliable = true,
                                                                     .depth = 8,
                                                                     .instances = 2,
                                                                     .exclusive = true,
                                                                     .deadline = kCommandDeadline}};
inline constexpr Topic<HelmCommand> helm_command{{.name = "HelmCommand",
                                                  .type = "HelmCommand",
                                                  .from_server = false,
                                                  .rate = 10,
                                                  .reliable = true,
                                                  .depth = 8,
                                                  .exclusive = true,
                                                  .deadline = kCommandDeadline}};
inline constexpr Topic<HelmCommand> instructor_helm_command{{.name = "InstructorHelmCommand",
                                                             .type = "HelmCommand",
                                                             .from_server = false,
                                                             .rate = 10,
                                                             .reliable = true,
                                                             .depth = 8,
                                                             .exclusive = true,
                                                             .deadline = kCommandDeadline}};
inline constexpr Topic<OwnShipInput> own_ship_input{{.name = "OwnShipInput",
                                                     .type = "OwnShipInput",
                                                     .from_server = false,
                                                     .rate = 60,
                                                     .exclusive = true,
                                                     .deadline = kShipDeadline}};

// Orders: each is given once and none may be lost.
inline constexpr Topic<ExerciseCommand> exercise_command{{.name = "ExerciseCommand",
                                                          .type = "ExerciseCommand",
                                                          .from_server = false,
                                                          .rate = 0,
                                                          .reliable = true,
                                                          .depth = 64}};
inline constexpr Topic<EnvironmentCommand> environment_command{{.name = "EnvironmentCommand",
                                                                .type = "EnvironmentCommand",
                                                                .from_server = false,
                                                                .rate = 0,
                                                                .reliable = true,
                                                                .depth = 64}};
inline constexpr Topic<FaultCommand> fault_command{{.name = "FaultCommand",
                                                    .type = "FaultCommand",
                                                    .from_server = false,
                                                    .rate = 0,
                                                    .reliable = true,
                                                    .depth = 64}};
inline constexpr Topic<Report> report{
    {.name = "Report", .type = "Report", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};
inline constexpr Topic<BridgeOrderCommand> bridge_order_command{{.name = "BridgeOrderCommand",
                                                                 .type = "BridgeOrderCommand",
                                                                 .from_server = false,
                                                                 .rate = 0,
                                                                 .reliable = true,
                                                                 .depth = 64}};
inline constexpr Topic<WatchCircle> watch_circle{{.name = "WatchCircle",
                                                  .type = "WatchCircle",
                                                  .from_server = false,
                                                  .rate = 0,
                                                  .reliable = true,
                                                  .depth = 64}};
inline constexpr Topic<LightsAndShapesCommand> lights_and_shapes_command{{.name = "LightsAndShapesCommand",
                                                                          .type = "LightsAndShapesCommand",
                                                                          .from_server = false,
                                                                          .rate = 0,
                                                                          .reliable = true,
                                                                          .depth = 64}};
inline constexpr Topic<DeckWorkCommand> deck_work_command{{.name = "DeckWorkCommand",
                                                           .type = "DeckWorkCommand",
                                                           .from_server = false,
                                                           .rate = 0,
                                                           .reliable = true,
                                                           .depth = 64}};
inline constexpr Topic<Answer> forecastle_answer{{.name = "ForecastleAnswer",
                                                  .type = "Answer",
                                                  .from_server = false,
                                                  .rate = 0,
                                                  .reliable = true,
                                                  .depth = 64}};
inline constexpr Topic<Answer> bridge_answer{{.name = "BridgeAnswer",
                                              .type = "Answer",
                                              .from_server = false,
                                              .rate = 0,
                                              .reliable = true,
                                              .depth = 64}};
inline constexpr Topic<AlertCommand> alert_command{{.name = "AlertCommand",
                                                    .type = "AlertCommand",
                                                    .from_server = false,
                                                    .rate = 0,
                                                    .reliable = true,
                                                    .depth = 64}};
inline constexpr Topic<AssessmentCommand> assessment_command{{.name = "AssessmentCommand",
                                                              .type = "AssessmentCommand",
                                                              .from_server = false,
                                                              .rate = 0,
                                                              .reliable = true,
                                                              .depth = 64}};
inline constexpr Topic<RestoreCommand> restore_command{{.name = "RestoreCommand",
                                                        .type = "RestoreCommand",
                                                        .from_server = false,
                                                        .rate = 0,
                                                        .reliable = true,
                                                        .depth = 2}};

// A replay stands in for the server: its state, and what it is asked to do.
inline constexpr Topic<ReplayStatus> replay_status{{.name = "ReplayStatus",
                                                    .type = "ReplayStatus",
                                                    .from_server = true,
                                                    .rate = 5,
                                                    .reliable = true,
                                                    .transient_local = true,
                                                    .depth = 1}};
inline constexpr Topic<ReplayCommand> replay_command{{.name = "ReplayCommand",
                                                      .type = "ReplayCommand",
                                                      .from_server = false,
                                                      .rate = 0,
                                                      .reliable = true,
                                                      .depth = 64}};

// In partition "classroom": the servers of a domain, and what exercises they have.
inline constexpr Topic<ClassroomStatus> classroom_status{{.name = "ClassroomStatus",
                                                          .type = "ClassroomStatus",
                                                          .from_server = true,
                                                          .rate = 1,
                                                          .keyed = true,
                                                          .reliable = true,
                                                          .transient_local = true,
                                                          .depth = 1,
                                                          .instances = 64}};
inline constexpr Topic<ClassroomCommand> classroom_command{{.name = "ClassroomCommand",
                                                            .type = "ClassroomCommand",
                                                            .from_server = false,
                                                            .rate = 0,
                                                            .reliable = true,
                                                            .depth = 8}};

/// The rows of partition "classroom", besides Event, in the order of topics.md.
inline constexpr std::array<TopicInfo, 2> classroom{classroom_status, classroom_command};

/// Every row of an exercise's partition, in the order of topics.md.
inline constexpr std::array<TopicInfo, 56> all{exercise_status,
                                               exercise_truth,
                                               environment_state,
                                               ship_state,
                                               anchor_state,
                                               chain_state,
                                               windlass_load,
                                               cable_force,
                                               forecastle_view,
                                               forecastle_camera,
                                               bridge_view,
                                               daylight,
                                               lights_and_shapes,
                                               sea_state,
                                               scene_description,
                                               seabed_description,
                                               chart,
                                               landmarks,
                                               event,
                                               forecastle_event,
                                               bridge_event,
                                               forecastle_instruction,
                                               bridge_instruction,
                                               forecastle_question,
                                               bridge_question,
                                               forecastle_ghost,
                                               bridge_ghost,
                                               alert,
                                               forecastle_alert,
                                               server_alert,
                                               bridge_order,
                                               assessment,
                                               seat_assessment,
                                               prediction,
                                               checkpoint,
                                               order_taken,
                                               windlass_command,
                                               instructor_windlass_command,
                                               helm_command,
                                               instructor_helm_command,
                                               own_ship_input,
                                               exercise_command,
                                               environment_command,
                                               restore_command,
                                               fault_command,
                                               report,
                                               bridge_order_command,
                                               watch_circle,
                                               lights_and_shapes_command,
                                               deck_work_command,
                                               forecastle_answer,
                                               bridge_answer,
                                               alert_command,
                                               assessment_command,
                                               replay_status,
                                               replay_command};

} // namespace topics
} // namespace windlass::wire
