/* A foreign ship over Cyclone DDS: sails the ship of an exercise, and feels her cables.
 *
 *     CYCLONEDDS_URI=file://examples/cyclone_c/cyclonedds.xml own_ship DOMAIN PARTITION SECONDS
 *
 * Begins where the server has her, with the way that she has, and heaves her by 0.5 m in 10 s, so that it is
 * seen who moves her. The ship is a mass with a drag, which the cables hold back (CableForce); a bridge
 * simulator has its own model here. Prints how far the server's ship is off, where both speak of the same
 * instant. Exit codes: 0 she was followed to 0.2 m, 1 not, 2 bad arguments, 3 DDS did not start.
 */
#include "join.h"
#include "windlass.h"

#include <math.h>
#include <string.h>

enum { kSamplesPerSecond = 20, kStepsPerSample = 5, kStrength = 10 };
static const double kMass = 77e6 * 1.1, kDrag = 2e5, kPi = 3.14159265358979; /* kg, N s/m */
static const double kFollowed = 0.2;                                         /* m */

/* The newest sample that has come, into `to`, which is of the topic's type without sequences. False: none. */
static bool newest(dds_entity_t from, void* to, size_t size) {
    void* samples[1] = {NULL};
    dds_sample_info_t info[1];
    bool any = false;
    while (dds_take(from, samples, info, 1, 1) > 0) {
        if (info[0].valid_data) memcpy(to, samples[0], size);
        any = any || info[0].valid_data;
        dds_return_loan(from, samples, 1);
    }
    return any;
}

int main(int argc, char** argv) {
    if (argc != 4) {
        fprintf(stderr, "usage: own_ship DOMAIN PARTITION SECONDS\n");
        return 2;
    }
    const struct member member = join(argv[1], argv[2]);
    const int seconds = atoi(argv[3]);
    const dds_entity_t states = reader(&member, "ShipState", &windlass_v12_ShipState_desc, false, false, 1);
    const dds_entity_t forces = reader(&member, "CableForce", &windlass_v12_CableForce_desc, false, false, 1);
    const dds_entity_t writer =
        exclusive_writer(&member, "OwnShipInput", &windlass_v12_OwnShipInput_desc, false, kStrength);

    windlass_v12_ShipState shown;
    memset(&shown, 0, sizeof shown);
    const dds_time_t patience = dds_time() + DDS_SECS(20);
    while (!newest(states, &shown, sizeof shown) && dds_time() < patience)
        dds_sleepfor(DDS_MSECS(5));
    if (shown.tick == 0) {
        fprintf(stderr, "own_ship: no ship is heard\n");
        return 1;
    }

    windlass_v12_OwnShipInput ship;
    memset(&ship, 0, sizeof ship);
    strcpy(ship.origin.source, "ship");
    ship.position = shown.position;
    ship.attitude = shown.attitude;
    ship.velocity = shown.velocity;
    /* The sequence of CableForce goes back with its loan: only the force is read. */
    windlass_v12_CableForce cables;
    memset(&cables, 0, sizeof cables);
    double off = INFINITY, largest = 0;
    const double dt = 1.0 / (kSamplesPerSecond * kStepsPerSample), heave_rate = 2 * kPi / 10;
    dds_time_t due = dds_time();
    for (int sample = 0; sample < seconds * kSamplesPerSecond; ++sample) {
        newest(forces, &cables, sizeof cables);
        for (int step = 0; step < kStepsPerSample; ++step) {
            ship.velocity.x += dt * (cables.force.x - kDrag * ship.velocity.x) / kMass;
            ship.velocity.y += dt * (cables.force.y - kDrag * ship.velocity.y) / kMass;
            ship.position.x += dt * ship.velocity.x;
            ship.position.y += dt * ship.velocity.y;
            ship.time += dt;
        }
        /* From rest: 0.5 m sin2 grows smoothly. */
        ship.position.z = 0.25 * (1 - cos(heave_rate * ship.time));
        ship.velocity.z = 0.25 * heave_rate * sin(heave_rate * ship.time);
        ++ship.origin.serial;
        ship.origin.sent_unix_ns = dds_time();
        dds_write(writer, &ship);
        largest = fmax(largest, hypot(cables.force.x, cables.force.y));
        due += DDS_SECS(1) / kSamplesPerSecond;
        const dds_time_t now = dds_time();
        if (due > now) dds_sleepfor(due - now);
        if (newest(states, &shown, sizeof shown)) {
            const double dx = shown.position.x - ship.position.x, dy = shown.position.y - ship.position.y;
            off = sqrt(dx * dx + dy * dy + pow(shown.position.z - ship.position.z, 2));
        }
    }
    printf("server's ship %.3f m off, heaved %.3f m of %.3f\n", off, shown.position.z, ship.position.z);
    printf("cables %.0f N at most\n", largest);
    dds_delete(member.participant);
    return off < kFollowed ? 0 : 1;
}
