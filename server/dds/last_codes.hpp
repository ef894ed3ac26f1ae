#pragma once
// The last enumerators of the wire's lists that grow: words.json has as many rows, in the same order
// (words_test).

#include "idl/types.hpp"
#include "words/words.hpp"

namespace windlass::dds {

inline constexpr auto kLastFault = static_cast<FaultCode>(words::kFaultCode.size() - 1);
inline constexpr auto kLastReport = static_cast<ReportCode>(words::kReportCode.size() - 1);
inline constexpr auto kLastDeckWork = static_cast<DeckWork>(words::kDeckWork.size() - 1);
inline constexpr auto kLastBridgeOrder = static_cast<BridgeOrderCode>(words::kBridgeOrderCode.size() - 1);

} // namespace windlass::dds
