#pragma once
// On which topics an alert and what seats notice are told, as dds::Publisher does.

#include "idl/topics.hpp"
#include "server/run/status.hpp"

namespace windlass::sim {

/// Of each panel that it is of; one of none is about the simulation. tell: takes a wire::Topic<Alert>.
template <class Tell>
void on_topics_of(const run::AlertView& alert, Tell tell) {
    if (alert.bridge_panel) tell(wire::topics::alert);
    if (alert.deck_panel) tell(wire::topics::forecastle_alert);
    if (!alert.bridge_panel && !alert.deck_panel) tell(wire::topics::server_alert);
}

/// Of each seat that notices it; no instruction. tell: takes a wire::Topic<SeatEvent>.
template <class Tell>
void on_topics_of(const SeatEvent& noticed, Tell tell) {
    if (noticed.forecastle()) tell(wire::topics::forecastle_event);
    if (noticed.bridge()) tell(wire::topics::bridge_event);
}

} // namespace windlass::sim
