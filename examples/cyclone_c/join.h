/* What every client of Windlass over Cyclone DDS begins with. */
#ifndef WINDLASS_EXAMPLE_JOIN_H
#define WINDLASS_EXAMPLE_JOIN_H

#include <dds/dds.h>

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

/* The entity, or the end of the program with exit code 3. */
static dds_entity_t must(dds_entity_t entity, const char *what) {
    if (entity < 0) {
        fprintf(stderr, "%s: %s\n", what, dds_strretcode(-entity));
        exit(3);
    }
    return entity;
}

/* In the partition of an exercise: a subscriber and a publisher. */
struct member {
    dds_entity_t participant, subscriber, publisher;
};

static struct member join(const char *domain, const char *exercise) {
    struct member made;
    char partition[128];
    snprintf(partition, sizeof partition, "exercise/%s", exercise);
    made.participant =
        must(dds_create_participant((dds_domainid_t)strtoul(domain, NULL, 10), NULL, NULL), "participant");
    dds_qos_t *group = dds_create_qos();
    const char *partitions[] = {partition};
    dds_qset_partition(group, 1, partitions);
    made.subscriber = must(dds_create_subscriber(made.participant, group, NULL), "subscriber");
    made.publisher = must(dds_create_publisher(made.participant, group, NULL), "publisher");
    dds_delete_qos(group);
    return made;
}

/* A reader with QoS as in idl/topics.md; it may ask for less than the writer offers. */
static dds_entity_t reader(const struct member *of, const char *name, const dds_topic_descriptor_t *type,
                           bool reliable, bool transient_local, int depth) {
    const dds_entity_t topic = must(dds_create_topic(of->participant, type, name, NULL, NULL), name);
    dds_qos_t *wanted = dds_create_qos();
    dds_qset_reliability(wanted, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_SECS(1));
    dds_qset_durability(wanted, transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
    dds_qset_history(wanted, DDS_HISTORY_KEEP_LAST, depth);
    const dds_entity_t made = must(dds_create_reader(of->subscriber, topic, wanted, NULL), name);
    dds_delete_qos(wanted);
    return made;
}

/* A writer of a topic that one hand has at a time: exclusive, with the shortest deadline of the
 * table. */
static dds_entity_t exclusive_writer(const struct member *of, const char *name, const dds_topic_descriptor_t *type,
                                     bool reliable, int strength) {
    const dds_entity_t topic = must(dds_create_topic(of->participant, type, name, NULL, NULL), name);
    dds_qos_t *offered = dds_create_qos();
    dds_qset_reliability(offered, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_SECS(1));
    dds_qset_ownership(offered, DDS_OWNERSHIP_EXCLUSIVE);
    dds_qset_ownership_strength(offered, strength);
    dds_qset_deadline(offered, DDS_MSECS(200));
    const dds_entity_t made = must(dds_create_writer(of->publisher, topic, offered, NULL), name);
    dds_delete_qos(offered);
    return made;
}

#endif
