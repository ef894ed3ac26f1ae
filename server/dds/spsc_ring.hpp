#pragma once
// A queue of fixed size between two threads, without locks and without allocation.

#include <atomic>
#include <cstddef>
#include <vector>

namespace windlass::dds {

/// One thread fills slots, one other thread empties them. The slots live as long as the ring and keep their
/// memory, so that filling one again need not allocate.
template <class T>
class SpscRing {
public:
    explicit SpscRing(std::size_t slots) : slots_(slots) {}

    /// Filling thread: the next free slot, or nullptr when the ring is full. push() hands it over.
    T* free_slot() {
        const std::size_t filled = filled_.load(std::memory_order_relaxed);
        return filled - emptied_.load(std::memory_order_acquire) == slots_.size()
                   ? nullptr
                   : &slots_[filled % slots_.size()];
    }
    void push() { filled_.fetch_add(1, std::memory_order_release); }

    /// Filling thread: every slot, to set it up. Only while the ring is empty.
    template <class Action>
    void for_each(Action action) {
        for (T& slot : slots_)
            action(slot);
    }

    /// Emptying thread: the oldest filled slot, or nullptr when the ring is empty. pop() gives it back.
    T* oldest() {
        const std::size_t emptied = emptied_.load(std::memory_order_relaxed);
        return filled_.load(std::memory_order_acquire) == emptied ? nullptr
                                                                  : &slots_[emptied % slots_.size()];
    }
    void pop() { emptied_.fetch_add(1, std::memory_order_release); }

    /// Either thread.
    bool empty() const { return filled_.load() == emptied_.load(); }

private:
    std::vector<T> slots_;
    std::atomic<std::size_t> filled_{0};
    std::atomic<std::size_t> emptied_{0};
};

} // namespace windlass::dds
