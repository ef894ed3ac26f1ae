#include "server/physics/chain/chain.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/chain/chain_forces.hpp"

#include <cmath>
#include <stdexcept>

namespace windlass::physics {

namespace {

// What a chain may be that is brought back from a file or over the wire: far beyond any that runs.
constexpr double kMinStep = 1e-6, kMaxStep = 1; // s
constexpr double kMaxStretch = 1;               // a link parts at a tenth

} // namespace

ChainState straight_chain(const ChainDef& def, const Vec3& anchor, const Vec3& hawse, double length,
                          int capacity) {
    // The top link has between half and one and a half of the spacing, as while veering.
    const int links = std::max(1, static_cast<int>(std::floor(length / def.node_spacing + 0.5)));
    if (length <= 0 || links > capacity)
        throw std::invalid_argument("chain does not fit the nodes reserved for it");
    ChainState state;
    state.links = links;
    state.top_length = length - (links - 1) * def.node_spacing;
    state.position = Field(capacity + 1);
    state.velocity = Field(capacity + 1);
    state.tension.resize(capacity);
    state.elastic_tension.resize(capacity);
    state.elastic_tension_before.resize(capacity);
    state.elastic_tension_earlier.resize(capacity);
    state.stretch.resize(capacity);
    for (int i = 0; i <= links; ++i) {
        const double along = i == links ? length : i * def.node_spacing;
        state.position.set(i, anchor + (hawse - anchor) * (along / length));
    }
    return state;
}

double chain_length(const ChainDef& def, const ChainState& state) {
    return (state.links - 1) * def.node_spacing + grown(def, state, 0, state.links - 1) + state.top_length;
}

double grown(const ChainDef& def, const ChainState& state, int first, int last) {
    double sum = 0;
    for (int i = first; i < std::min(last, state.stretched); ++i)
        sum += def.node_spacing * state.stretch[i];
    return sum;
}

double stretched_length(const ChainDef& def, const ChainState& state, double new_length) {
    const int piece = std::max(0, static_cast<int>(new_length / def.node_spacing));
    if (piece >= state.stretched) return new_length + grown(def, state, 0, piece);
    return new_length + grown(def, state, 0, piece) +
           (new_length - piece * def.node_spacing) * state.stretch[piece];
}

double new_length(const ChainDef& def, const ChainState& state, double stretched_length) {
    double left = stretched_length;
    for (int i = 0; i < state.stretched; ++i) {
        const double piece = piece_length(def, state, i);
        if (left <= piece) return i * def.node_spacing + left / (1 + state.stretch[i]);
        left -= piece;
    }
    return state.stretched * def.node_spacing + left;
}

double link_energy(const ChainDef& def, const ChainState& state, int i, double deck_length) {
    if (i == state.parted) return 0;
    const double rest = link_length(def, state, i);
    const double stretch = std::max(0.0, (state.position.at(i + 1) - state.position.at(i)).norm() - rest);
    const double deck = i == state.links - 1 ? deck_length : 0; // stretches with the top link
    return 0.5 * def.stiffness / (rest + deck) * stretch * stretch;
}

ChainEnergy chain_energy(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                         double deck_length) {
    ChainEnergy energy;
    for (int i = 1; i < state.links; ++i) {
        NodeMedium medium = node_medium(def, environment, state, i);
        set_on_bed(def, bed_under(environment, state.position.at(i)), medium);
        const Vec3 v = state.velocity.at(i);
        const double along = v.dot(medium.tangent);
        energy.kinetic += 0.5 * (medium.mass_normal * (v.squaredNorm() - along * along) +
                                 medium.mass_axial * along * along);
        energy.potential += node_potential(def, environment, state, i);
        const double sunk = medium.penetration;
        energy.elastic += 0.5 * medium.bed_stiffness * sunk * sunk;
    }
    for (int i = 0; i < state.links; ++i)
        energy.elastic += link_energy(def, state, i, deck_length);
    return energy;
}

template <class Visitor, StateOf<ChainState> State>
void visit_state(Visitor& v, State& state) {
    auto& [links, asleep, parted, last_step, stretched, top_length, position, velocity, tension,
           elastic_tension, elastic_tension_before, elastic_tension_earlier, stretch] = state;
    WINDLASS_STATE(v, links, asleep, parted, last_step, stretched, top_length);
    const auto room = static_cast<int>(tension.size()), pieces = static_cast<int>(stretch.size());
    v.within({"links"}, links, 1, room);
    v.within({"asleep"}, asleep, 0, links - 1);
    v.within({"parted"}, parted, -1, links - 1);
    if (last_step != 0) v.within({"last_step"}, last_step, kMinStep, kMaxStep); // rates are taken over it
    v.within({"stretched"}, stretched, 0, pieces);
    const auto nodes = static_cast<std::size_t>(links) + 1;
    v.numbers({"position_x"}, position.x.data(), nodes);
    v.numbers({"position_y"}, position.y.data(), nodes);
    v.numbers({"position_z"}, position.z.data(), nodes);
    v.numbers({"velocity_x"}, velocity.x.data(), nodes);
    v.numbers({"velocity_y"}, velocity.y.data(), nodes);
    v.numbers({"velocity_z"}, velocity.z.data(), nodes);
    const auto hold = [&](const char* x, const char* y, const char* z, const Field& field, double max) {
        v.all_within({x}, field.x.data(), nodes, -max, max);
        v.all_within({y}, field.y.data(), nodes, -max, max);
        v.all_within({z}, field.z.data(), nodes, -max, max);
    };
    hold("position_x", "position_y", "position_z", position, kFarthest);
    hold("velocity_x", "velocity_y", "velocity_z", velocity, kFastest);
    v.numbers({"tension"}, tension.data(), nodes - 1);
    v.numbers({"elastic_tension"}, elastic_tension.data(), nodes - 1);
    v.numbers({"elastic_tension_before"}, elastic_tension_before.data(), nodes - 1);
    v.numbers({"elastic_tension_earlier"}, elastic_tension_earlier.data(), nodes - 1);
    if constexpr (Visitor::kRestores) std::fill(stretch.begin() + stretched, stretch.end(), 0);
    v.numbers({"stretch"}, stretch.data(), static_cast<std::size_t>(stretched));
    v.all_within({"stretch"}, stretch.data(), static_cast<std::size_t>(stretched), 0, kMaxStretch);
    for (const std::vector<double>* force :
         {&tension, &elastic_tension, &elastic_tension_before, &elastic_tension_earlier})
        v.all_within({force == &tension ? "tension" : "elastic_tension"}, force->data(), nodes - 1, 0,
                     kStrongest);
}
WINDLASS_STATE_LISTED(ChainState);

} // namespace windlass::physics
