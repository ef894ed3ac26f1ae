#pragma once
// The levers that a hand has, and what is said of one: by an answer to "what if", and by a hint in practice.

#include "server/exercise/definition/orders.hpp"

#include <string>

namespace windlass::assess {

/// Values as in WindlassOrder and Helm; of clutch and stopper 1 is in and closed, 0 out and off.
enum class LeverKind { brake, speed, clutch, stopper, engine, rudder };
constexpr LeverKind last_of(LeverKind) {
    return LeverKind::rudder;
}

struct Lever {
    LeverKind kind = LeverKind::brake;
    exercise::Side side = exercise::Side::port; ///< of the helm: without meaning

    bool of_helm() const { return kind == LeverKind::engine || kind == LeverKind::rudder; }
    /// It has two places.
    bool catches() const { return kind == LeverKind::clutch || kind == LeverKind::stopper; }
    bool operator==(const Lever&) const = default;
};

/// Where it stands by these orders, the windlass's those of its side.
double place_of(const Lever& lever, const exercise::WindlassOrder& windlass, const exercise::HelmOrder& helm);

/// "the port wheel"; of one windlass alone "the wheel".
std::string lever_words(const Lever& lever, bool two_sides);
/// Where it stands: "hard on", "30 % heave".
std::string value_words(const Lever& lever, double value);

} // namespace windlass::assess
