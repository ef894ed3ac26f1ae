#pragma once
// Who is logged in. Pure: time is given.

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace windlass::door {

using Clock = std::chrono::steady_clock;

/// By the key of a cookie. A session is good at the address where it was begun, until it has not been used
/// for half a day: a cookie that was stolen is of no use elsewhere.
class StaffSessions {
public:
    static constexpr std::size_t kMost = 256; ///< then the one that was not used for longest ends
    static constexpr auto kUnused = std::chrono::hours(12);

    void begin(const std::string& key, const std::string& name, const std::string& address,
               Clock::time_point now);

    /// Whose it is; empty: nobody's, there and now.
    std::string find(const std::string& key, const std::string& address, Clock::time_point now);

    void end(const std::string& key) { sessions_.erase(key); }
    /// All of that name. Returns their keys.
    std::vector<std::string> end_of(const std::string& name);

private:
    struct Staff {
        std::string name, address;
        Clock::time_point used;
    };
    std::map<std::string, Staff> sessions_;
};

} // namespace windlass::door
