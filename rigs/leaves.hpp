#pragma once
// Every single value of a listed struct (common/fields.hpp), for tests that change or compare all of them.

#include "common/fields.hpp"

#include <Eigen/Geometry>

#include <string>
#include <type_traits>

namespace windlass::rigs {

/// Calls visit(path, value) for every number, flag, enumerator and text: "tackle[0].anchor.position[2]".
/// value may be const.
template <class T, class Visit>
void each_leaf(const std::string& path, T& value, Visit&& visit) {
    using Plain = std::remove_const_t<T>;
    if constexpr (Listed<Plain>) {
        for_each_field<Plain>([&](auto field) {
            each_leaf(path + (path.empty() ? "" : ".") + std::string(field.name), field.of(value), visit);
        });
    } else if constexpr (std::is_same_v<Plain, Eigen::Quaterniond>) {
        each_leaf(path, value.coeffs(), visit);
    } else if constexpr (requires { value.begin(); } && !std::is_same_v<Plain, std::string>) {
        std::size_t k = 0;
        for (auto& each : value)
            each_leaf(path + '[' + std::to_string(k++) + ']', each, visit);
    } else {
        visit(path, value);
    }
}

} // namespace windlass::rigs
