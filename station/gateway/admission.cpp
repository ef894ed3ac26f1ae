#include "station/gateway/admission.hpp"

#include "idl/wire.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace windlass::gateway {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kLongestTarget = 2048;
constexpr std::size_t kMostAddresses = 1000; // whose wrong tokens are counted

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

std::vector<std::string> parts(const std::string& text, char between) {
    std::vector<std::string> found;
    std::istringstream rest(text);
    for (std::string part; std::getline(rest, part, between);)
        found.push_back(part);
    return found;
}

/// Values of "a=1&b=2". Nothing that we are asked with needs an escape.
std::map<std::string, std::string> values(const std::string& query) {
    std::map<std::string, std::string> found;
    for (const std::string& text : parts(query, '&')) {
        const auto equals = text.find('=');
        if (equals != std::string::npos) found[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return found;
}

/// The first of ours that is offered; empty: none.
template <std::size_t N>
std::string chosen(const std::string& offered, const std::array<const char*, N>& ours) {
    for (const char* name : ours)
        for (std::string text : parts(offered, ',')) {
            text.erase(0, text.find_first_not_of(" \t"));
            text.erase(text.find_last_not_of(" \t") + 1);
            if (text == name) return text;
        }
    return {};
}

} // namespace

std::string make_token() {
    std::array<unsigned char, 16> octets{};
    if (getentropy(octets.data(), octets.size()) != 0)
        throw std::runtime_error("the system gives no random numbers (getentropy)");
    std::string token;
    for (const unsigned char octet : octets)
        token += fmt::format("{:02x}", octet);
    return token;
}

bool same_token(const std::string& given, const std::string& right) {
    if (given.size() != right.size()) return false;
    unsigned char differs = 0;
    for (std::size_t i = 0; i < right.size(); ++i)
        differs |= static_cast<unsigned char>(given[i] ^ right[i]);
    return differs == 0;
}

Admission::Admission(AdmissionOptions options, const Assets& assets)
    : options_{std::move(options)}, assets_{assets} {}

bool Admission::our_origin(const std::string& origin) const {
    return std::ranges::any_of(options_.hosts, [&](const std::string& host) {
        return lower(origin) == (options_.tls ? "https://" : "http://") + host;
    });
}

Verdict Admission::judge(const Request& request, Clock::time_point now) {
    if (std::ranges::find(options_.hosts, lower(request.host)) == options_.hosts.end())
        return refused(421, "this host is not served here");
    const auto question = request.target.find('?');
    const std::string path = request.target.substr(0, question);
    const std::string query = question == std::string::npos ? "" : request.target.substr(question + 1);
    const bool foxglove = path == "/foxglove" && options_.foxglove;
    if (!request.origin.empty() && !our_origin(request.origin) &&
        !(foxglove && std::ranges::find(options_.foxglove_origins, lower(request.origin)) !=
                          options_.foxglove_origins.end()))
        return refused(403, "pages of this origin are not served here");
    if (request.method != "GET" && request.method != "HEAD") return refused(405, "GET and HEAD only");
    if (request.target.size() > kLongestTarget) return refused(414, "the address is too long");
    if (path == "/ws" || foxglove) return judge_upgrade(request, path, query, now);
    auto file = assets_.find(path);
    if (file == nullptr) return refused(404, "there is no such page");
    return {.kind = Verdict::Kind::file, .file = std::move(file)};
}

Verdict Admission::judge_upgrade(const Request& request, const std::string& path, const std::string& query,
                                 Clock::time_point now) {
    const auto given = values(query);
    const auto value = [&](const char* name) {
        const auto found = given.find(name);
        return found == given.end() ? std::string() : found->second;
    };
    if (!same_token(value("token"), options_.token))
        return refused(wrong_token(request.address, now),
                       "a token is needed: open the address that the station's program prints");
    const bool page = path == "/ws";
    static constexpr std::array<const char*, 1> kPage{"windlass.v1"};
    static constexpr std::array<const char*, 2> kFoxglove{"foxglove.sdk.v1", "foxglove.websocket.v1"};
    const std::string subprotocol =
        page ? chosen(request.subprotocols, kPage) : chosen(request.subprotocols, kFoxglove);
    if (!request.upgrade || request.method != "GET" || subprotocol.empty())
        return refused(400, page ? "a WebSocket with subprotocol windlass.v1 is expected"
                                 : "a WebSocket with subprotocol foxglove.sdk.v1 or foxglove.websocket.v1 "
                                   "is expected");
    const std::string named = value("exercise");
    const std::string exercise = named.empty() ? options_.exercise : named;
    if (!wire::is_exercise_name(exercise))
        return refused(400, "an exercise has 1 to 64 letters, digits, dots, dashes and underscores");
    if (exercise != options_.exercise && !options_.any_exercise)
        return refused(403, "this seat is in exercise " + options_.exercise);
    return {.kind = page ? Verdict::Kind::page : Verdict::Kind::foxglove,
            .status = 101,
            .exercise = exercise,
            .subprotocol = subprotocol};
}

/// The status to answer with. A right token is never kept out by another's wrong ones.
int Admission::wrong_token(const std::string& address, Clock::time_point now) {
    if (wrong_.size() > kMostAddresses) wrong_.clear();
    auto& times = wrong_[address];
    while (!times.empty() && now - times.front() > 1s)
        times.pop_front();
    if (times.size() >= kWrongTokens) return 429;
    times.push_back(now);
    return 403;
}

} // namespace windlass::gateway
