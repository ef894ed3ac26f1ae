#pragma once
// What a seabed is made of, and what that does to chain that lies on it.

namespace windlass::physics {

/// What the seabed is made of. Mixed: mud with sand.
enum class Soil { mud, sand, clay, gravel, rock, coral, mixed };
constexpr Soil last_of(Soil) {
    return Soil::mixed;
}

/// A soil under chain.
struct ChainBed {
    double friction;  ///< Coulomb's coefficient, -
    double stiffness; ///< N/m per m of chain and per m of its width: how far chain sinks in
    double suction;   ///< of the bearing push, the pull with which soil holds back chain that is lifted, -
};

/// Figures and sources in soil.cpp.
const ChainBed& chain_bed(Soil soil);

} // namespace windlass::physics
