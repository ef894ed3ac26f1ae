#pragma once
// Command topics -> mailbox.

#include "server/dds/mailbox.hpp"

namespace windlass::dds {

/// Hears every command topic and puts each sample into the mailbox, which must outlive it.
class CommandReaders {
public:
    /// Throws std::runtime_error when a reader cannot be made.
    CommandReaders(wire::Participant& participant, Mailbox& mailbox);

private:
    wire::Reader<WindlassCommand> windlass_, instructor_windlass_;
    wire::Reader<HelmCommand> helm_, instructor_helm_;
    wire::Reader<OwnShipInput> own_ship_;
    wire::Reader<ExerciseCommand> exercise_;
    wire::Reader<EnvironmentCommand> environment_;
    wire::Reader<RestoreCommand> restore_;
    wire::Reader<FaultCommand> fault_;
    wire::Reader<Report> report_;
    wire::Reader<BridgeOrderCommand> bridge_order_;
    wire::Reader<WatchCircle> watch_circle_;
    wire::Reader<LightsAndShapesCommand> lights_and_shapes_;
    wire::Reader<DeckWorkCommand> deck_work_;
    wire::Reader<Answer> forecastle_answer_, bridge_answer_;
    wire::Reader<AlertCommand> alert_;
    wire::Reader<AssessmentCommand> assessment_;
};

} // namespace windlass::dds
