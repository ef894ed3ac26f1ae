#pragma once
// The simulated world: its clock, what is to happen in it, and the chance by which it is drawn. One thread;
// the same seed gives the same world.

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>

namespace windlass::sim {

/// How a server is lost.
enum class Loss {
    killed,   ///< what was handed to the system is there
    power_cut ///< what the disk was waited for is there; of the rest, any part
};

/// The server is lost at this instant. No std::exception, so that no part of the server gets over it.
struct Crash {
    Loss how;
};

/// The server has ended by itself, as it was told to begin anew. No std::exception either.
struct Left {};

/// A check that failed. No std::exception either.
struct Failure {
    std::string check, expected, found;
};

/// Draws, the same on every machine.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : bits_(seed) {}
    std::uint64_t bits() { return bits_(); }
    double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; } ///< 0 up to 1
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Many small ones and few large ones, between two that are above 0.
    double spread(double low, double high);
    bool in(double share) { return unit() < share; }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }

private:
    std::mt19937_64 bits_;
};

class World {
public:
    using Time = std::chrono::steady_clock::time_point;

    using Story = std::function<void(double at, const std::string& what)>;

    /// story: hears what is drawn; may be empty.
    explicit World(std::uint64_t seed, Story story = {}) : chance_(seed), story_(std::move(story)) {}

    Chance& chance() { return chance_; }
    double now() const { return now_; } ///< s
    /// The same as a server reads it.
    Time time() const;
    double seconds(Time time) const; ///< of the world, at that time

    /// For who wants to understand a seed.
    void tell(const std::string& what) const {
        if (story_) story_(now_, what);
    }

    /// Something is to happen then (s); at once, where that is past.
    void at(double when, std::function<void()> what) {
        due_.emplace(std::pair(when, ++count_), std::move(what));
    }
    /// All that is due up to then happens, one thing after the other. Whoever waits for something, as for a
    /// slow disk, calls this himself: the others go on meanwhile.
    void run_until(double when);

private:
    Chance chance_;
    Story story_;
    double now_ = 0;
    std::uint64_t count_ = 0;
    std::map<std::pair<double, std::uint64_t>, std::function<void()>> due_;
};

} // namespace windlass::sim
