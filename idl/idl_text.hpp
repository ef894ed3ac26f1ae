#pragma once
// windlass.idl itself, as this program was built with it: recordings carry it, and the bounds of every
// sequence are taken from it.

#include "idl/idl_schema.hpp"
#include "idl/topic_types.hpp"
#include "idl/types.hpp"

#include <string_view>

namespace windlass::idl {

/// The whole text.
std::string_view own_text();

/// Its types; read at the first call.
const IdlSchema& own_schema();

/// That of a compiled type, for every type of topic_types.hpp.
template <class T>
const Type& own_type();
#define WINDLASS_OWN_TYPE(T)                                                                                 \
    template <>                                                                                              \
    const Type& own_type<T>();
WINDLASS_TOPIC_TYPES(WINDLASS_OWN_TYPE)
#undef WINDLASS_OWN_TYPE

} // namespace windlass::idl
