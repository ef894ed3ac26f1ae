#include "server/exercise/picture/published.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace windlass::exercise {

namespace {

template <class T>
bool all_finite(const T& value) {
    if constexpr (std::is_floating_point_v<T>) {
        return std::isfinite(value);
    } else if constexpr (Listed<T>) {
        bool finite = true;
        for_each_field<T>([&](auto field) { finite = finite && all_finite(field.of(value)); });
        return finite;
    } else if constexpr (requires { value.coeffs(); }) { // of Eigen
        return value.coeffs().allFinite();
    } else if constexpr (requires { value.allFinite(); }) {
        return value.allFinite();
    } else if constexpr (requires { value.front(); } && !std::is_same_v<T, std::string>) {
        return std::all_of(value.begin(), value.end(), [](const auto& each) { return all_finite(each); });
    } else {
        static_assert(std::is_integral_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>);
        return true;
    }
}

} // namespace

bool is_finite(const Snapshot& snapshot) {
    return all_finite(snapshot);
}

} // namespace windlass::exercise
