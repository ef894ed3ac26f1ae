#pragma once
// A queue of fixed size between two threads, without locks and without allocation.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

namespace windlass::dds {

/// One thread fills slots, one other thread empties them. A slot is made when it is first needed: of
/// thousands that a storm of events would want, a calm exercise touches a few. From then on it lives as long
/// as the ring and keeps its memory, so that filling it again need not allocate.
template <class T>
class SpscRing {
public:
    explicit SpscRing(std::size_t slots) : size_(slots), slots_(std::allocator<T>().allocate(slots)) {}
    ~SpscRing() {
        std::destroy_n(slots_, made_);
        std::allocator<T>().deallocate(slots_, size_);
    }
    SpscRing(const SpscRing&) = delete;
    SpscRing& operator=(const SpscRing&) = delete;

    /// Filling thread: the next free slot, or nullptr when the ring is full. push() hands it over.
    T* free_slot() {
        const std::size_t filled = filled_.load(std::memory_order_relaxed);
        if (filled - emptied_.load(std::memory_order_acquire) == size_) return nullptr;
        make(filled % size_ + 1);
        return slots_ + filled % size_;
    }
    void push() { filled_.fetch_add(1, std::memory_order_release); }

    /// Filling thread: every slot, to set it up. Only while the ring is empty.
    template <class Action>
    void for_each(Action action) {
        make(size_);
        std::for_each_n(slots_, size_, action);
    }

    /// Emptying thread: the oldest filled slot, or nullptr when the ring is empty. pop() gives it back.
    T* oldest() {
        const std::size_t emptied = emptied_.load(std::memory_order_relaxed);
        return filled_.load(std::memory_order_acquire) == emptied ? nullptr : slots_ + emptied % size_;
    }
    void pop() { emptied_.fetch_add(1, std::memory_order_release); }

    /// Either thread.
    bool empty() const { return filled_.load() == emptied_.load(); }

private:
    void make(std::size_t slots) {
        for (; made_ < slots; ++made_)
            std::construct_at(slots_ + made_);
    }

    const std::size_t size_;
    T* const slots_;
    std::size_t made_ = 0; // the filling thread's
    std::atomic<std::size_t> filled_{0};
    std::atomic<std::size_t> emptied_{0};
};

} // namespace windlass::dds
