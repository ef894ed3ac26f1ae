#pragma once
// What a client may send. Pure functions: sample and limits in, refusal or order out.

#include "server/run/inbox.hpp"
#include "server/run/limits.hpp"

#include "idl/types.hpp"

#include <optional>

namespace windlass::server {

/// The first field that is out of order, or nothing. Serials are the mailbox's business.
std::optional<Refusal> refusal(const WindlassCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const HelmCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const ExerciseCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const FaultCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const Report& sample, const Limits& limits);
std::optional<Refusal> refusal(const AlertCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const RestoreCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const OwnShipInput& sample, const Limits& limits);
std::optional<Refusal> refusal(const AssessmentCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const WatchCircle& sample, const Limits& limits);
std::optional<Refusal> refusal(const LightsAndShapesCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const BridgeOrderCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const EnvironmentCommand& sample, const Limits& limits);

/// The order in a sample that is not refused.
OrderContent order(const WindlassCommand& sample);
OrderContent order(const HelmCommand& sample);
OrderContent order(const ExerciseCommand& sample);
OrderContent order(const FaultCommand& sample);
OrderContent order(const Report& sample);
OrderContent order(const AlertCommand& sample);
OrderContent order(const RestoreCommand& sample);
OrderContent order(const OwnShipInput& sample);
OrderContent order(const AssessmentCommand& sample);
OrderContent order(const WatchCircle& sample);
OrderContent order(const LightsAndShapesCommand& sample);
OrderContent order(const BridgeOrderCommand& sample);
OrderContent order(const EnvironmentCommand& sample);

} // namespace windlass::server
