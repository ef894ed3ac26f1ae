#include "trainee_client/progress.hpp"

#include <fmt/format.h>

namespace windlass::trainee {

namespace {
constexpr double kOwnSleep = 1; // s; of a longer time between two looks this program slept the rest itself
}

void Progress::look(double time, double time_scale, bool running, Time now) {
    scale_ = time_scale;
    if (!running) {
        last_.reset();
        stood_ = 0;
        return;
    }
    if (last_) {
        const double wall = std::chrono::duration<double>(now - last_->at).count();
        stood_ = time == last_->time ? stood_ + std::min(wall, kOwnSleep) : 0;
        time_run_ += std::max(time - last_->time, 0.0);
        wall_ += wall;
    }
    last_ = {time, now};
}

bool Progress::slow() const {
    return wall_ > 1 && scale_ > 0 && time_run_ < 0.9 * scale_ * wall_;
}

std::string Progress::speed() const {
    if (wall_ <= 1) return "this machine has not run the exercise for a second yet";
    const std::string ran = fmt::format("this machine runs at x{:.2g}", time_run_ / wall_);
    return scale_ > 0 ? fmt::format("{} of the x{:g} asked", ran, scale_) : ran;
}

} // namespace windlass::trainee
