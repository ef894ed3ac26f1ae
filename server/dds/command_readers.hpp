#pragma once
// Command topics -> mailbox.

#include "server/dds/mailbox.hpp"

namespace windlass::server {

/// Hears every command topic and puts each sample into the mailbox, which must outlive it.
class CommandReaders {
public:
    /// Throws std::runtime_error when a reader cannot be made.
    CommandReaders(wire::Participant& participant, Mailbox& mailbox);

private:
    wire::Reader<WindlassCommand> windlass_;
    wire::Reader<HelmCommand> helm_;
    wire::Reader<ExerciseCommand> exercise_;
    wire::Reader<RestoreCommand> restore_;
    wire::Reader<FaultCommand> fault_;
    wire::Reader<Report> report_;
    wire::Reader<AlertCommand> alert_;
};

} // namespace windlass::server
