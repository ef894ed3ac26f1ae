#pragma once
// A session, and the orders that tests give it.

#include "server/run/session.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>

namespace windlass::run::test {

class SessionTest : public testing::Test {
protected:
    SessionTest()
        : folder_(std::filesystem::path(testing::TempDir()) /
                  ("windlass_session_test_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~SessionTest() override { std::filesystem::remove_all(folder_); }

    SessionOptions options() const {
        SessionOptions options;
        options.fault_folder = folder_;
        return options;
    }

    std::filesystem::path folder_;
};

inline void give(Session& session, OrderContent order, double now = 0, const char* source = "instructor") {
    Inbox inbox;
    inbox.orders.push_back({source, std::move(order)});
    session.carry_out(inbox, now);
}

/// Over the instructors' own topic.
inline void give_as_instructor(Session& session, OrderContent order, double now, const char* source) {
    Inbox inbox;
    inbox.orders.push_back({source, std::move(order), true});
    session.carry_out(inbox, now);
}

/// The server looks each 0.05 s of wall time, from then until then, and hears nothing.
inline void hear_nothing(Session& session, double from, double until) {
    for (double now = from; now < until; now += 0.05)
        session.carry_out({}, now);
    session.carry_out({}, until);
}

inline RunOrder run_order(RunAction action) {
    RunOrder order;
    order.action = action;
    return order;
}

inline exercise::Order levers(double brake) {
    exercise::WindlassOrder order;
    order.brake = brake;
    return order;
}

inline int count(const Session& session, const std::string& code) {
    return static_cast<int>(std::count_if(session.events().begin(), session.events().end(),
                                          [&](const auto& event) { return event.code == code; }));
}

inline std::string text_of(const Session& session, const std::string& code) {
    for (const auto& event : session.events()) {
        if (event.code == code) return event.text;
    }
    return "";
}

} // namespace windlass::run::test
