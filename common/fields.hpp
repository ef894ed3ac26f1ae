#pragma once
// One list of the fields of a struct, made once beside it, and gone through by whoever deals with all of
// them: the check for NaN, the copy onto the wire and back, the dump of a fault.

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>

#include <string_view>

namespace windlass {

/// One field of a listed struct. name is as in the source; of(object) is the field of an object;
/// on_wire(sample) is the member of the same name of a type of the IDL, and no valid expression where the
/// type has none.
template <class Name, class Of, class OnWire>
struct Field {
    constexpr Field(Name, Of its_of, OnWire its_on_wire) : of(its_of), on_wire(its_on_wire) {}

    static constexpr std::string_view name = Name{}();
    Of of;
    OnWire on_wire;
};

/// Calls visit(field) for each field of a listed struct, in the order of its list. Nothing of it is left at
/// run time but what visit does.
template <class Struct, class Visit>
constexpr void for_each_field(Visit&& visit) {
    each_field_of(static_cast<const Struct*>(nullptr), visit);
}

/// A struct that has a list.
template <class T>
concept Listed = requires(const T* of, void (*visit)(...)) {
    each_field_of(of, visit);
};

/// The list of a struct, behind it and in its namespace: every field by its name. A field that the struct has
/// and the list has not does not compile: a structured binding names all or none.
#define WINDLASS_FIELDS(Struct, ...)                                                                         \
    inline void every_field_is_listed(const Struct& of) {                                                    \
        [[maybe_unused]] const auto& [__VA_ARGS__] = of;                                                     \
    }                                                                                                        \
    template <class Visit>                                                                                   \
    constexpr void each_field_of(const Struct*, Visit& visit) {                                              \
        BOOST_PP_SEQ_FOR_EACH(WINDLASS_FIELD, visit, BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))                  \
    }

#define WINDLASS_FIELD(r, visit, Name)                                                                       \
    visit(::windlass::Field([] { return BOOST_PP_STRINGIZE(Name); },                                         \
                            [](auto& object) -> decltype((object.Name)) { return object.Name; },             \
                            [](auto& sample) -> decltype((sample.Name())) { return sample.Name(); }));

} // namespace windlass
