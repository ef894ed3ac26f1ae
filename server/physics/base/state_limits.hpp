#pragma once
// What the quantities of a state may be: far beyond what any exercise comes to, and near enough that what a
// step makes of several of them is a number still. A state that is brought back from outside is refused
// beyond them, and an exercise that comes there by itself has ceased to mean anything.

#include "server/physics/base/state_visitor.hpp"

#include <cmath>

namespace windlass::physics {

inline constexpr double kFarthest = 1e7;     ///< m, of anything from where the exercise began
inline constexpr double kFastest = 1000;     ///< m/s, of anything
inline constexpr double kFastestTurn = 1000; ///< rad/s, of anything
inline constexpr double kMostTurned = 1e6;   ///< rad
inline constexpr double kStrongest = 1e12;   ///< N, of anything; and N m of what turns
inline constexpr double kLongest = 1e12;     ///< s; a foreign ship's clock among them
inline constexpr double kMostEnergy = 1e18;  ///< J
inline constexpr double kHottest = 1e5;      ///< K

/// Holds each of several fields to low..high; see WINDLASS_WITHIN. Throws StateError.
template <class... Fields>
void all_within(const StateVisitor& v, std::string_view names, double low, double high,
                const Fields&... fields) {
    int index = 0;
    const auto hold = [&](const auto& field) {
        const FieldName name{names, index++};
        if constexpr (std::same_as<std::remove_cvref_t<decltype(field)>, Eigen::Vector3d>)
            v.all_within(name, field.data(), 3, low, high);
        else
            v.within(name, field, low, high);
    };
    (hold(fields), ...);
}
/// A state of our own is what it may be.
template <class... Fields>
void all_within(const ConstStateVisitor&, std::string_view, double, double, const Fields&...) {}

/// Says between what numbers fields of a list may be: numbers, or vectors each of whose parts is.
#define WINDLASS_WITHIN(visitor, low, high, ...)                                                             \
    ::windlass::physics::all_within(visitor, #__VA_ARGS__, low, high, __VA_ARGS__)

} // namespace windlass::physics
