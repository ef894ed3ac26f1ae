#include "bench/acceptance/holding.hpp"

#include "rigs/anchor_rig.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <array>
#include <utility>

namespace windlass::lab {

using namespace rigs;
using namespace physics;

namespace {

constexpr std::array<std::pair<Soil, const char*>, 7> kSoils{{{Soil::mud, "mud"},
                                                              {Soil::sand, "sand"},
                                                              {Soil::clay, "clay"},
                                                              {Soil::gravel, "gravel"},
                                                              {Soil::rock, "rock"},
                                                              {Soil::coral, "coral"},
                                                              {Soil::mixed, "mixed"}}};
constexpr std::array kShackles{6, 8, 10};
constexpr double kNewtonsPerKilonewton = 1000;

double kilonewtons(double newtons) {
    return newtons / kNewtonsPerKilonewton;
}

/// Closed form, simulated, difference: the last three columns of either table.
void write_compared(std::ostream& out, const Held& held) {
    fmt::print(out, " {:.0f} | {:.0f} | {:+.1f} % |\n", kilonewtons(held.closed_form()),
               kilonewtons(held.measured), 100 * (held.measured / held.closed_form() - 1));
}

} // namespace

void write_holding(std::ostream& out) {
    const TackleSetup setup;
    const AnchorDef hall = typical_anchor(AnchorType::hall);
    fmt::print(
        out,
        "\n## What anchor and cable hold\n\n"
        "A Hall anchor of {:.0f} kg on {:.0f} mm cable, dug in in 25 m with the hawse pipe 6 m above the "
        "water. Closed form: H = w_a λ_a + w_c λ_c l, with the anchor's weight in air, the cable's in "
        "water and l m of cable lying on the bottom. Simulated: the level pull at the hawse pipe as it "
        "begins to drag; tests hold it within 10 % (`HoldingPower`, `Uplift`).\n\n"
        "| soil | shackles | λ_a | anchor, kN | cable, kN | closed form, kN | simulated, kN | "
        "difference |\n|---|---|---|---|---|---|---|---|\n",
        hall.mass, 1000 * setup.chain.diameter);
    Held sand; // with the least cable
    for (const auto& [soil, name] : kSoils) {
        for (const int shackles : kShackles) {
            const Held held = held_flat(soil, metres_from_shackles(shackles));
            if (soil == Soil::sand && shackles == kShackles.front()) sand = held;
            fmt::print(out, "| {} | {} | {:.2g} | {:.0f} | {:.0f} |", name, shackles,
                       holding_factor(hall, soil), kilonewtons(held.anchor), kilonewtons(held.cable));
            write_compared(out, held);
        }
    }
    fmt::print(out,
               "\nHove short in sand and pulled at 0.05 m/s until it drags. Closed form: the angle of the "
               "catenary of that length whose level pull is what the anchor holds at that angle; 3/4 is left "
               "at 5°, 1/2 at 15°, 1/5 at 30° (practice). The first line is that of six shackles above, its "
               "cable on the bottom included.\n\n"
               "| cable, m | leads up by | simulated | share left | closed form, kN | simulated, kN | "
               "difference |\n|---|---|---|---|---|---|---|\n");
    const auto row = [&](double cable, double degrees, double share, const Held& held) {
        fmt::print(out, "| {:.0f} | {:.0f}° | {:.1f}° | {:.2f} |", cable, degrees,
                   degrees_from_radians(held.uplift), share);
        write_compared(out, held);
    };
    row(metres_from_shackles(kShackles.front()), 0, 1, sand);
    for (const ShortCable& each : kShortCables)
        row(each.cable, each.degrees, each.share, held_short(each));
}

} // namespace windlass::lab
