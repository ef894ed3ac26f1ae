#include "server/assess/chance.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::assess {

namespace {

constexpr int kSeedBits = 52; // a double of 0..1 has each of these seeds

enum class Drawn { delay, severity, kind };

/// 0..1, of one thing that is drawn. SplitMix64 (Steele, Lea, Flood 2014): neighbouring seeds have nothing in
/// common.
double share(const State& state, std::size_t place, Drawn what) {
    std::uint64_t z = static_cast<std::uint64_t>(state.seed) +
                      0x9E3779B97F4A7C15U * (3 * place + static_cast<std::size_t>(what) + 1);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    z ^= z >> 31;
    return std::ldexp(static_cast<double>(z >> 11), -53);
}

double between(const std::array<double, 2>& bounds, double share) {
    return bounds[0] + share * (bounds[1] - bounds[0]);
}

/// Whether it is the one of its kinds that this attempt has.
bool is_drawn(const Lesson& lesson, const State& state, std::size_t fault) {
    const std::string& kinds = lesson.faults[fault].one_of;
    if (kinds.empty()) return true;
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < lesson.faults.size(); ++k)
        if (lesson.faults[k].one_of == kinds) all.push_back(k);
    const double drawn = share(state, all.front(), Drawn::kind);
    return all[static_cast<std::size_t>(drawn * static_cast<double>(all.size()))] == fault;
}

} // namespace

void draw(const Lesson& lesson, State& state, const exercise::ChanceDrawn& drawn) {
    const bool any = std::ranges::any_of(lesson.faults, [](const LessonFault& fault) {
        return fault.delay[1] > 0 || fault.severity || !fault.one_of.empty();
    });
    if (any && state.seed == 0) state.seed = 1 + std::llround(std::ldexp(drawn.chance, kSeedBits));
}

exercise::ChanceDrawn drawn_for(std::int64_t seed) {
    return {.chance = seed == 0 ? 0 : std::ldexp(static_cast<double>(seed - 1), -kSeedBits)};
}

bool comes(const Lesson& lesson, State& state, std::size_t fault, const exercise::Snapshot& seen,
           int tick_rate) {
    const LessonFault& one = lesson.faults[fault];
    std::int64_t& since = state.fault_since[fault];
    if (holds(one.when, lesson, state, seen, tick_rate) && since < 0) since = state.tick;
    if (since < 0 || !is_drawn(lesson, state, fault)) return false;
    const double delay = between(one.delay, share(state, fault, Drawn::delay));
    return state.tick - since >= std::llround(delay * tick_rate);
}

exercise::FaultOrder drawn_fault(const Lesson& lesson, const State& state, std::size_t fault) {
    const LessonFault& one = lesson.faults[fault];
    exercise::FaultOrder order = one.order;
    if (one.severity) order.severity = between(*one.severity, share(state, fault, Drawn::severity));
    return order;
}

} // namespace windlass::assess
