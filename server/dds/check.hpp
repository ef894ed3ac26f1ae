#pragma once
// What a client may send. Pure functions: sample and limits in, refusal or order out.

#include "server/run/inbox.hpp"
#include "server/run/limits.hpp"

#include "idl/types.hpp"

#include <optional>

namespace windlass::dds {

/// An answer as it came over the topic of its seat, which alone says whose it is.
template <bool kOfForecastle>
struct SeatAnswer : Answer {};
using ForecastleAnswer = SeatAnswer<true>;
using BridgeAnswer = SeatAnswer<false>;

/// The first field that is out of order, or nothing. Serials are the mailbox's business.
std::optional<run::Refusal> refusal(const WindlassCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const HelmCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const ExerciseCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const FaultCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const Report& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const AlertCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const RestoreCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const OwnShipInput& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const AssessmentCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const WatchCircle& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const LightsAndShapesCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const DeckWorkCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const ForecastleAnswer& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const BridgeAnswer& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const BridgeOrderCommand& sample, const run::Limits& limits);
std::optional<run::Refusal> refusal(const EnvironmentCommand& sample, const run::Limits& limits);

/// The order in a sample that is not refused.
run::OrderContent order(const WindlassCommand& sample);
run::OrderContent order(const HelmCommand& sample);
run::OrderContent order(const ExerciseCommand& sample);
run::OrderContent order(const FaultCommand& sample);
run::OrderContent order(const Report& sample);
run::OrderContent order(const AlertCommand& sample);
run::OrderContent order(const RestoreCommand& sample);
run::OrderContent order(const OwnShipInput& sample);
run::OrderContent order(const AssessmentCommand& sample);
run::OrderContent order(const WatchCircle& sample);
run::OrderContent order(const LightsAndShapesCommand& sample);
run::OrderContent order(const DeckWorkCommand& sample);
run::OrderContent order(const ForecastleAnswer& sample);
run::OrderContent order(const BridgeAnswer& sample);
run::OrderContent order(const Answer& sample); ///< of an OrderTaken, which the session has let in
run::OrderContent order(const BridgeOrderCommand& sample);
run::OrderContent order(const EnvironmentCommand& sample);

} // namespace windlass::dds
