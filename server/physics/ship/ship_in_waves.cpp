#include "server/physics/ship/ship_in_waves.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/ship/wave_response.hpp"

#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

/// rad: short waves on a long ship change their sign within 10 degrees of heading.
constexpr double kCell = std::numbers::pi / 180;

} // namespace

void ShipInWaves::respond(const SeaSurface& sea, double heading, Responses& to) const {
    std::size_t i = 0;
    for (const WaveComponent& c : sea.components()) {
        // Clockwise from north both, and from ahead anticlockwise: as her axes turn.
        const double towards = heading - std::atan2(c.k_x, c.k_y);
        const WaveResponse r = wave_response(def_, c.omega, std::hypot(c.k_x, c.k_y), depth_, towards);
        to.surge[i] = r.surge.imag();
        to.sway[i] = -r.sway.imag();
        to.heave[i] = r.heave.real();
        to.pitch[i] = r.pitch.imag();
        to.roll[i] = r.roll.real();
        to.roll_behind[i] = r.roll.imag();
        to.ahead[i] = r.drift_surge;
        to.abeam[i] = -r.drift_sway;
        ++i;
    }
}

WaveMotion ShipInWaves::motion(const SeaSurface& sea, const ShipPlace& ship, double t) {
    if (sea.flat()) return {};
    const double cells = ship.heading / kCell, whole = std::floor(cells);
    const auto cell = static_cast<int>(whole);
    if (sea.made() != made_ || cell != cell_) {
        respond(sea, whole * kCell, low_);
        respond(sea, (whole + 1) * kCell, high_);
        cell_ = cell;
        made_ = sea.made();
    }
    const double share = cells - whole, ramp = sea.share(t);
    const auto between = [=](double low, double high) { return low + share * (high - low); };
    WaveMotion m;
    // Waves from ahead, from astern; from port, from starboard: cosine and sine parts of a sum each.
    std::array<std::array<double, 2>, 4> drift{};
    std::size_t i = 0;
    for (const WaveComponent& c : sea.components()) {
        const double a = c.amplitude_before + ramp * (c.amplitude_after - c.amplitude_before);
        const double phase = c.k_x * ship.x + c.k_y * ship.y - c.omega * t + c.phase;
        const double turns = c.k_x * ship.east + c.k_y * ship.north - c.omega; // rad/s, as she meets it
        const double cosine = a * std::cos(phase), sine = a * std::sin(phase);
        const double surge = between(low_.surge[i], high_.surge[i]);
        const double sway = between(low_.sway[i], high_.sway[i]);
        const double heave = between(low_.heave[i], high_.heave[i]);
        const double pitch = between(low_.pitch[i], high_.pitch[i]);
        const double roll = between(low_.roll[i], high_.roll[i]);
        const double roll_behind = between(low_.roll_behind[i], high_.roll_behind[i]);
        m.surge -= surge * sine, m.surge_speed -= turns * surge * cosine;
        m.sway -= sway * sine, m.sway_speed -= turns * sway * cosine;
        m.heave += heave * cosine, m.heave_speed -= turns * heave * sine;
        m.pitch -= pitch * sine, m.pitch_rate -= turns * pitch * cosine;
        m.roll += roll * cosine - roll_behind * sine;
        m.roll_rate -= turns * (roll * sine + roll_behind * cosine);
        const double ahead = between(low_.ahead[i], high_.ahead[i]);
        const double abeam = between(low_.abeam[i], high_.abeam[i]);
        auto& fore_and_aft = drift[ahead < 0 ? 0 : 1];
        auto& athwart = drift[abeam < 0 ? 2 : 3];
        fore_and_aft[0] += ahead * cosine, fore_and_aft[1] += ahead * sine;
        athwart[0] += abeam * cosine, athwart[1] += abeam * sine;
        ++i;
    }
    const auto square = [&](std::size_t k) { return drift[k][0] * drift[k][0] + drift[k][1] * drift[k][1]; };
    m.drift_ahead = square(1) - square(0);
    m.drift_abeam = square(3) - square(2);
    return m;
}

template <class Visitor, StateOf<WaveMotion> State>
void visit_state(Visitor& v, State& motion) {
    auto& [surge, sway, heave, roll, pitch, surge_speed, sway_speed, heave_speed, roll_rate, pitch_rate,
           drift_ahead, drift_abeam] = motion;
    WINDLASS_STATE(v, surge, sway, heave, roll, pitch, surge_speed, sway_speed, heave_speed, roll_rate,
                   pitch_rate, drift_ahead, drift_abeam);
    constexpr double kHighest =
        200; // m, and m/s: more than any sea moves her; a foreign model may say more than ours
    constexpr double kMostRolled = 7; // rad, and rad/s
    WINDLASS_WITHIN(v, -kHighest, kHighest, surge, sway, heave, surge_speed, sway_speed, heave_speed);
    WINDLASS_WITHIN(v, -kMostRolled, kMostRolled, roll, pitch, roll_rate, pitch_rate);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, drift_ahead, drift_abeam);
}
WINDLASS_STATE_LISTED(WaveMotion);

} // namespace windlass::physics
