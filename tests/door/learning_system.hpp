#pragma once
// A small learning system with its record store, by HTTP on loopback: it gives tokens once, has launch data
// and preferences, and takes no statement that breaks a rule of cmi5.

#include "door/cmi5/url.hpp"

#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <regex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace windlass::test {

class LearningSystem {
public:
    using Json = nlohmann::json;
    static constexpr const char* kActivity = "https://lms.example/activities/let-go";
    static constexpr const char* kRegistration = "760e3480-ba55-4991-94b0-01820dbd23a2";
    static constexpr const char* kSession = "https://w3id.org/xapi/cmi5/context/extensions/sessionid";

    LearningSystem() { up(); }
    ~LearningSystem() { down(); }
    LearningSystem(const LearningSystem&) = delete;
    LearningSystem& operator=(const LearningSystem&) = delete;

    /// Nobody answers at its port from now on; and again.
    void down() {
        if (!thread_.joinable()) return;
        stop_ = true;
        thread_.join();
    }
    void up() {
        stop_ = false;
        const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        const int yes = 1;
        setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        sockaddr_in here{};
        here.sin_family = AF_INET;
        here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        here.sin_port = htons(port_);
        if (bind(listener, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0 ||
            listen(listener, 16) != 0)
            throw std::runtime_error("no port for the learning system");
        socklen_t size = sizeof here;
        getsockname(listener, reinterpret_cast<sockaddr*>(&here), &size);
        port_ = ntohs(here.sin_port);
        thread_ = std::thread([this, listener] { serve(listener); });
    }

    std::string origin() const { return "http://127.0.0.1:" + std::to_string(port_); }

    /// The parameters of one more launch: each with a fetch address of its own.
    Json launch(const std::string& learner = "1625378") {
        const std::lock_guard lock(mutex_);
        learner_ = learner;
        return {{"endpoint", origin() + "/lrs/"},
                {"fetch", origin() + "/fetch?k=" + std::to_string(++launches_)},
                {"actor", actor().dump()},
                {"registration", kRegistration},
                {"activityId", kActivity}};
    }
    Json actor() const {
        return {{"objectType", "Agent"},
                {"account", {{"homePage", "https://lms.example"}, {"name", learner_}}}};
    }

    /// What LMS.LaunchData has, to be changed before a launch.
    Json launch_data{
        {"contextTemplate",
         {{"contextActivities", {{"grouping", Json::array({{{"id", "https://door.example/cmi5/L01"}}})}}},
          {"extensions", {{kSession, "session-1"}}}}},
        {"launchMode", "Normal"},
        {"moveOn", "Passed"},
        {"masteryScore", 0.7},
        {"returnURL", "https://lms.example/back?course=1"}};
    std::string preferences;      ///< empty: there are none
    std::atomic<int> refuses = 0; ///< statements that are answered with 503 before one is taken
    std::atomic<int> slow_ms = 0; ///< before each answer

    std::vector<Json> statements() const {
        const std::lock_guard lock(mutex_);
        return statements_;
    }
    std::vector<std::string> verbs() const {
        std::vector<std::string> all;
        for (const Json& each : statements())
            all.push_back(verb_of(each));
        return all;
    }
    /// The one of that verb; null: there is none.
    Json statement(const std::string& verb) const {
        for (const Json& each : statements())
            if (verb_of(each) == verb) return each;
        return {};
    }
    /// What it had to refuse, and why.
    std::vector<std::string> broken() const {
        const std::lock_guard lock(mutex_);
        return broken_;
    }
    int fetched() const { return fetched_; } ///< addresses that were asked, with those asked again

private:
    struct Asked {
        std::string method, path, head, body;
        std::map<std::string, std::string> query;
        std::string header(std::string name) const {
            name = "\r\n" + name + ": ";
            const auto at = head.find(name);
            if (at == std::string::npos) return {};
            return head.substr(at + name.size(), head.find("\r\n", at + 2) - at - name.size());
        }
    };

    static std::string verb_of(const Json& statement) {
        const std::string id = statement["verb"]["id"];
        return id.substr(id.rfind('/') + 1);
    }

    void serve(int listener) {
        while (!stop_) {
            pollfd waits{listener, POLLIN, 0};
            if (poll(&waits, 1, 20) <= 0) continue;
            const int connection = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
            answer(connection);
            close(connection);
        }
        close(listener);
    }

    void answer(int connection) {
        const Asked asked = read(connection);
        std::this_thread::sleep_for(std::chrono::milliseconds(slow_ms));
        int status = 200;
        const std::string body = made(asked, status);
        const std::string text =
            "HTTP/1.1 " + std::to_string(status) +
            " x\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
            "\r\nConnection: close\r\n\r\n" + body;
        (void)!send(connection, text.data(), text.size(), MSG_NOSIGNAL);
        shutdown(connection, SHUT_WR);
    }

    static Asked read(int connection) {
        std::string all;
        char part[4096];
        std::size_t end = std::string::npos, length = 0;
        while (end == std::string::npos || all.size() < end + 4 + length) {
            const ssize_t n = recv(connection, part, sizeof part, 0);
            if (n <= 0) return {};
            all.append(part, static_cast<std::size_t>(n));
            if (end != std::string::npos) continue;
            end = all.find("\r\n\r\n");
            const auto at = all.find("Content-Length: ");
            if (end != std::string::npos && at < end) length = std::stoul(all.substr(at + 16));
        }
        Asked asked;
        asked.method = all.substr(0, all.find(' '));
        const auto begin = all.find(' ') + 1;
        const std::string target = all.substr(begin, all.find(' ', begin) - begin);
        asked.path = target.substr(0, target.find('?'));
        if (const auto at = target.find('?'); at != std::string::npos)
            for (std::size_t from = at + 1; from < target.size();) {
                const auto to = std::min(target.find('&', from), target.size());
                const std::string pair = target.substr(from, to - from);
                asked.query[pair.substr(0, pair.find('='))] = cmi5::plain(pair.substr(pair.find('=') + 1));
                from = to + 1;
            }
        asked.head = all.substr(0, end + 2);
        asked.body = all.substr(end + 4);
        return asked;
    }

    std::string made(const Asked& asked, int& status) {
        const std::lock_guard lock(mutex_);
        if (asked.path == "/fetch") return fetch(asked, status);
        if (!asked.path.starts_with("/lrs/")) {
            status = 404;
            return {};
        }
        if (!tokens_.contains(asked.header("Authorization")) ||
            asked.header("X-Experience-API-Version") != "1.0.3") {
            status = 401;
            return {};
        }
        const std::string what = asked.path.substr(5);
        if (what == "activities/state" && asked.method == "GET") {
            const bool right = asked.query.at("stateId") == "LMS.LaunchData" &&
                               asked.query.at("activityId") == kActivity &&
                               Json::parse(asked.query.at("agent")) == actor() &&
                               asked.query.at("registration") == kRegistration;
            status = right ? 200 : 404;
            return right ? launch_data.dump() : "";
        }
        if (what == "agents/profile" && asked.method == "GET") {
            asked_preferences = true;
            status = preferences.empty() ? 404 : 200;
            return preferences;
        }
        if (what == "statements" && asked.method == "GET") {
            Json found = Json::array();
            for (const Json& each : statements_)
                if (each["verb"]["id"] == asked.query.at("verb")) found.push_back(each);
            return Json{{"statements", found}}.dump();
        }
        if (what == "statements" && asked.method == "POST") return take(asked, status);
        status = 404;
        return {};
    }

    std::string fetch(const Asked& asked, int& status) {
        ++fetched_;
        if (asked.method != "POST") status = 405;
        if (asked.method != "POST") return {};
        if (!used_.insert(asked.query.at("k")).second)
            return R"({"error-code": "1", "error-text": "The authorization token has already been returned."})";
        const std::string token = "c2VjcmV0LW9mLXRoaXMtbGF1bmNo" + asked.query.at("k");
        tokens_.insert("Basic " + token);
        return Json{{"auth-token", token}}.dump();
    }

    std::string take(const Asked& asked, int& status) {
        if (refuses > 0) {
            --refuses;
            status = 503;
            return "busy";
        }
        Json statement = Json::parse(asked.body, nullptr, false);
        for (const Json& each : statements_)
            if (each["id"] == statement.value("id", "")) {
                status = each == statement ? 200 : 409;
                return {};
            }
        const std::string why = wrong_with(statement);
        if (!why.empty()) {
            broken_.push_back(why + ": " + asked.body);
            status = 400;
            return why;
        }
        statements_.push_back(statement);
        return Json::array({statement["id"]}).dump();
    }

    /// Of all that the template has, each is there.
    static bool contains(const Json& whole, const Json& part) {
        if (part.is_object())
            return whole.is_object() && std::ranges::all_of(part.items(), [&](const auto& each) {
                       return whole.contains(each.key()) && contains(whole[each.key()], each.value());
                   });
        if (part.is_array())
            return whole.is_array() && std::ranges::all_of(part, [&](const Json& each) {
                       return std::ranges::any_of(whole,
                                                  [&](const Json& one) { return contains(one, each); });
                   });
        return whole == part;
    }

    static bool has_category(const Json& statement, const std::string& name) {
        for (const Json& each : statement["context"]["contextActivities"].value("category", Json::array()))
            if (each["id"] == "https://w3id.org/xapi/cmi5/context/categories/" + name) return true;
        return false;
    }

    /// By which rule of cmi5 a statement is none; empty: it is one. Sections of the specification.
    std::string wrong_with(const Json& statement) {
        static const std::regex kUuid("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}");
        static const std::regex kTime(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");
        static const std::regex kDuration(R"(PT\d+(\.\d+)?S)");
        if (!statement.is_object()) return "no JSON";
        if (!std::regex_match(statement.value("id", ""), kUuid)) return "9.1 id";
        if (statement["actor"] != actor()) return "9.2 actor";
        if (statement["object"]["id"] != kActivity) return "9.4 object";
        if (!std::regex_match(statement.value("timestamp", ""), kTime)) return "9.7 timestamp";
        if (!statements_.empty() && statement["timestamp"] < statements_.back()["timestamp"] &&
            statements_.back()["context"]["extensions"][kSession] ==
                launch_data["contextTemplate"]["extensions"][kSession])
            return "9.3 order of time";
        const Json context = statement["context"];
        if (context["registration"] != kRegistration) return "9.6.1 registration";
        if (!contains(context, launch_data["contextTemplate"])) return "10 contextTemplate";
        if (!has_category(statement, "cmi5")) return "9.6.2.1 category";
        const std::string verb = verb_of(statement);
        std::vector<std::string> session, registration;
        for (const Json& each : statements_) {
            registration.push_back(verb_of(each));
            if (each["context"]["extensions"][kSession] == context["extensions"][kSession])
                session.push_back(verb_of(each));
        }
        const auto in = [](const std::vector<std::string>& all, const std::string& one) {
            return std::ranges::find(all, one) != all.end();
        };
        if (session.empty() != (verb == "initialized")) return "9.3 initialized is the first";
        if (in(session, "terminated")) return "9.3 terminated is the last";
        if (in(session, verb)) return "9.3 a verb twice";
        const bool judged = verb == "passed" || verb == "failed";
        if (judged && (in(session, "passed") || in(session, "failed"))) return "9.3 passed and failed";
        if (judged && in(registration, "passed")) return "9.3 one passed, and no failed behind it";
        if (verb == "completed" && in(registration, "completed")) return "9.3 one completed";
        const bool ends = judged || verb == "completed";
        if (ends && launch_data["launchMode"] != "Normal") return "10 launchMode";
        if (has_category(statement, "moveon") != ends) return "9.6.2.2 moveon";
        if (verb == "initialized") return {};
        const Json result = statement["result"];
        if (!std::regex_match(result.value("duration", ""), kDuration)) return "9.5.4 duration";
        if (result.contains("success") != judged) return "9.5.2 success";
        if (result.contains("completion") != (verb == "completed")) return "9.5.3 completion";
        if (!judged) return result.contains("score") ? "9.5.1 score" : "";
        if (result["success"] != (verb == "passed")) return "9.5.2 success";
        if (!launch_data.contains("masteryScore")) return {};
        const Json mastery = launch_data["masteryScore"];
        if (context["extensions"]["https://w3id.org/xapi/cmi5/context/extensions/masteryscore"] != mastery)
            return "9.6.3.2 masteryScore";
        if (result.contains("score") && (result["score"]["scaled"] >= mastery) != (verb == "passed"))
            return "9.3.4 score against masteryScore";
        return {};
    }

    mutable std::mutex mutex_;
    unsigned short port_ = 0;
    std::thread thread_;
    std::atomic<bool> stop_ = false;
    std::string learner_ = "1625378";
    int launches_ = 0;
    std::atomic<int> fetched_ = 0;
    std::set<std::string> used_, tokens_;
    std::vector<Json> statements_;
    std::vector<std::string> broken_;

public:
    std::atomic<bool> asked_preferences = false;
};

} // namespace windlass::test
