#pragma once
// The types of windlass.idl, under windlass::. The module of the wire's version is an inline namespace here:
// it is part of a type's name on the wire and stands in nobody's way in the code.

namespace windlass {
inline namespace v12 {}
} // namespace windlass

#include <windlass.h>
