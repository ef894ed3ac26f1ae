#include "server/dds/flood_gate.hpp"

#include <algorithm>

namespace windlass::dds {

namespace {
constexpr std::size_t kWritersRemembered = 256;
}

bool FloodGate::pass(const wire::WriterId& writer, double now) {
    auto known = std::ranges::find(entries_, writer, &Entry::writer);
    if (known == entries_.end()) {
        known = entries_.size() < kWritersRemembered ? entries_.insert(entries_.end(), Entry{})
                                                     : std::ranges::min_element(entries_, {}, &Entry::heard);
        *known = {writer, rate_.burst, now};
    }
    known->allowance = std::min(rate_.burst, known->allowance + (now - known->heard) * rate_.per_second);
    known->heard = now;
    if (known->allowance < 1) return false;
    known->allowance -= 1;
    return true;
}

} // namespace windlass::dds
