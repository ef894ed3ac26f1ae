#include "door/staff_sessions.hpp"

#include <algorithm>

namespace windlass::door {

void StaffSessions::begin(const std::string& key, const std::string& name, const std::string& address,
                          Clock::time_point now) {
    if (sessions_.size() >= kMost)
        sessions_.erase(
            std::ranges::min_element(sessions_, {}, [](const auto& each) { return each.second.used; }));
    sessions_[key] = {name, address, now};
}

std::string StaffSessions::find(const std::string& key, const std::string& address, Clock::time_point now) {
    const auto found = sessions_.find(key);
    if (found == sessions_.end() || found->second.address != address) return {};
    if (now - found->second.used > kUnused) {
        sessions_.erase(found);
        return {};
    }
    found->second.used = now;
    return found->second.name;
}

std::vector<std::string> StaffSessions::end_of(const std::string& name) {
    std::vector<std::string> keys;
    std::erase_if(sessions_, [&](const auto& each) {
        const bool its = each.second.name == name;
        if (its) keys.push_back(each.first);
        return its;
    });
    return keys;
}

} // namespace windlass::door
