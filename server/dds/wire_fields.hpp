#pragma once
// The fields of a listed struct (common/fields.hpp) onto the members of the same name of a type of the IDL,
// and back. What has another name there, or none, is said where the struct is converted. Reuses the memory of
// the target, and takes none for numbers.

#include "common/fields.hpp"
#include "common/text.hpp"

#include "idl/types.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>

namespace windlass::dds {

/// The bound that the IDL gives sequences of that element; what is beyond is left out. Of others the writer
/// refuses a sample that is too long.
template <class Element>
inline constexpr std::size_t kMostOnWire = std::numeric_limits<std::size_t>::max();
template <>
inline constexpr std::size_t kMostOnWire<FaultStatus> = 96;
template <>
inline constexpr std::size_t kMostOnWire<CurrentLayer> = 64;
template <>
inline constexpr std::size_t kMostOnWire<CableMark> = 64;
template <>
inline constexpr std::size_t kMostOnWire<Criterion> = 64;
template <>
inline constexpr std::size_t kMostOnWire<ObjectiveMark> = 16;
template <>
inline constexpr std::size_t kMostOnWire<OrderDone> = 64;
template <>
inline constexpr std::size_t kMostOnWire<JudgedReport> = 256;
template <>
inline constexpr std::size_t kMostOnWire<QuestionChoice> = 5;
template <>
inline constexpr std::size_t kMostOnWire<PredictedMoment> = 64;
template <>
inline constexpr std::size_t kMostOnWire<Event> = 32;

/// A number, flag or enumerator; these stand in the order of the IDL.
template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Text is cut to its bound; what is optional and not there is 0.
template <class From, class To>
void to_wire(const From& from, To& to) {
    if constexpr (Listed<From>) {
        for_each_field<From>([&](auto field) {
            if constexpr (requires { field.on_wire(to); }) to_wire(field.of(from), field.on_wire(to));
        });
    } else if constexpr (Plain<From>) {
        to = static_cast<To>(from);
    } else if constexpr (std::is_same_v<From, std::string>) {
        to = std::string(clipped(from, To::max_size));
    } else if constexpr (std::is_same_v<From, Eigen::Quaterniond>) {
        to.w(from.w()), to.x(from.x()), to.y(from.y()), to.z(from.z());
    } else if constexpr (requires { from.z(); }) {
        to.x(from.x()), to.y(from.y()), to.z(from.z());
    } else if constexpr (requires { from.value_or(0); }) {
        to = from.value_or(0);
    } else if constexpr (std::is_same_v<From, To>) {
        to = from;
    } else {
        to.resize(std::min(from.size(), kMostOnWire<typename To::value_type>));
        for (std::size_t k = 0; k < to.size(); ++k)
            to_wire(from[k], to[k]);
    }
}

/// The same back.
template <class From, class To>
void from_wire(const From& from, To& to) {
    if constexpr (Listed<To>) {
        for_each_field<To>([&](auto field) {
            if constexpr (requires { field.on_wire(from); }) from_wire(field.on_wire(from), field.of(to));
        });
    } else if constexpr (Plain<To>) {
        to = static_cast<To>(from);
    } else if constexpr (std::is_same_v<To, std::string>) {
        to = from.to_string();
    } else if constexpr (std::is_same_v<To, Eigen::Quaterniond>) {
        to = {from.w(), from.x(), from.y(), from.z()};
    } else if constexpr (requires { to.z(); }) {
        to = {from.x(), from.y(), from.z()};
    } else {
        to.resize(from.size());
        for (std::size_t k = 0; k < to.size(); ++k)
            from_wire(from[k], to[k]);
    }
}

} // namespace windlass::dds
