#pragma once
// How often somebody may be wrong. Pure: time is given.

#include <chrono>
#include <map>
#include <string>

namespace windlass::door {

using Clock = std::chrono::steady_clock;

/// For each key (an address, a name at an address) so many wrong tries at once, then one each so often. What
/// one key has used up is no other's: who guesses keeps nobody out who comes from elsewhere.
class Attempts {
public:
    static constexpr std::size_t kKeys = 10'000; ///< that are counted at a time, at most

    Attempts(int at_once, std::chrono::duration<double> each) : at_once_{at_once}, each_{each} {}

    /// s until that key may try again; 0: now.
    double wait(const std::string& key, Clock::time_point now) const;

    /// It has tried, and was wrong.
    void wrong(const std::string& key, Clock::time_point now);

    /// The last was right after all.
    void right(const std::string& key);

private:
    struct Used {
        double tries; // at that moment; they come back with time
        Clock::time_point at;
    };
    double used(const Used& used, Clock::time_point now) const;
    void make_room(Clock::time_point now);

    const int at_once_;
    const std::chrono::duration<double> each_;
    std::map<std::string, Used> used_;
};

/// Whose tries are counted together: an IPv4 address, of IPv6 the network of 64 bits, which is one house's.
std::string network_of(const std::string& address);

} // namespace windlass::door
