#pragma once
// One list of all that changes in the model, gone through by whoever hashes, keeps, brings back or compares
// it.
//
// Each plain struct is listed once by a structured binding: a field that is added to the struct and not to
// its list does not compile. Classes list their members in visit_state(). The list says also what each field
// may be, where its type does not: a state that is brought back comes from outside and may say anything.

#include <Eigen/Geometry>

#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
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

/// A field that is what it never can be: its name, its value, what is allowed.
struct StateError : std::runtime_error {
    using std::runtime_error::runtime_error;
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
            within(name, whole, min_of<T>(), max_of(value));
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

    /// What a field may be. To be called before anything is made of it. Throws StateError when the state
    /// comes from outside and the value is none of low..high; a state of our own is not looked at.
    template <class T>
    void within(const FieldName& name, T value, std::type_identity_t<T> low,
                std::type_identity_t<T> high) const {
        using Wide = std::conditional_t<std::integral<T>, std::int64_t, double>;
        if (checks_ && !(value >= low && value <= high))
            refuse(name.text(), static_cast<Wide>(value), static_cast<Wide>(low), static_cast<Wide>(high));
    }
    /// The same of each of many.
    void all_within(const FieldName& name, const double* first, std::size_t count, double low,
                    double high) const;

    bool checks() const { return checks_; }

protected:
    /// checks: this one brings back what somebody else has kept.
    explicit StateVisitor(bool checks = false) : checks_(checks) {}

private:
    [[noreturn]] static void refuse(const std::string& name, double value, double low, double high);
    [[noreturn]] static void refuse(const std::string& name, std::int64_t value, std::int64_t low,
                                    std::int64_t high);

    template <class T>
    static constexpr std::int64_t min_of() {
        if constexpr (std::signed_integral<T>) return std::numeric_limits<T>::min();
        return 0;
    }
    /// An enumeration says which of its values is the last: last_of() beside it.
    template <class T>
    static constexpr std::int64_t max_of(T value) {
        if constexpr (std::is_enum_v<T>) {
            return static_cast<std::int64_t>(last_of(value));
        } else if constexpr (sizeof(T) < sizeof(std::int64_t)) {
            return std::numeric_limits<T>::max();
        } else {
            return std::numeric_limits<std::int64_t>::max();
        }
    }

    const bool checks_;
};

/// Lists fields under the names that they have in the source.
#define WINDLASS_STATE(visitor, ...) (visitor).all(#__VA_ARGS__, __VA_ARGS__)

} // namespace windlass::physics
