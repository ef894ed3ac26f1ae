#pragma once
// On which topics an alert is told, as dds::Publisher does.

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

} // namespace windlass::sim
