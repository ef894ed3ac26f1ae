#pragma once
// The line between bridge and forecastle: what is said on it is heard, or whoever spoke learns that nothing
// came back.

#include "server/exercise/faults/faults.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/exercise/talk/talk.hpp"

namespace windlass::exercise {

/// The forecastle reports.
void say(const ReportMade& report, const Talk& talk, const BridgeOrders::When& now, BridgeOrders& orders,
         const EventLog& log);

/// The bridge orders; faults: some wait for what the forecastle is ordered.
void say(const BridgeOrderGiven& order, const Talk& talk, const BridgeOrders::When& now, BridgeOrders& orders,
         FaultBook& faults, const EventLog& log);

} // namespace windlass::exercise
