#include "door/attempts.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstring>

namespace windlass::door {

double Attempts::used(const Used& used, Clock::time_point now) const {
    return std::max(0.0, used.tries - std::chrono::duration<double>(now - used.at) / each_);
}

double Attempts::wait(const std::string& key, Clock::time_point now) const {
    const auto found = used_.find(key);
    if (found == used_.end()) return 0;
    return std::max(0.0, used(found->second, now) + 1 - at_once_) * each_.count();
}

void Attempts::wrong(const std::string& key, Clock::time_point now) {
    if (used_.size() >= kKeys && !used_.contains(key)) make_room(now);
    Used& each = used_.try_emplace(key, Used{0, now}).first->second;
    each = {used(each, now) + 1, now};
}

void Attempts::right(const std::string& key) {
    const auto found = used_.find(key);
    if (found != used_.end()) found->second.tries = std::max(0.0, found->second.tries - 1);
}

/// Who has all tries again needs no place; where nobody has, who has most of them goes.
void Attempts::make_room(Clock::time_point now) {
    std::erase_if(used_, [&](const auto& each) { return used(each.second, now) == 0; });
    if (used_.size() < kKeys) return;
    used_.erase(
        std::ranges::min_element(used_, {}, [&](const auto& each) { return used(each.second, now); }));
}

std::string network_of(const std::string& address) {
    std::array<unsigned char, 16> octets{};
    if (inet_pton(AF_INET6, address.c_str(), octets.data()) != 1) return address;
    constexpr std::array<unsigned char, 12> kMapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (std::equal(kMapped.begin(), kMapped.end(), octets.begin()))
        return inet_ntop(AF_INET, &octets[12], text.data(), text.size());
    std::fill(octets.begin() + 8, octets.end(), 0);
    return std::string(inet_ntop(AF_INET6, octets.data(), text.data(), text.size())) + "/64";
}

} // namespace windlass::door
