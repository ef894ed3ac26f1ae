#include "server/dds/command_readers.hpp"

namespace windlass::server {

namespace {

template <class T>
wire::Reader<T> reader(wire::Participant& participant, const wire::Topic<T>& topic, Mailbox& mailbox) {
    return {participant, topic,
            [&mailbox](const T& sample, const wire::WriterId& writer) { mailbox.put(sample, writer); }};
}

} // namespace

CommandReaders::CommandReaders(wire::Participant& participant, Mailbox& mailbox)
    : windlass_(reader(participant, wire::topics::windlass_command, mailbox)),
      helm_(reader(participant, wire::topics::helm_command, mailbox)),
      exercise_(reader(participant, wire::topics::exercise_command, mailbox)),
      fault_(reader(participant, wire::topics::fault_command, mailbox)),
      report_(reader(participant, wire::topics::report, mailbox)),
      alert_(reader(participant, wire::topics::alert_command, mailbox)) {}

} // namespace windlass::server
