#pragma once
// Every method, one line each: what its file gives to the list.

#include "bench/lab/method.hpp"

namespace windlass::lab {

MethodEntry production_method(); ///< production.cpp

} // namespace windlass::lab
