#pragma once
// Memory that runs out when a test says so. A program that links no_memory.cpp has its operator new.

namespace windlass::test {

/// The next allocation of this thread fails, once.
extern thread_local bool out_of_memory;

} // namespace windlass::test
