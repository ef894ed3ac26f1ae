#pragma once
// What clients sent since the last tick: orders that are in order, and why others are refused.

#include "server/run/received_order.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace windlass::run {

/// Why a sample is refused: `TOPIC from SOURCE: FIELD = VALUE refused; allowed: ALLOWED`.
struct Refusal {
    std::string topic, source, field, value, allowed;
    int side = -1;
    double number = 0;         ///< the value where it is a finite number, else 0
    std::uint64_t samples = 1; ///< how many were refused for this reason

    std::string text() const;
};

/// All of it, in the order of arrival.
struct Inbox {
    std::vector<ReceivedOrder> orders;
    std::vector<Refusal> refusals;
    std::vector<WriterKey> came; ///< writers of levers that are there, before their first orders
    std::vector<WriterKey> left; ///< writers of levers that are there no more, after their last orders
    std::uint64_t overflow = 0;  ///< samples that found the box full since the last drain

    void clear() { orders.clear(), refusals.clear(), came.clear(), left.clear(), overflow = 0; }
};

} // namespace windlass::run
