#include "server/host/timekeeping.hpp"

#include <algorithm>

namespace windlass::host {

void Timekeeping::began(std::chrono::nanoseconds late) {
    const auto ns = std::max<std::int64_t>(late.count(), 0);
    const auto step = std::min(static_cast<std::size_t>(ns / kStep.count()), kSteps);
    count_[step].fetch_add(1, std::memory_order_relaxed);
    std::int64_t latest = latest_.load(std::memory_order_relaxed);
    while (ns > latest && !latest_.compare_exchange_weak(latest, ns, std::memory_order_relaxed)) {
    }
}

Timekeeping::Figures Timekeeping::collect() {
    std::array<std::uint64_t, kSteps + 1> count{};
    Figures figures;
    for (std::size_t i = 0; i < count.size(); ++i)
        figures.beats += count[i] = count_[i].exchange(0, std::memory_order_relaxed);
    figures.all = 1e-9 * static_cast<double>(latest_.exchange(0, std::memory_order_relaxed));
    const auto within = [&](double share) {
        const double wanted = share * static_cast<double>(figures.beats);
        double sum = 0;
        for (std::size_t i = 0; i < kSteps; ++i) {
            sum += static_cast<double>(count[i]);
            if (sum >= wanted) return 1e-9 * static_cast<double>((i + 1) * std::size_t(kStep.count()));
        }
        return figures.all;
    };
    figures.half = std::min(within(0.5), figures.all), figures.most = std::min(within(0.99), figures.all);
    return figures;
}

} // namespace windlass::host
