#pragma once
// windlass.idl itself, as this program was built with it: recordings carry it, and the bounds of every
// sequence are taken from it.

#include "idl/idl_schema.hpp"

#include <string_view>

namespace windlass::idl {

/// The whole text.
std::string_view own_text();

/// Its types; read at the first call.
const IdlSchema& own_schema();

/// That of a compiled type, for every type of topic_types.hpp.
template <class T>
const Type& own_type();

} // namespace windlass::idl
