#pragma once
// Every method, one line each: what its file gives to the list.

#include "bench/problem/method.hpp"

namespace windlass::lab {

MethodEntry production_method();          ///< production.cpp
MethodEntry production_in_phase_method(); ///< production.cpp
MethodEntry pbd_method();                 ///< pbd.cpp
MethodEntry xpbd_method();                ///< xpbd.cpp
MethodEntry small_step_xpbd_method();     ///< xpbd.cpp
MethodEntry direct_end_method();          ///< direct_end.cpp
MethodEntry leapfrog_method();            ///< leapfrog.cpp
MethodEntry lumped_rk4_method();          ///< lumped_rk4.cpp
MethodEntry implicit_fe_method();         ///< implicit_fe.cpp
MethodEntry bullet_links_method();        ///< bullet_links.cpp
MethodEntry catenary_method();            ///< catenary.cpp

} // namespace windlass::lab
