#include "server/physics/sea/soil.hpp"

#include <array>

namespace windlass::physics {

namespace {

// Friction: 0.4 to 0.8 depending on the seabed (OrcaFlex help, "Chain"); lambda_c 0.75 (New Asian handout);
//   sliding on sand 0.74, mud with sand 0.69, mud or clay 0.56 (NCEL, Taylor and Valent 1984, from memory).
// Stiffness: OrcaFlex's default is 1e5. Mud's strength grows with depth, so that it bears like a spring: Nc x
//   gradient x width, with Nc = 7.6, 1.5 kPa/m of a soft normally consolidated clay, and chain as wide as 2.5
//   of its 3.6 diameters (Degenkamp and Dutta 1989), from memory, is 7.6 x 1500 x 2.5 / 3.6 = 8e3: a 78 mm
//   chain sinks in by half a metre. The hard ones are as stiff as a step follows them.
// Suction: 0.7 of the push in soft clay is what riser models take (Randolph and Quiggin 2009, from memory).
constexpr std::array<ChainBed, 7> kBeds{
    {{.friction = 0.56, .stiffness = 8e3, .suction = 0.7},    // mud
     {.friction = 0.75, .stiffness = 1e5, .suction = 0},      // sand
     {.friction = 0.56, .stiffness = 1e5, .suction = 0.7},    // clay; firm: chain hardly sinks in
     {.friction = 0.75, .stiffness = 3e5, .suction = 0},      // gravel: as sand, tuned
     {.friction = 0.50, .stiffness = 1e7, .suction = 0},      // rock: steel on stone, tuned
     {.friction = 0.80, .stiffness = 3e6, .suction = 0},      // coral: links catch, tuned
     {.friction = 0.69, .stiffness = 3e4, .suction = 0.35}}}; // mixed: between mud and sand, tuned

} // namespace

const ChainBed& chain_bed(Soil soil) {
    return kBeds.at(static_cast<std::size_t>(soil));
}

} // namespace windlass::physics
