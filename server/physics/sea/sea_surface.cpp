#include "server/physics/sea/sea_surface.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kMaxHeight = 30, kMinPeriod = 0.5,
                 kMaxPeriod = 60; ///< m, s; of a state that is brought back

} // namespace

SeaSurface::SeaSurface(const SeaDef& def, double depth) : depth_(depth) {
    change(def, 0, 0);
    settle(0);
}

double SeaSurface::share(double t) const {
    if (t >= ramp_end_) return 1;
    return std::max(0.0, (t - ramp_begin_) / (ramp_end_ - ramp_begin_));
}

/// The heights are what they are now, and what has gone is gone.
void SeaSurface::settle(double t) {
    const double s = share(t);
    for (auto& kind : trains_)
        for (Train& train : kind) {
            train.height_before += s * (train.height_after - train.height_before);
            train.height_after = train.height_before;
            if (train.gone()) train = {};
        }
    ramp_begin_ = ramp_end_ = t;
    lay_out();
}

/// Whether each train of a sea finds its like in the water, or a place.
bool SeaSurface::has_room(const SeaDef& def) const {
    const std::array wanted{Train{0, def.wave_height, def.wave_period, def.wave_from, def.seed},
                            Train{0, def.swell_height, def.swell_period, def.swell_from, def.seed}};
    for (std::size_t kind = 0; kind < trains_.size(); ++kind) {
        const bool room = std::ranges::any_of(
            trains_[kind], [&](const Train& there) { return there.gone() || there.same_as(wanted[kind]); });
        if (wanted[kind].height_after > 0 && !room) return false;
    }
    return true;
}

/// There is room for it, and the trains are settled.
void SeaSurface::change(const SeaDef& def, double t, double ramp) {
    const std::array wanted{Train{0, def.wave_height, def.wave_period, def.wave_from, def.seed},
                            Train{0, def.swell_height, def.swell_period, def.swell_from, def.seed}};
    for (std::size_t kind = 0; kind < trains_.size(); ++kind) {
        for (Train& there : trains_[kind])
            there.height_after = 0;
        if (wanted[kind].height_after == 0) continue;
        auto place = std::ranges::find_if(
            trains_[kind], [&](const Train& there) { return !there.gone() && there.same_as(wanted[kind]); });
        if (place == trains_[kind].end()) {
            place = std::ranges::find_if(trains_[kind], &Train::gone);
            *place = wanted[kind];
        }
        place->height_after = wanted[kind].height_after;
    }
    bool changes = false;
    for (const auto& kind : trains_)
        for (const Train& train : kind)
            changes = changes || train.height_before != train.height_after;
    ramp_begin_ = t, ramp_end_ = changes ? t + ramp : t;
    lay_out();
}

void SeaSurface::order(const SeaDef& def, double t, double ramp) {
    assert(ramp >= 0 && "the sea comes up from now on");
    settle(t);
    waiting_ = !has_room(def);
    if (!waiting_) {
        change(def, t, std::max(ramp, kSeaFade));
        return;
    }
    next_ = def;
    next_end_ = t + ramp;
    for (auto& kind : trains_) { // of two the lower one goes
        Train& lower = kind[0].height_before < kind[1].height_before ? kind[0] : kind[1];
        lower.height_after = 0;
    }
    ramp_begin_ = t, ramp_end_ = t + kSeaFade;
    lay_out();
}

bool SeaSurface::advance(double t) {
    if (ramp_begin_ == ramp_end_ || t < ramp_end_) return false;
    settle(t);
    if (waiting_) order(next_, t, next_end_ - t);
    return true;
}

/// The components of the trains that there are.
void SeaSurface::lay_out() {
    count_ = 0;
    ++made_;
    for (std::size_t kind = 0; kind < trains_.size(); ++kind) {
        for (const Train& train : trains_[kind]) {
            if (train.gone()) continue;
            const auto of_kind = static_cast<WaveKind>(kind);
            const auto number = static_cast<std::size_t>(components_of(of_kind));
            const std::span part(components_.data() + count_, number);
            cut_into_components({of_kind, train.period, train.from, train.seed}, depth_, part);
            for (WaveComponent& c : part) {
                c.amplitude_before *= train.height_before;
                c.amplitude_after *= train.height_after;
            }
            count_ += number;
        }
    }
}

double SeaSurface::height(double t) const {
    const double s = share(t);
    double squares = 0; // energies add up
    for (const auto& kind : trains_)
        for (const Train& train : kind) {
            const double height = train.height_before + s * (train.height_after - train.height_before);
            squares += height * height;
        }
    return std::sqrt(squares);
}

double SeaSurface::elevation(double x, double y, double t) const {
    const double s = share(t);
    double sum = 0;
    for (const WaveComponent& c : components())
        sum += (c.amplitude_before + s * (c.amplitude_after - c.amplitude_before)) *
               std::cos(c.k_x * x + c.k_y * y - c.omega * t + c.phase);
    return sum;
}

template <class Visitor, StateOf<SeaSurface> Self>
void visit_state(Visitor& v, Self& self) {
    constexpr double kAges = 1e10; // s, beyond any exercise
    for (auto& kind : self.trains_)
        for (auto& train : kind) {
            auto& [height_before, height_after, period, from, seed] = train;
            WINDLASS_STATE(v, height_before, height_after, period, from, seed);
            v.within({"height_before"}, height_before, 0, kMaxHeight);
            v.within({"height_after"}, height_after, 0, kMaxHeight);
            if (!train.gone()) v.within({"period"}, period, kMinPeriod, kMaxPeriod);
            WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, from);
        }
    WINDLASS_STATE(v, self.ramp_begin_, self.ramp_end_, self.waiting_, self.next_, self.next_end_);
    v.within({"ramp_begin"}, self.ramp_begin_, 0, kAges);
    v.within({"ramp_end"}, self.ramp_end_, self.ramp_begin_, kAges);
    v.within({"next_end"}, self.next_end_, 0, kAges);
    if constexpr (Visitor::kRestores) self.lay_out();
}
WINDLASS_STATE_LISTED(SeaSurface);

template <class Visitor, StateOf<SeaDef> State>
void visit_state(Visitor& v, State& def) {
    auto& [wave_height, wave_period, wave_from, swell_height, swell_period, swell_from, seed] = def;
    WINDLASS_STATE(v, wave_height, wave_period, wave_from, swell_height, swell_period, swell_from, seed);
    for (const double height : {wave_height, swell_height})
        v.within({"height"}, height, 0, kMaxHeight);
    WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, wave_from, swell_from);
    if (wave_height > 0) v.within({"wave_period"}, wave_period, kMinPeriod, kMaxPeriod);
    if (swell_height > 0) v.within({"swell_period"}, swell_period, kMinPeriod, kMaxPeriod);
}
WINDLASS_STATE_LISTED(SeaDef);

} // namespace windlass::physics
