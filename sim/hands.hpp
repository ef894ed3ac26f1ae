#pragma once
// Scripted stations: a trainee at each windlass, a second one at the port one, the helm, and an instructor's
// desk, which takes levers, too; now and then a second desk, of which the one that takes them over last has
// them. They move levers, fall silent, let go, are killed and come back; the desk orders, floods, and sets
// going again what stands still.

#include "server/run/status.hpp"
#include "sim/network.hpp"

#include <memory>

namespace windlass::sim {

/// What the stations were told of the exercise last.
struct Told {
    std::uint64_t run = 0; ///< 0: nothing yet
    exercise::RunState state = exercise::RunState::running;
    double time = 0; ///< s of exercise
    std::vector<run::AlertView> alerts{};
};

class Hands {
public:
    /// Begins to work. sides: how many windlasses there are.
    Hands(World& world, Network& network, std::uint64_t seed, std::size_t sides);

    /// They are told, after a while.
    void tell(Told told);

private:
    /// A station whose hand works some levers.
    struct Hand {
        std::string name;
        int levers = 0; // 0 port, 1 starboard, 2 helm
        bool instructor = false;
        int strength = 10;
        wire::WriterId writer{};
        std::uint64_t serial = 0, moved_in_run = 0;
        std::array<double, 5> at{1, 0, 0, 0, 0}; // as on WindlassCommand, or HelmCommand
        std::array<double, 5> moved_at{};
        bool joined = false;
        Chance* chance = nullptr; // that its work is drawn by
    };

    void join(Hand& hand);
    void work(Hand& hand);
    void move(Hand& hand);
    void speak(Hand& hand);
    void desk();
    template <class Sample>
    void order(Sample sample);
    void run_order(ExerciseAction action, double value = 0);
    void flood();

    World& world_;
    Network& network_;
    Chance second_desk_; // of its own, as most seeds have none
    const std::size_t sides_;
    std::vector<std::unique_ptr<Hand>> hands_;
    Told told_;
    std::uint64_t writers_ = 0, desk_serial_ = 0;
    wire::WriterId desk_;
};

} // namespace windlass::sim
