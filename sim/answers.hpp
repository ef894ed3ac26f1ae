#pragma once
// Those who sit at the forecastle and on the bridge, as a lesson asks them something: they answer soon or
// late, right or wrong, twice, what was not asked, or not at all.

#include "server/run/status.hpp"
#include "sim/network.hpp"

#include <array>

namespace windlass::sim {

class Answers {
public:
    /// Draws from a chance of its own: where nobody is asked, nothing of the seed changes.
    Answers(World& world, Network& network, std::uint64_t seed);

    /// A seat is told what it is asked, after a while.
    void tell(const run::QuestionView& question);

private:
    struct Seat {
        bool forecastle = true;
        wire::WriterId writer{};
        std::uint64_t serial = 0;
        std::uint64_t told = 0; ///< how often it was told what it is asked, or that it is asked no more
    };
    void answer(Seat& seat, const run::QuestionView& question, std::uint64_t told);
    void give(Seat& seat, Answer answer);

    World& world_;
    Network& network_;
    Chance chance_;
    std::array<Seat, 2> seats_;
};

} // namespace windlass::sim
