/* A client of Windlass in C over Cyclone DDS: hears what a bridge simulator may hear and works the port
 * windlass.
 *
 *     CYCLONEDDS_URI=file://examples/cyclone_c/cyclonedds.xml \
 *         bridge_client DOMAIN PARTITION SECONDS BRAKE SPEED
 *
 * Holds the port windlass's hand-wheel at BRAKE (0 open..1 hard on) and its speed lever at SPEED (-1 full
 * lower..1 full heave) for so many seconds, with a trainee's strength. Prints how many samples of each topic
 * came, the last brake position and lever that the server showed, and the last force of each cable on the
 * ship. Exit codes: 0 every topic was heard that always comes, 1 not, 2 bad arguments, 3 DDS did not start.
 *
 * The names of the types have the version of the wire in them (windlass::v12::ShipState, here
 * windlass_v12_ShipState): made from the IDL of another version, this client would meet nobody.
 */
#include "join.h"
#include "windlass.h"

#include <string.h>

enum { kDepth = 8, kTrainee = 10, kSides = 2 };

/* As in idl/topics.md. A reader may ask for less than the writer offers. */
struct heard {
    const char* name;
    const dds_topic_descriptor_t* type;
    bool reliable;
    bool always; /* comes in every exercise; the others when something happens */
    dds_entity_t reader;
    long count;
};

static struct heard topics[] = {
    {"ExerciseStatus", &windlass_v12_ExerciseStatus_desc, true, true, 0, 0},
    {"EnvironmentState", &windlass_v12_EnvironmentState_desc, true, true, 0, 0},
    {"SceneDescription", &windlass_v12_SceneDescription_desc, true, true, 0, 0},
    {"ShipState", &windlass_v12_ShipState_desc, false, true, 0, 0},
    {"AnchorState", &windlass_v12_AnchorState_desc, false, true, 0, 0},
    {"ChainState", &windlass_v12_ChainState_desc, false, true, 0, 0},
    {"WindlassLoad", &windlass_v12_WindlassLoad_desc, false, true, 0, 0},
    {"CableForce", &windlass_v12_CableForce_desc, false, true, 0, 0},
    {"BridgeView", &windlass_v12_BridgeView_desc, false, true, 0, 0},
    {"BridgeEvent", &windlass_v12_SeatEvent_desc, true, false, 0, 0},
    {"BridgeOrder", &windlass_v12_BridgeOrder_desc, true, false, 0, 0},
    {"Alert", &windlass_v12_Alert_desc, true, false, 0, 0},
};
enum { kTopics = sizeof topics / sizeof *topics };

/* What is shown at the end. */
struct shown {
    double brake, speed_lever;             /* of the port windlass */
    windlass_v12_Vec3 force, hawse[kSides]; /* N, of all cables and of each */
};

static void show_load(const windlass_v12_WindlassLoad* load, struct shown* shown) {
    if (load->side != windlass_v12_SIDE_PORT) return;
    shown->brake = load->brake_position;
    shown->speed_lever = load->speed_lever;
}

/* The sequence is the middleware's, and gone with its loan: what is needed of it is copied. */
static void show_force(const windlass_v12_CableForce* cables, struct shown* shown) {
    shown->force = cables->force;
    for (uint32_t i = 0; i < cables->hawse._length; ++i) {
        const windlass_v12_HawseForce* hawse = &cables->hawse._buffer[i];
        if (hawse->side >= 0 && hawse->side < kSides) shown->hawse[hawse->side] = hawse->force;
    }
}

/* Takes all that has come. */
static void take(struct heard* topic, struct shown* shown) {
    void* samples[kDepth] = {NULL};
    dds_sample_info_t info[kDepth];
    const int taken = dds_take(topic->reader, samples, info, kDepth, kDepth);
    for (int i = 0; i < taken; ++i) {
        if (!info[i].valid_data) continue;
        ++topic->count;
        if (strcmp(topic->name, "WindlassLoad") == 0) show_load(samples[i], shown);
        if (strcmp(topic->name, "CableForce") == 0) show_force(samples[i], shown);
    }
    if (taken > 0) dds_return_loan(topic->reader, samples, taken);
}

static void print_force(const char* of, const windlass_v12_Vec3* force) {
    printf("%s force %.0f %.0f %.0f N\n", of, force->x, force->y, force->z);
}

int main(int argc, char** argv) {
    if (argc != 6) {
        fprintf(stderr, "usage: bridge_client DOMAIN PARTITION SECONDS BRAKE SPEED\n");
        return 2;
    }
    const struct member member = join(argv[1], argv[2]);
    const double seconds = strtod(argv[3], NULL);
    for (int i = 0; i < kTopics; ++i) /* what is reliable is also kept */
        topics[i].reader =
            reader(&member, topics[i].name, topics[i].type, topics[i].reliable, topics[i].reliable, kDepth);
    const dds_entity_t writer =
        exclusive_writer(&member, "WindlassCommand", &windlass_v12_WindlassCommand_desc, true, kTrainee);

    windlass_v12_WindlassCommand command;
    memset(&command, 0, sizeof command);
    command.side = windlass_v12_SIDE_PORT;
    strcpy(command.origin.source, "bridge");
    command.brake = strtod(argv[4], NULL);
    command.speed_lever = strtod(argv[5], NULL);
    struct shown shown;
    memset(&shown, 0, sizeof shown);

    const dds_time_t end = dds_time() + (dds_time_t)(seconds * 1e9);
    dds_time_t word = 0;
    while (dds_time() < end) {
        if (dds_time() >= word) { /* the levers are held by speaking: 20 times a second */
            ++command.origin.serial;
            command.origin.sent_unix_ns = dds_time();
            dds_write(writer, &command);
            word = dds_time() + DDS_MSECS(50);
        }
        for (int i = 0; i < kTopics; ++i)
            take(&topics[i], &shown);
        dds_sleepfor(DDS_MSECS(5));
    }

    int missing = 0;
    for (int i = 0; i < kTopics; ++i) {
        printf("%-16s %ld\n", topics[i].name, topics[i].count);
        missing += topics[i].always && topics[i].count == 0;
    }
    printf("brake %.3f speed_lever %.3f\n", shown.brake, shown.speed_lever);
    print_force("port", &shown.hawse[windlass_v12_SIDE_PORT]);
    print_force("starboard", &shown.hawse[windlass_v12_SIDE_STARBOARD]);
    print_force("all", &shown.force);
    dds_delete(member.participant);
    return missing == 0 ? 0 : 1;
}
