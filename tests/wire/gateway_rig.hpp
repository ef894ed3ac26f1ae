#pragma once
// A server, the station programs that host its pages, and one who watches what comes of it over DDS.

#include "idl/wire.hpp"
#include "rigs/server_process.hpp"
#include "tests/wire/page_client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <mutex>
#include <set>
#include <thread>

namespace windlass::test {

/// A station program that hosts pages.
class StationProcess : public rigs::ChildProcess {
public:
    StationProcess(std::vector<std::string> command) : rigs::ChildProcess(std::move(command)) {
        std::optional<PageAddress> printed;
        rigs::eventually([&] { return ended() || (printed = PageAddress::in(text())).has_value(); });
        EXPECT_TRUE(printed) << text();
        address = printed.value_or(PageAddress{});
    }
    PageAddress address;
};

class GatewayRig : public ::testing::Test {
protected:
    static std::vector<std::string> session() {
        return {"--domain", std::to_string(rigs::own_domain()), "--partition", "gateway"};
    }
    static std::vector<std::string> command(const char* program, std::vector<std::string> more) {
        std::vector<std::string> all{program};
        const auto common = session();
        all.insert(all.end(), common.begin(), common.end());
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    static std::unique_ptr<StationProcess> seat(const char* which) {
        return std::make_unique<StationProcess>(
            command(TRAINEE_CLIENT, {"--ui", "--ui-port", "0", "--seat", which}));
    }
    static std::unique_ptr<StationProcess> instructor(std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"--name", "teacher", "ui", "--ui-port", "0"});
        return std::make_unique<StationProcess>(command(INSTRUCTOR_CONSOLE, std::move(more)));
    }

    void SetUp() override {
        ASSERT_TRUE(rigs::eventually([&] {
            const std::lock_guard lock(mutex_);
            return status_.has_value();
        })) << server_.text();
    }

    /// Given again until it is on its way: the server is heard some time after the station's start.
    static void give(PageClient& page, const char* topic, const nlohmann::json& sample) {
        static int id = 1000;
        bool sent = false;
        EXPECT_TRUE(rigs::eventually([&] {
            page.say({{"op", "order"}, {"id", ++id}, {"topic", topic}, {"sample", sample}});
            return rigs::eventually([&] {
                       const auto answered = [&](const char* op) {
                           return std::ranges::any_of(page.told(op),
                                                      [&](const auto& m) { return m["id"] == id; });
                       };
                       sent = answered("sent");
                       return sent || answered("refused");
                   }) &&
                   sent;
        })) << topic;
    }

    bool has_event(const std::string& code, const std::string& text = "") const {
        const std::lock_guard lock(mutex_);
        return std::ranges::any_of(events_, [&](const Event& event) {
            return event.code() == code.c_str() && event.text().to_string().find(text) != std::string::npos;
        });
    }
    std::size_t events(const std::string& code) const {
        const std::lock_guard lock(mutex_);
        return static_cast<std::size_t>(
            std::ranges::count_if(events_, [&](const Event& event) { return event.code() == code.c_str(); }));
    }
    std::vector<WindlassCommand> levers() const {
        const std::lock_guard lock(mutex_);
        return levers_;
    }
    ExerciseStatus status() const {
        const std::lock_guard lock(mutex_);
        return status_.value_or(ExerciseStatus{});
    }

    static nlohmann::json brake(double brake, int side = 0) {
        return {{"op", "levers"},         {"side", side},       {"brake", brake},
                {"speed_lever", 0},       {"clutch_in", false}, {"stopper_closed", false},
                {"emergency_stop", false}};
    }

    rigs::ServerProcess server_{[] {
        const std::string exercise = std::string(WINDLASS_CONFIG_DIR) + "/exercises/let_go_port_25m.json";
        auto options = session();
        options.insert(options.end(),
                       {"--exercise", exercise, "--partition", "second", "--exercise", exercise});
        return options;
    }()};
    mutable std::mutex mutex_;
    std::vector<Event> events_;
    std::vector<WindlassCommand> levers_;
    std::optional<ExerciseStatus> status_;
    wire::Participant watcher_{{rigs::own_domain(), wire::exercise_partition("gateway"), "watcher"}};
    wire::Reader<Event> event_reader_{watcher_, wire::topics::event, [this](const Event& event) {
                                          const std::lock_guard lock(mutex_);
                                          events_.push_back(event);
                                      }};
    wire::Reader<WindlassCommand> lever_reader_{watcher_, wire::topics::windlass_command,
                                                [this](const WindlassCommand& levers) {
                                                    const std::lock_guard lock(mutex_);
                                                    levers_.push_back(levers);
                                                }};
    wire::Reader<ExerciseStatus> status_reader_{watcher_, wire::topics::exercise_status,
                                                [this](const ExerciseStatus& status) {
                                                    const std::lock_guard lock(mutex_);
                                                    status_ = status;
                                                }};
};

} // namespace windlass::test
