#pragma once
// For loops over nodes and links. They are written without branches and with one array for each field, so
// that the compiler vectorises them.

/// Before a loop: the arrays in it do not overlap.
#define WINDLASS_LANES _Pragma("GCC ivdep")

/// Of a lambda called in such a loop: a call would end the vectors.
#define WINDLASS_INLINE __attribute__((always_inline))
