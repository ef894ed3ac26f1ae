#pragma once
// What a client may send. Pure functions: sample and limits in, refusal or order out.

#include "server/orders.hpp"

#include <windlass.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace windlass::server {

/// What the running exercise allows beyond the fixed ranges.
struct Limits {
    std::array<bool, 2> side_present{true, false}; ///< port, starboard
    double rudder_max = 0.61;                      ///< rad
    bool unpaced =
        true; ///< time scale 0 is allowed; not with real-time priority, where it would starve the host
};

/// Under this name the server itself works the levers that nobody has; no client may use it.
inline constexpr const char* kServerName = "server";

/// Why a sample is refused: `TOPIC from SOURCE: FIELD = VALUE refused; allowed: ALLOWED`.
struct Refusal {
    std::string topic, source, field, value, allowed;
    int side = -1;
    double number = 0;         ///< the value where it is a finite number, else 0
    std::uint64_t samples = 1; ///< how many were refused for this reason

    std::string text() const;
};

/// A file name that a client gives leads nowhere but into the folder that it is looked for in.
bool stays_in_folder(const std::string& name);

/// The first field that is out of order, or nothing. Serials are the mailbox's business.
std::optional<Refusal> refusal(const WindlassCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const HelmCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const ExerciseCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const FaultCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const Report& sample, const Limits& limits);
std::optional<Refusal> refusal(const AlertCommand& sample, const Limits& limits);
std::optional<Refusal> refusal(const RestoreCommand& sample, const Limits& limits);

/// The order in a sample that is not refused.
OrderKind order(const WindlassCommand& sample);
OrderKind order(const HelmCommand& sample);
OrderKind order(const ExerciseCommand& sample);
OrderKind order(const FaultCommand& sample);
OrderKind order(const Report& sample);
OrderKind order(const AlertCommand& sample);
OrderKind order(const RestoreCommand& sample);

} // namespace windlass::server
