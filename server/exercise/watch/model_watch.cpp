#include "server/exercise/watch/model_watch.hpp"

#include <array>
#include <utility>

namespace windlass::exercise {

using physics::StepCounts;

namespace {

constexpr int kLook = 10, kTell = 60; ///< s of exercise time

/// Each kind, as it is called.
std::array<std::pair<std::uint64_t, const char*>, 6> kinds(const StepCounts& counts) {
    return {{{counts.implicit, "implicit"},
             {counts.unsolved, "unsolved"},
             {counts.friction, "with friction of the step's start"},
             {counts.contacts, "with contacts unsettled"},
             {counts.dropped, "with contacts left out"},
             {counts.capped, "too long"}}};
}

/// Steps of any kind, those of several counted several times.
double share(const StepCounts& counts) {
    double sum = 0;
    for (const auto& [number, name] : kinds(counts))
        sum += static_cast<double>(number);
    return counts.steps > 0 ? sum / static_cast<double>(counts.steps) : 0;
}

} // namespace

std::string words(const StepCounts& counts) {
    std::string text = "of " + std::to_string(counts.steps) + " steps of the cables";
    const char* before = " ";
    for (const auto& [number, name] : kinds(counts)) {
        if (number == 0) continue;
        text += before + std::to_string(number) + ' ' + name;
        before = ", ";
    }
    return text;
}

void ModelWatch::look(std::uint64_t tick, int rate, const StepCounts& counts, const EventLog& log) {
    const auto seconds = [&](int s) {
        return static_cast<std::uint64_t>(s) * static_cast<std::uint64_t>(rate);
    };
    if (tick % seconds(kLook) != 0) return;
    last_ = counts - looked_;
    looked_ = counts;
    const bool doubt = physics::in_doubt(last_);
    if (doubt && !in_doubt_) log("model.in_doubt", -1, share(last_), "in the last 10 s " + words(last_));
    in_doubt_ = doubt;
    if (tick % seconds(kTell) != 0) return;
    const StepCounts minute = counts - told_;
    told_ = counts;
    if (share(minute) > 0) log("model.steps", -1, share(minute), "in the last minute " + words(minute));
}

template <class Visitor, physics::StateOf<ModelWatch> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.last_, self.looked_, self.told_, self.in_doubt_);
}
WINDLASS_STATE_LISTED(ModelWatch);

} // namespace windlass::exercise
