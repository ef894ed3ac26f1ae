#include "server/host/pacer.hpp"

#include <algorithm>

namespace windlass::host {

namespace {

using Seconds = std::chrono::duration<double>;

/// An order is heard within this. Shorter, most of what a beat costs is a thread that wakes, to find in its
/// caches what other exercises have left there.
constexpr Seconds kBeat{0.010};
constexpr double kRounding = 1e-6; // a tick of 1/300 s goes three times into a beat
constexpr Seconds kMeasuringTime{1.0};

} // namespace

Pacer::Pacer(double dt, double scale, Time now) : dt_(dt), scale_(scale), due_(now), measured_since_(now) {}

void Pacer::set_tick(double dt, Time now) {
    dt_ = dt;
    restart(now);
}

void Pacer::set_scale(double scale, Time now) {
    scale_ = scale;
    restart(now);
}

void Pacer::hold_back(bool held, Time now) {
    if (held == held_back_) return;
    held_back_ = held;
    due_ = now;
}

void Pacer::set_standing(bool standing, Time now) {
    if (standing == standing_) return;
    standing_ = standing;
    restart(now);
}

void Pacer::restart(Time now) {
    due_ = now;
    measured_since_ = now;
    ticks_measured_ = 0;
    achieved_ = standing_ ? 0 : scale_;
}

int Pacer::ticks_per_beat() const {
    if (standing_ || rate() <= 0) return 1;
    return std::max(1, static_cast<int>(kBeat.count() * rate() / dt_ + kRounding));
}

std::chrono::nanoseconds Pacer::period(int ticks) const {
    const Seconds period = standing_ ? kBeat : Seconds(std::max(1, ticks) * dt_ / rate());
    return std::chrono::duration_cast<std::chrono::nanoseconds>(period);
}

void Pacer::beat_ended(int ticks, Time now) {
    lateness_ = 0;
    due_ = rate() > 0 || standing_ ? due_ + period(ticks) : now;
    if (now > due_) {
        if (!standing_) {
            ++overruns_;
            lateness_ = Seconds(now - due_).count();
        }
        due_ = now;
    }
    measure(ticks, now);
}

void Pacer::measure(int ticks, Time now) {
    ticks_measured_ += ticks;
    const Seconds elapsed = now - measured_since_;
    if (elapsed < kMeasuringTime) return;
    achieved_ = static_cast<double>(ticks_measured_) * dt_ / elapsed.count();
    measured_since_ = now;
    ticks_measured_ = 0;
}

} // namespace windlass::host
