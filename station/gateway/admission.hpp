#pragma once
// Who is let in: what a request asks for, and whether it is answered. Pure, so that all of it is tested
// without a network.

#include "station/gateway/assets.hpp"
#include "station/gateway/history.hpp"
#include "station/gateway/request.hpp"

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace windlass::gateway {

/// 128 random bits of the kernel's (getentropy(3), which no clock and no earlier one lets guess) in 32
/// hexadecimal digits. Throws std::runtime_error where the kernel gives none.
std::string make_token();

/// The same time for every wrong one of the right length.
bool same_token(const std::string& given, const std::string& right);

struct AdmissionOptions {
    std::vector<std::string> hosts; ///< "127.0.0.1:8765": the names under which we are reached
    bool tls = false;               ///< our own origins are https://HOST
    std::string token;
    std::string exercise;                      ///< that the program joined
    bool any_exercise = false;                 ///< the seat may name another
    bool foxglove = false;                     ///< /foxglove is served
    std::vector<std::string> foxglove_origins; ///< whose pages may open it, beside our own
};

class Admission {
public:
    static constexpr int kWrongTokens = 5; ///< in a second, from one address, before 429

    Admission(AdmissionOptions options, const Assets& assets);

    Verdict judge(const Request& request, Clock::time_point now);

private:
    Verdict judge_upgrade(const Request& request, const std::string& path, const std::string& query,
                          Clock::time_point now);
    int wrong_token(const std::string& address, Clock::time_point now);
    bool our_origin(const std::string& origin) const;

    AdmissionOptions options_;
    const Assets& assets_;
    std::map<std::string, std::deque<Clock::time_point>> wrong_; ///< by address
};

} // namespace windlass::gateway
