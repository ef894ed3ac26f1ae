#include "sim/world.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::sim {

double Chance::spread(double low, double high) {
    return low * std::pow(high / low, unit());
}

World::Time World::time() const {
    return Time(std::chrono::hours(1)) +
           std::chrono::duration_cast<Time::duration>(std::chrono::duration<double>(now_));
}

double World::seconds(Time time) const {
    return std::chrono::duration<double>(time - Time(std::chrono::hours(1))).count();
}

void World::run_until(double when) {
    while (!due_.empty() && due_.begin()->first.first <= when) {
        auto next = due_.extract(due_.begin());
        now_ = std::max(now_, next.key().first);
        next.mapped()();
    }
    now_ = std::max(now_, when);
}

} // namespace windlass::sim
