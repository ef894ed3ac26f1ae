#pragma once
// A page without a browser: what it is told, and what it says. Beast shows in page_client.cpp alone: it is
// slow to compile.

#include "recorder/recording/typed.hpp"
#include "rigs/wait.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace windlass::test {

/// "http://127.0.0.1:8765/forecastle#token=..." that a program has printed.
struct PageAddress {
    unsigned short port = 0;
    std::string token;

    /// The first in a text.
    static std::optional<PageAddress> in(const std::string& text) {
        const auto begin = text.find("http://127.0.0.1:"), token = text.find("#token=", begin);
        if (begin == std::string::npos || text.find('\n', token) == std::string::npos) return std::nullopt;
        return PageAddress{static_cast<unsigned short>(std::stoi(text.substr(begin + 17))),
                           text.substr(token + 7, 32)};
    }
};

class PageClient {
public:
    using Json = nlohmann::json;
    using Payload = std::vector<std::uint8_t>;

    struct Options {
        std::string exercise{}; ///< empty: none is named
        std::string origin = "http://127.0.0.1:PORT";
        std::string subprotocol = "windlass.v1";
        bool subscribes = true; ///< to all that is advertised
        std::string target{};   ///< empty: "/ws" with token and exercise
        std::string cookie{};
    };

    explicit PageClient(const PageAddress& address);

    /// Throws std::runtime_error when it is not let in.
    PageClient(const PageAddress& address, const Options& options);
    ~PageClient();
    PageClient(const PageClient&) = delete;
    PageClient& operator=(const PageClient&) = delete;

    void say(const Json& message) { say(message.dump(), true); }
    void say(const std::string& bytes, bool text);

    /// Messages with that op so far.
    std::vector<Json> told(const std::string& op) const;
    /// The newest of them that has all of these fields; waits for it. Null: none came.
    Json wait_for(const std::string& op, const Json& fields = Json::object()) const;

    std::vector<Payload> samples(const std::string& topic) const;
    /// ns of the samples, in the same order.
    std::vector<std::uint64_t> stamps(const std::string& topic) const;
    /// ns that its clock was told.
    std::vector<std::uint64_t> times() const;
    template <class T>
    std::vector<T> all(const std::string& topic) const {
        std::vector<T> found;
        for (const Payload& payload : samples(topic))
            found.push_back(recording::decode<T>(payload));
        return found;
    }
    /// Names of channels, by number.
    std::map<std::uint32_t, std::string> channels() const;
    /// Topics of which samples came.
    std::vector<std::string> heard() const;

    /// Its network is gone: nothing is read, said or answered any more, and nothing of it is closed.
    void vanish();

    /// Close code once the other side has ended it; 1006: without one.
    std::optional<int> closed() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace windlass::test
