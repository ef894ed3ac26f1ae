#include "server/dds/command_readers.hpp"

#include "idl/moved_in_run.hpp"
#include "server/dds/flood_gate.hpp"

#include <chrono>

namespace windlass::dds {

namespace {

// Of one writer. Levers are held at 10 to 60 Hz; orders are given by people. Beyond this a client floods, and
// its reports would wash the log of events away.
constexpr FloodGate::Rate kLevers{.per_second = 500, .burst = 250};
constexpr FloodGate::Rate kOrders{.per_second = 20, .burst = 50};
constexpr FloodGate::Rate kRestores{.per_second = 1, .burst = 2}; // up to 1 MiB each

template <class T>
FloodGate::Rate rate_of(const wire::Topic<T>& topic) {
    if (std::is_same_v<T, RestoreCommand>) return kRestores;
    return topic.deadline > 0 ? kLevers : kOrders;
}

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Kept, class T>
decltype(auto) kept_as(const T& sample) {
    if constexpr (std::is_same_v<Kept, T>)
        return (sample);
    else
        return Kept{sample};
}

/// Kept: what a sample is in the mailbox, where topics that share a type are told apart.
template <class T, class Kept = T>
wire::Reader<T> reader(wire::Participant& participant, const wire::Topic<T>& topic, Mailbox& mailbox,
                       bool instructor = false) {
    const std::size_t kind = Mailbox::Sample(Kept()).index();
    return {participant, topic,
            [&mailbox, member = participant, kind, instructor, of_levers = topic.deadline > 0,
             gate = FloodGate(rate_of(topic))](const T& sample, const wire::WriterId& writer) mutable {
                if (gate.pass(writer, now())) {
                    const std::uint64_t run = of_levers ? wire::told_moved_in_run(member, writer) : 0;
                    mailbox.put(kept_as<Kept>(sample), writer, instructor, run);
                } else {
                    mailbox.refuse(kind, Mailbox::Unseen::too_fast);
                }
            },
            [&mailbox, kind] { mailbox.refuse(kind, Mailbox::Unseen::malformed); },
            topic.deadline > 0
                ? typename wire::Reader<T>::OnWriter([&mailbox](const wire::WriterId& writer, bool there) {
                      there ? mailbox.come(writer) : mailbox.leave(writer);
                  })
                : nullptr};
}

} // namespace

CommandReaders::CommandReaders(wire::Participant& participant, Mailbox& mailbox)
    : windlass_(reader(participant, wire::topics::windlass_command, mailbox)),
      instructor_windlass_(reader(participant, wire::topics::instructor_windlass_command, mailbox, true)),
      helm_(reader(participant, wire::topics::helm_command, mailbox)),
      instructor_helm_(reader(participant, wire::topics::instructor_helm_command, mailbox, true)),
      own_ship_(reader(participant, wire::topics::own_ship_input, mailbox)),
      exercise_(reader(participant, wire::topics::exercise_command, mailbox)),
      environment_(reader(participant, wire::topics::environment_command, mailbox)),
      restore_(reader(participant, wire::topics::restore_command, mailbox)),
      fault_(reader(participant, wire::topics::fault_command, mailbox)),
      report_(reader(participant, wire::topics::report, mailbox)),
      bridge_order_(reader(participant, wire::topics::bridge_order_command, mailbox)),
      watch_circle_(reader(participant, wire::topics::watch_circle, mailbox)),
      lights_and_shapes_(reader(participant, wire::topics::lights_and_shapes_command, mailbox)),
      deck_work_(reader(participant, wire::topics::deck_work_command, mailbox)),
      forecastle_answer_(
          reader<Answer, ForecastleAnswer>(participant, wire::topics::forecastle_answer, mailbox)),
      bridge_answer_(reader<Answer, BridgeAnswer>(participant, wire::topics::bridge_answer, mailbox)),
      alert_(reader(participant, wire::topics::alert_command, mailbox)),
      assessment_(reader(participant, wire::topics::assessment_command, mailbox)) {}

} // namespace windlass::dds
