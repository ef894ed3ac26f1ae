#pragma once
// The topic table in code. The same table for people and for foreign clients is topics.md; a test
// compares the two.

#include <windlass.h>

#include <array>

namespace windlass::wire {

/// One row of the topic table: what both ends of a topic must agree on.
struct TopicInfo {
    const char* name; ///< of the topic; the type is windlass::<name>
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

namespace topics {

/// Long enough for a sample that is late at 10 Hz, and so short that the next client, which speaks up every
/// 0.05 s as ours do, has the levers within 0.3 s of the last word of the one that is gone.
inline constexpr double kCommandDeadline = 0.2;

// Streams: the newest sample is the only one of interest.
inline constexpr Topic<ShipState> ship_state{{.name = "ShipState", .from_server = true, .rate = 60}};
inline constexpr Topic<AnchorState> anchor_state{
    {.name = "AnchorState", .from_server = true, .rate = 60, .keyed = true, .instances = 2}};
inline constexpr Topic<ChainState> chain_state{
    {.name = "ChainState", .from_server = true, .rate = 60, .keyed = true, .instances = 2}};
inline constexpr Topic<WindlassLoad> windlass_load{
    {.name = "WindlassLoad", .from_server = true, .rate = 100, .keyed = true, .instances = 2}};
inline constexpr Topic<CableForce> cable_force{{.name = "CableForce", .from_server = true, .rate = 60}};

// State and log: nothing is lost, and a late joiner sees what stands.
inline constexpr Topic<ExerciseStatus> exercise_status{{.name = "ExerciseStatus",
                                                        .from_server = true,
                                                        .rate = 5,
                                                        .reliable = true,
                                                        .transient_local = true,
                                                        .depth = 1}};
inline constexpr Topic<Event> event{{.name = "Event",
                                     .from_server = true,
                                     .rate = 0,
                                     .reliable = true,
                                     .transient_local = true,
                                     .depth = 1000}};
inline constexpr Topic<Alert> alert{{.name = "Alert",
                                     .from_server = true,
                                     .rate = 0,
                                     .keyed = true,
                                     .reliable = true,
                                     .transient_local = true,
                                     .depth = 1,
                                     .instances = 256}};
inline constexpr Topic<Assessment> assessment{{.name = "Assessment",
                                               .from_server = true,
                                               .rate = 1,
                                               .reliable = true,
                                               .transient_local = true,
                                               .depth = 1}};
inline constexpr Topic<Checkpoint> checkpoint{{.name = "Checkpoint",
                                               .from_server = true,
                                               .rate = 0,
                                               .reliable = true,
                                               .transient_local = true,
                                               .depth = 1}};

inline constexpr Topic<OrderTaken> order_taken{{.name = "OrderTaken",
                                                .from_server = true,
                                                .rate = 0,
                                                .reliable = true,
                                                .transient_local = true,
                                                .depth = 1000}};

// Levers: resent at 10 Hz or more while a client holds them; the strongest writer is heard.
inline constexpr Topic<WindlassCommand> windlass_command{{.name = "WindlassCommand",
                                                          .from_server = false,
                                                          .rate = 10,
                                                          .keyed = true,
                                                          .reliable = true,
                                                          .depth = 8,
                                                          .instances = 2,
                                                          .exclusive = true,
                                                          .deadline = kCommandDeadline}};
inline constexpr Topic<HelmCommand> helm_command{{.name = "HelmCommand",
                                                  .from_server = false,
                                                  .rate = 10,
                                                  .reliable = true,
                                                  .depth = 8,
                                                  .exclusive = true,
                                                  .deadline = kCommandDeadline}};
inline constexpr Topic<OwnShipInput> own_ship_input{{.name = "OwnShipInput",
                                                     .from_server = false,
                                                     .rate = 60,
                                                     .exclusive = true,
                                                     .deadline = kCommandDeadline}};

// Orders: each is given once and none may be lost.
inline constexpr Topic<ExerciseCommand> exercise_command{
    {.name = "ExerciseCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};
inline constexpr Topic<FaultCommand> fault_command{
    {.name = "FaultCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};
inline constexpr Topic<Report> report{
    {.name = "Report", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};
inline constexpr Topic<AlertCommand> alert_command{
    {.name = "AlertCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};
inline constexpr Topic<RestoreCommand> restore_command{
    {.name = "RestoreCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 2}};

// A replay stands in for the server: its state, and what it is asked to do.
inline constexpr Topic<ReplayStatus> replay_status{{.name = "ReplayStatus",
                                                    .from_server = true,
                                                    .rate = 5,
                                                    .reliable = true,
                                                    .transient_local = true,
                                                    .depth = 1}};
inline constexpr Topic<ReplayCommand> replay_command{
    {.name = "ReplayCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 64}};

// In partition "classroom": the servers of a domain, and what exercises they have.
inline constexpr Topic<ClassroomStatus> classroom_status{{.name = "ClassroomStatus",
                                                          .from_server = true,
                                                          .rate = 1,
                                                          .keyed = true,
                                                          .reliable = true,
                                                          .transient_local = true,
                                                          .depth = 1,
                                                          .instances = 64}};
inline constexpr Topic<ClassroomCommand> classroom_command{
    {.name = "ClassroomCommand", .from_server = false, .rate = 0, .reliable = true, .depth = 8}};

/// The rows of partition "classroom", besides Event, in the order of topics.md.
inline constexpr std::array<TopicInfo, 2> classroom{classroom_status, classroom_command};

/// Every row of an exercise's partition, in the order of topics.md.
inline constexpr std::array<TopicInfo, 21> all{
    exercise_status, ship_state,     anchor_state,     chain_state,     windlass_load, cable_force,
    event,           alert,          assessment,       checkpoint,      order_taken,   windlass_command,
    helm_command,    own_ship_input, exercise_command, restore_command, fault_command, report,
    alert_command,   replay_status,  replay_command};

} // namespace topics
} // namespace windlass::wire
