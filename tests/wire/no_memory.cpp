#include "tests/wire/no_memory.hpp"

#include <cstdlib>
#include <new>
#include <utility>

namespace windlass::test {

thread_local bool out_of_memory = false;

} // namespace windlass::test

void* operator new(std::size_t size) {
    void* memory = std::exchange(windlass::test::out_of_memory, false) ? nullptr : std::malloc(size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return std::exchange(windlass::test::out_of_memory, false) ? nullptr : std::malloc(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}
