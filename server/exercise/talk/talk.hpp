#pragma once
// What gets through between bridge and forecastle: every word while the VHF works; without it hand signals
// for the orders that have one, and the ship's bell for shackles and for an anchor aweigh.

#include "server/exercise/definition/fault_order.hpp"
#include "server/exercise/definition/orders.hpp"
#include "server/exercise/picture/snapshot.hpp"

#include <string>
#include <vector>

namespace windlass::exercise {

/// Severity from which an instrument or a radio does nothing; tuned.
inline constexpr double kSetDead = 0.5;

/// Stands in place of an order's own words when it was given by a hand signal.
inline constexpr const char* kByHand = "by hand signal";

/// How bridge and forecastle can reach each other now.
struct Talk {
    bool vhf = true;      ///< words pass
    bool in_sight = true; ///< hand signals are seen, by night with a torch
};

/// faults: of the exercise; visibility: m.
Talk talk_of(const std::vector<FaultView>& faults, double visibility);

/// Whether the forecastle gets an order as it is meant: without words only an order that has a hand signal,
/// and no figure.
bool gets_through(const BridgeOrderGiven& order, const Talk& talk);

/// Whether the bridge gets a report: without words only the repeat of a hand signal.
bool gets_through(const ReportMade& report, const Talk& talk);

/// What the bell on the forecastle says of a report, e.g. "bell: 3 strokes"; empty: it says nothing of it.
std::string bell(const ReportMade& report);

} // namespace windlass::exercise
