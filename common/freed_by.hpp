#pragma once
// What a C library gives, freed by its own function.

namespace windlass {

/// Deleter for a std::unique_ptr.
template <auto kFree>
struct FreedBy {
    template <class T>
    void operator()(T* thing) const {
        kFree(thing);
    }
};

} // namespace windlass
