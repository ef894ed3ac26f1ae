#pragma once
// One list of all that changes in the model, gone through by whoever hashes, keeps, brings back or compares
// it.
//
// Each struct has one list, visit_state(), a template that StateVisitor (who may change the fields) and
// ConstStateVisitor (who only looks) both go through. Plain structs are listed by a structured binding: a
// field that is added to the struct and not to its list does not compile. Classes list their members as
// self.member_. The list says also what each field may be, where its type does not: a state that is brought
// back comes from outside and may say anything.

#include <Eigen/Geometry>

#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

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

/// A struct or class, const or not: what a list takes.
template <class T, class Listed>
concept StateOf = std::same_as<std::remove_const_t<T>, Listed>;

/// Gives a field to the visitor's member for its type; a struct to its list.
template <class Visitor, class T>
void visit_field(Visitor& v, const FieldName& name, T& value) {
    using Plain = std::remove_const_t<T>;
    if constexpr (std::same_as<Plain, double>) {
        v.number(name, value);
    } else if constexpr (std::integral<Plain> || std::is_enum_v<Plain>) {
        v.whole(name, value);
    } else if constexpr (std::same_as<Plain, Eigen::Vector3d>) {
        v.numbers(name, value.data(), 3);
    } else if constexpr (std::same_as<Plain, Eigen::Quaterniond>) {
        v.numbers(name, value.coeffs().data(), 4);
    } else if constexpr (std::same_as<Plain, std::string>) {
        v.text(name, value);
    } else {
        v.enter(name);
        visit_state(v, value);
        v.leave();
    }
}

/// Meets every field of a state that it does not change, in an order that never changes within a format.
class ConstStateVisitor {
public:
    static constexpr bool kRestores = false;

    virtual ~ConstStateVisitor() = default;
    virtual void number(const FieldName& name, double value) = 0;
    virtual void integer(const FieldName& name, std::int64_t value) = 0;
    virtual void numbers(const FieldName& name, const double* first, std::size_t count) = 0;
    virtual void text(const FieldName& name, const std::string& value) = 0;
    virtual void enter(const FieldName&) {} ///< a struct; its fields follow
    virtual void leave() {}

    /// Several fields at once; see WINDLASS_STATE.
    template <class... Fields>
    void all(std::string_view names, const Fields&... fields) {
        int index = 0;
        (field({names, index++}, fields), ...);
    }
    template <class T>
    void field(const FieldName& name, const T& value) {
        visit_field(*this, name, value);
    }
    /// Those of a part that has no name of its own.
    template <class T>
    void fields_of(const T& part) {
        visit_state(*this, part);
    }
    template <class T>
    void whole(const FieldName& name, T value) {
        integer(name, static_cast<std::int64_t>(value));
    }
    /// How long a list is; its entries follow.
    template <class T>
    void length(const FieldName& name, const std::vector<T>& list, std::size_t) {
        integer(name, static_cast<std::int64_t>(list.size()));
    }

    /// A state of our own is what it may be.
    template <class... Limits>
    void within(const FieldName&, const Limits&...) const {}
    template <class... Limits>
    void all_within(const FieldName&, const Limits&...) const {}
};

/// Meets the same fields in the same order and may change them: brings back what somebody has kept.
class StateVisitor {
public:
    static constexpr bool kRestores = true;

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
        visit_field(*this, name, value);
    }
    /// Those of a part that has no name of its own.
    template <class T>
    void fields_of(T& part) {
        visit_state(*this, part);
    }
    template <class T>
    void whole(const FieldName& name, T& value) {
        auto integer_value = static_cast<std::int64_t>(value);
        integer(name, integer_value);
        within(name, integer_value, min_of<T>(), max_of(value));
        value = static_cast<T>(integer_value);
    }
    /// How long a list is, max at most; it becomes so long, and its entries follow.
    template <class T>
    void length(const FieldName& name, std::vector<T>& list, std::size_t max) {
        std::size_t count = list.size();
        whole(name, count);
        within(name, count, 0, max);
        list.resize(count);
    }

    /// What a field may be. To be called before anything is made of it. Throws StateError when the value is
    /// none of low..high.
    template <class T>
    void within(const FieldName& name, T value, std::type_identity_t<T> low,
                std::type_identity_t<T> high) const {
        using Wide = std::conditional_t<std::integral<T>, std::int64_t, double>;
        if (!(value >= low && value <= high))
            refuse(name.text(), static_cast<Wide>(value), static_cast<Wide>(low), static_cast<Wide>(high));
    }
    /// The same of each of many.
    void all_within(const FieldName& name, const double* first, std::size_t count, double low,
                    double high) const;

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
};

/// Lists fields under the names that they have in the source.
#define WINDLASS_STATE(visitor, ...) (visitor).all(#__VA_ARGS__, __VA_ARGS__)

/// Behind a list in a source file: compiled for both visitors. NOLINTBEGIN(bugprone-macro-parentheses)
#define WINDLASS_STATE_LISTED(Struct)                                                                        \
    template void visit_state(::windlass::physics::StateVisitor&, Struct&);                                  \
    template void visit_state(::windlass::physics::ConstStateVisitor&, const Struct&)
// NOLINTEND(bugprone-macro-parentheses)
} // namespace windlass::physics
