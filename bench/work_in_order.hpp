#pragma once
// Runs that do not know of each other, some at a time, told in their order.

#include <algorithm>
#include <cstddef>
#include <future>
#include <vector>

namespace windlass::bench {

/// work(k) for each k from first up to, but without, last, so many at a time on threads of their own; then
/// done(k, future of its result), in order, on this thread.
template <class Work, class Done>
void work_in_order(std::size_t first, std::size_t last, std::size_t at_a_time, const Work& work,
                   const Done& done) {
    for (std::size_t from = first; from < last; from += at_a_time) {
        const std::size_t to = std::min(last, from + at_a_time);
        std::vector<decltype(std::async(std::launch::async, work, from))> begun;
        for (std::size_t k = from; k < to; ++k)
            begun.push_back(std::async(std::launch::async, work, k));
        for (std::size_t k = from; k < to; ++k)
            done(k, begun[k - from]);
    }
}

} // namespace windlass::bench
