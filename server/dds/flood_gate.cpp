#include "server/dds/flood_gate.hpp"

#include <algorithm>

namespace windlass::server {

namespace {
constexpr std::size_t kWritersRemembered = 256;
}

FloodGate::Entry& FloodGate::entry(const wire::WriterId& writer, double now) {
    const auto known =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.writer == writer; });
    if (known != entries_.end()) return *known;
    const Entry fresh{writer, rate_.burst, now};
    if (entries_.size() < kWritersRemembered) return entries_.emplace_back(fresh);
    return *std::min_element(entries_.begin(), entries_.end(),
                             [](const Entry& a, const Entry& b) { return a.heard < b.heard; }) = fresh;
}

bool FloodGate::pass(const wire::WriterId& writer, double now) {
    Entry& known = entry(writer, now);
    known.allowance = std::min(rate_.burst, known.allowance + (now - known.heard) * rate_.per_second);
    known.heard = now;
    if (known.allowance < 1) return false;
    known.allowance -= 1;
    return true;
}

} // namespace windlass::server
