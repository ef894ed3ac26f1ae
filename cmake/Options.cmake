# What every target of ours is compiled with: link to windlass::options.

add_library(windlass_options INTERFACE)
add_library(windlass::options ALIAS windlass_options)
target_include_directories(windlass_options INTERFACE ${PROJECT_SOURCE_DIR})

# -Wno-restrict: false positive of GCC 12 in std::string (GCC bug 105329).
target_compile_options(windlass_options INTERFACE -Wall -Wextra -Wpedantic -Werror -Wno-restrict)

# Determinism: the same bits in debug and release, on any x86-64 machine. One instruction set, and no
# contraction of a * b + c, which the optimiser would apply in one build and not in another.
add_compile_options(-march=x86-64-v2 -ffp-contract=off)

set(WINDLASS_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")
if(WINDLASS_SANITIZE)
  add_compile_options(-fsanitize=${WINDLASS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${WINDLASS_SANITIZE})
  # GCC warns falsely of std::function inside std::regex under sanitizers (GCC bug 105616).
  target_compile_options(windlass_options INTERFACE -Wno-maybe-uninitialized)
endif()
