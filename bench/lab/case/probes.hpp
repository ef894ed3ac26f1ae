#pragma once
// What is written down of a method at work.

#include "bench/problem/method.hpp"

#include <array>
#include <optional>

namespace windlass::lab {

/// What a probe measures.
enum class Quantity { tension, x, y, z, kinetic_energy, potential_energy, elastic_energy, total_energy };
inline constexpr std::array kQuantityNames{
    "tension",        "x",           "y", "z", "kinetic_energy", "potential_energy",
    "elastic_energy", "total_energy"}; ///< in that order

/// One probe. A tension at an end is that of the end link, which a method knows at the link's middle; at an
/// arc it lies on the straight line between the middles of the links around it.
struct Probe {
    std::string name;
    Quantity quantity = Quantity::tension;
    std::optional<double> arc; ///< m of unstretched length from the lower end; nothing: of the whole line
    std::optional<int> node;   ///< instead of arc
};

/// "N", "m" or "J".
std::string unit_of(Quantity quantity);

/// Reads probes off one method. Energies count what the method models: chain, masses at the ends, seabed.
class Meter {
public:
    Meter(const Problem& problem, const Method& method);
    double read(const Probe& probe);

private:
    double tension(double arc) const;
    Vec3 place(double arc) const;
    physics::ChainEnergy energy();

    const Problem& problem_;
    const Method& method_;
    physics::ChainDef def_;
    physics::ChainState state_; ///< to hold the method's nodes while their energy is summed
};

} // namespace windlass::lab
