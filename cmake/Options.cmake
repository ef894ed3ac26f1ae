# What every target of ours is compiled with: link to windlass::options.

add_library(windlass_options INTERFACE)
add_library(windlass::options ALIAS windlass_options)
target_include_directories(windlass_options INTERFACE ${PROJECT_SOURCE_DIR})

target_compile_options(windlass_options INTERFACE -Wall -Wextra -Wpedantic -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False positive of GCC 12 in std::string (GCC bug 105329).
  target_compile_options(windlass_options INTERFACE -Wno-restrict)
else()
  # Clang does not know "GCC ivdep" (server/physics/base/vectorise.hpp) and is not told in its own words: its
  # vectorize(assume_safety) also lets it add up in another order, which gives other bits.
  target_compile_options(windlass_options INTERFACE -Wno-unknown-pragmas)
endif()

# Determinism: the same bits in debug and release on one machine, and on others whose libm gives the same: sin, atan2
# and exp of Debian 12's glibc differ in the last bit between processors with FMA and without. So no contraction of
# a * b + c, which the optimiser would apply in one build and not in another. Of what is not libm's, any level of
# instructions gives the same bits; v3 (AVX2: Intel since 2013, AMD since 2015) runs the chain at least 1.4 times as
# fast as v2, which has no fused products: each of the chain's (server/physics/base/fused.hpp) is a call there, to the
# same bits.
set(WINDLASS_ARCH x86-64-v3 CACHE STRING "Instruction set, as for -march; x86-64-v2 for machines older than AVX2")
# GCC 12 makes vfmaddsub of a product, a sum and a difference in its straight-line vectoriser (-O3) all the
# same: without that, release gives the bits of debug.
add_compile_options(-march=${WINDLASS_ARCH} -ffp-contract=off -fno-tree-slp-vectorize)

# Loops over nodes are vectorised by the compiler, one array a field; Eigen's own packing of three-vectors would
# stand in its way. The two options change no result: nobody reads errno or floating-point traps.
add_compile_definitions(EIGEN_DONT_VECTORIZE)
add_compile_options(-fno-math-errno -fno-trapping-math)

set(WINDLASS_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")
if(WINDLASS_SANITIZE)
  add_compile_options(-fsanitize=${WINDLASS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${WINDLASS_SANITIZE})
  # GCC warns falsely of std::function inside std::regex under sanitizers (GCC bug 105616).
  target_compile_options(windlass_options INTERFACE -Wno-maybe-uninitialized)
  if(WINDLASS_SANITIZE STREQUAL "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # It does not see the fences that Boost.Asio puts round a handler, and says so wherever one is compiled; what
    # they order is under the scheduler's mutex, which it sees.
    target_compile_options(windlass_options INTERFACE -Wno-tsan)
  endif()
endif()
