#include "server/dds/still_cable.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::dds {

namespace {

constexpr double kPeriod = 0.2 - 1e-9; // s: 5 Hz, which a reader who joins has to wait
constexpr float kMoved = 2e-3F;        // m, less than a pixel shows
constexpr float kPulled = 2e-3F;       // of the largest tension
constexpr double kVeered = 1e-3;       // m

} // namespace

bool StillCable::moved(const exercise::ChainView& chain) const {
    if (chain.nodes.size() != nodes_.size() || chain.tension.size() != tension_.size()) return true;
    if (std::abs(chain.cable_out - cable_out_) > kVeered) return true;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if ((chain.nodes[i] - nodes_[i]).squaredNorm() > kMoved * kMoved) return true;
    float largest = 0, change = 0;
    for (std::size_t i = 0; i < tension_.size(); ++i) {
        largest = std::max(largest, tension_[i]);
        change = std::max(change, std::abs(chain.tension[i] - tension_[i]));
    }
    return change > kPulled * largest;
}

bool StillCable::due(const exercise::ChainView& chain, double time) {
    const bool waited = time <= asked_ || time <= sent_ || time - sent_ >= kPeriod;
    asked_ = time;
    if (!nodes_.empty() && !waited && !moved(chain)) return false;
    sent_ = time;
    cable_out_ = chain.cable_out;
    nodes_ = chain.nodes; // both keep their memory
    tension_ = chain.tension;
    return true;
}

} // namespace windlass::dds
