#pragma once
// One list of all that changes in the model, gone through by whoever hashes, keeps, brings back or compares
// it.
//
// Each plain struct is listed once, beside its functions, by a structured binding: a field that is added to
// the struct and not to its list does not compile. Classes list their members in visit_state() by hand, and
// nothing checks that.

#include <Eigen/Geometry>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace windlass::physics {

/// Name of the k-th of several fields written one behind the other; worked out only when asked for.
struct FieldName {
    std::string_view list; ///< "x, y, heading"
    int index = 0;
    std::string text() const;
};

/// Meets every field, in an order that never changes within a format. May change them.
class StateVisitor {
public:
    virtual ~StateVisitor() = default;
    virtual void number(const FieldName& name, double& value) = 0;
    virtual void integer(const FieldName& name, std::int64_t& value) = 0;
    virtual void numbers(const FieldName& name, double* first, std::size_t count) = 0;
    virtual void text(const FieldName& name, std::string& value) = 0;
    virtual void enter(const FieldName&) {} ///< a struct; its fields follow
    virtual void leave() {}

    /// Several fields at once; see WINDLASS_STATE.
    template <class... Fields>
    void all(std::string_view names, Fields&... fields) {
        int index = 0;
        (field({names, index++}, fields), ...);
    }

    template <class T>
    void field(const FieldName& name, T& value) {
        if constexpr (std::same_as<T, double>) {
            number(name, value);
        } else if constexpr (std::integral<T> || std::is_enum_v<T>) {
            auto whole = static_cast<std::int64_t>(value);
            integer(name, whole);
            value = static_cast<T>(whole);
        } else if constexpr (std::same_as<T, Eigen::Vector3d>) {
            numbers(name, value.data(), 3);
        } else if constexpr (std::same_as<T, Eigen::Quaterniond>) {
            numbers(name, value.coeffs().data(), 4);
        } else if constexpr (std::same_as<T, std::string>) {
            text(name, value);
        } else if constexpr (requires { value.visit_state(*this); }) {
            enter(name);
            value.visit_state(*this);
            leave();
        } else {
            enter(name);
            visit_state(*this, value);
            leave();
        }
    }
};

/// Lists fields under the names that they have in the source.
#define WINDLASS_STATE(visitor, ...) (visitor).all(#__VA_ARGS__, __VA_ARGS__)

} // namespace windlass::physics
