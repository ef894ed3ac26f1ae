#pragma once
// A server, the door before it, and browsers without a browser.

#include "rigs/own_domain.hpp"
#include "rigs/server_process.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/page_client.hpp"
#include "tests/wire/plain_connection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::test {

/// An answer of the door.
struct Answer {
    int status = 0;
    std::string head, body;
    nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
    std::string header(const std::string& name) const {
        const auto at = head.find("\r\n" + name + ": ");
        if (at == std::string::npos) return {};
        const auto begin = at + name.size() + 4;
        return head.substr(begin, head.find("\r\n", begin) - begin);
    }
};

inline Answer answer_of(const std::string& text) {
    Answer found;
    const auto end = text.find("\r\n\r\n");
    if (!text.starts_with("HTTP/1.1 ") || end == std::string::npos) return found;
    found.status = std::stoi(text.substr(9, 3));
    found.head = text.substr(0, end + 2);
    found.body = text.substr(end + 4);
    return found;
}

/// One browser: its cookie, and the address that it comes from. It asks by plain HTTP on loopback.
class Browser {
public:
    using Json = nlohmann::json;
    explicit Browser(unsigned short port, std::string from = "127.0.0.1")
        : port_(port), from_(std::move(from)) {}

    Answer get(const std::string& target) { return ask("GET", target, ""); }
    Answer post(const std::string& target, const Json& body) { return ask("POST", target, body.dump()); }
    Answer ask(const std::string& method, const std::string& target, const std::string& body,
               const std::string& more = "Connection: close\r\n") {
        const Plain connection(port_, from_);
        const std::string host = "127.0.0.1:" + std::to_string(port_);
        connection.say(method + ' ' + target + " HTTP/1.1\r\nHost: " + host + "\r\n" +
                       (method == "POST" ? "Origin: http://" + host + "\r\n" : std::string()) +
                       (cookie.empty() ? std::string() : "Cookie: " + cookie + "\r\n") + more +
                       "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
        Answer found = answer_of(connection.answer());
        if (const auto set = found.header("Set-Cookie"); !set.empty()) cookie = set.substr(0, set.find(';'));
        return found;
    }

    /// Throws std::runtime_error when it is not let in. query: behind "/ws?".
    std::unique_ptr<PageClient> open(const std::string& query,
                                     const std::string& origin = "http://127.0.0.1:PORT") {
        return std::make_unique<PageClient>(
            PageAddress{port_, ""},
            PageClient::Options{.origin = origin, .target = "/ws?" + query, .cookie = cookie});
    }
    /// The status that an upgrade is answered with.
    int upgrade(const std::string& query, const std::string& more = "") {
        return ask("GET", "/ws?" + query, "",
                   "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                   "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: windlass.v1\r\n" +
                       more)
            .status;
    }

    std::string cookie;

private:
    const unsigned short port_;
    const std::string from_;
};

/// The door as a process of its own.
class DoorProcess : public rigs::ChildProcess {
public:
    explicit DoorProcess(std::vector<std::string> command) : rigs::ChildProcess(std::move(command)) {
        rigs::eventually([&] { return ended() || text().find("certificate SHA-256") != std::string::npos; });
        const std::string told = text();
        const auto port_behind = [&told](const std::string& words) {
            const auto at = told.find(words);
            return static_cast<unsigned short>(
                at == std::string::npos ? 0 : std::stoi(told.substr(at + words.size())));
        };
        tls = port_behind("https://localhost:");
        loopback = port_behind("\nhttp://127.0.0.1:");
        redirect = port_behind("http://0.0.0.0:");
        const auto token = told.find("#token=");
        if (token != std::string::npos) setup = told.substr(token + 7, 64);
        EXPECT_NE(tls, 0) << told;
    }
    unsigned short tls = 0, loopback = 0, redirect = 0;
    std::string setup;
};

class DoorRig : public ::testing::Test {
protected:
    static constexpr const char* kPassword = "a long password";

    static std::vector<std::string> domain() { return {"--domain", std::to_string(rigs::own_domain())}; }
    std::unique_ptr<DoorProcess> open_door(const std::string& exercises = WINDLASS_CONFIG_DIR "/exercises",
                                           const std::vector<std::string>& also = {}) const {
        std::vector<std::string> command{WINDLASS_DOOR,
                                         "--port",
                                         "0",
                                         "--redirect-port",
                                         "0",
                                         "--loopback-port",
                                         "0",
                                         "--state",
                                         (folder_ / "door").string(),
                                         "--recordings",
                                         (folder_ / "recordings").string(),
                                         "--exercises",
                                         exercises,
                                         "--partition",
                                         "none"};
        const auto more = domain();
        command.insert(command.end(), more.begin(), more.end());
        command.insert(command.end(), also.begin(), also.end());
        return std::make_unique<DoorProcess>(std::move(command));
    }
    Browser browser(const std::string& from = "127.0.0.1") const { return Browser(door_->loopback, from); }

    /// The first owner, logged in.
    Browser& owner() {
        if (owner_) return *owner_;
        owner_.emplace(door_->loopback);
        EXPECT_EQ(
            owner_->post("/door/setup", {{"token", door_->setup}, {"name", "anna"}, {"password", kPassword}})
                .status,
            200);
        return *owner_;
    }
    /// Opens a class and returns its code.
    std::string open_class(const std::string& id, int exercises, int crew,
                           const std::string& lesson = "let_go_port_25m") {
        const Answer opened = owner().post(
            "/door/class",
            {{"do", "open"}, {"class", id}, {"lesson", lesson}, {"exercises", exercises}, {"crew", crew}});
        EXPECT_EQ(opened.status, 200) << opened.body;
        return class_told(id)["code"];
    }
    nlohmann::json class_told(const std::string& id) {
        const auto told = owner().get("/door/classes").json(); // outlives the loop
        for (const auto& each : told["classes"])
            if (each["id"] == id) return each;
        return {};
    }
    Browser trainee(const std::string& code, const std::string& name, const std::string& from = "127.0.0.1") {
        Browser made = browser(from);
        const Answer joined = made.post("/door/join", {{"code", code}, {"name", name}});
        EXPECT_EQ(joined.status, 200) << joined.body;
        return made;
    }
    std::string audit() const { return content(folder_ / "door/audit.jsonl"); }

    Folder folder_;
    std::unique_ptr<DoorProcess> door_ = open_door();
    std::optional<Browser> owner_;
};

/// The same with a server behind it, which has no exercise yet.
class DoorWithServer : public DoorRig {
protected:
    /// Every exercise of the class is there.
    void expect_made(const std::string& id) {
        EXPECT_TRUE(rigs::eventually([&] {
            const auto told = class_told(id);
            return std::ranges::all_of(told["exercises"],
                                       [](const auto& e) { return !e["state"].is_null(); });
        })) << door_->text();
    }
    rigs::ServerProcess server_{[] {
        auto options = domain();
        options.insert(options.end(), {"--classroom", "--config-root", WINDLASS_CONFIG_DIR});
        return options;
    }()};
};

} // namespace windlass::test
