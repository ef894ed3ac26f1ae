// Messages of a page as no page makes them: true ones, changed at random but the same each time. Every one is
// taken or refused, and the session goes on.

#include "station/gateway/gateway.hpp"
#include "station/gateway/page_session.hpp"

#include "rigs/own_domain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace windlass::gateway {
namespace {

using nlohmann::json;
using rigs::own_domain;

constexpr int kMessages = 100'000;
constexpr std::size_t kLongest = 16 * 1024; // bytes, as the socket lets through

const std::vector<std::string> kTrue{
    R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},{"id":2,"channelId":2}]})",
    R"({"op":"unsubscribe","subscriptionIds":[1,2]})",
    R"({"op":"levers","side":0,"brake":0.5,"speed_lever":-0.25,"clutch_in":true,"stopper_closed":false,"emergency_stop":false})",
    R"({"op":"helm","engine":0.4,"rudder":0.1,"bow_thruster":-1,"stern_thruster":0})",
    R"({"op":"let_go_levers","side":1})",
    R"({"op":"let_go_levers","helm":true})",
    R"({"op":"order","id":7,"topic":"Report","sample":{"code":"REPORT_LEAD","side":0,"lead":11,"stay":"STAY_GIVEN_SHORT","text":"\u00fcber den Bug"}})",
    R"({"op":"order","id":8,"topic":"WatchCircle","sample":{"kept":true,"x":-120.5,"y":1e3,"radius":150}})",
    R"({"op":"order","id":9,"topic":"AlertCommand","sample":{"code":"brake.hot","side":0,"action":"ALERT_ACKNOWLEDGE"}})",
    R"({"op":"order","id":10,"topic":"EnvironmentCommand","sample":{"weather":{"wind_speed":8,"current_profile":[{"depth":5}]}}})",
    R"({"op":"record","id":11,"on":true,"name":"monday"})",
    R"({"op":"read_recording","id":12,"recording":"monday"})",
    R"({"op":"wind_sea","id":13,"wind_speed":19,"fetch":50000,"depth":25})",
    R"({"op":"debrief","id":13,"recording":"../monday"})",
    R"({"op":"replay","id":14,"recording":"monday"})",
    R"({"op":"continue_live","id":15,"recording":"monday","position":3.5,"exercise":"default"})",
};

/// What a parser may stumble on, put in anywhere.
const std::vector<std::string> kPieces{"{",
                                       "}",
                                       "[",
                                       "]",
                                       "\"",
                                       "\\",
                                       ":",
                                       ",",
                                       "null",
                                       "true",
                                       "NaN",
                                       "1e999",
                                       "-1e999",
                                       "-0",
                                       "1e-400",
                                       "9223372036854775808",
                                       "-9223372036854775809",
                                       "18446744073709551616",
                                       "\\u0000",
                                       "\\ud800",
                                       "\xff",
                                       "\xc0\x80",
                                       std::string(1, '\0'),
                                       std::string(300, 'x'),
                                       std::string(300, '['),
                                       "\"op\":\"order\",",
                                       "\"side\":-1",
                                       "{}"};

class Mutator {
public:
    std::string next() {
        std::string text = one_of(kTrue);
        for (int k = number(1, 4); k > 0; --k)
            change(text);
        if (text.size() > kLongest) text.resize(kLongest);
        return text;
    }

private:
    int number(int low, int high) { // both included; the same on every machine
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    std::size_t place(const std::string& text) {
        return static_cast<std::size_t>(number(0, static_cast<int>(text.size())));
    }
    const std::string& one_of(const std::vector<std::string>& list) {
        return list[static_cast<std::size_t>(number(0, static_cast<int>(list.size()) - 1))];
    }
    void change(std::string& text) {
        const std::size_t at = place(text);
        switch (number(0, 5)) {
        case 0: // another byte
            if (at < text.size()) text[at] = static_cast<char>(number(0, 255));
            break;
        case 1: // some are lost
            text.erase(at, static_cast<std::size_t>(number(1, 12)));
            break;
        case 2:
            text.insert(at, one_of(kPieces));
            break;
        case 3: // some come twice
            text.insert(at, text.substr(at, static_cast<std::size_t>(number(1, 40))));
            break;
        case 4: // it goes on as another one
        {
            const std::string& other = one_of(kTrue);
            text.resize(at);
            text += other.substr(place(other));
            break;
        }
        default: { // another value
            const std::size_t colon = text.find(':', at);
            if (colon == std::string::npos) break;
            const std::size_t end = text.find_first_of(",}", colon);
            text.replace(colon + 1, end == std::string::npos ? end : end - colon - 1, one_of(kPieces));
        }
        }
    }

    std::mt19937 random_{20201125};
};

class Ends : public Transport {
public:
    void wake() override {}
    void close(int code, const std::string& reason) override {
        ended.push_back(std::to_string(code) + ' ' + reason);
    }
    std::vector<std::string> ended;
};

TEST(GatewayFuzz, AHundredThousandChangedMessagesAreTakenOrRefusedAndTheSessionGoesOn) {
    GatewayOptions options;
    options.member.domain = own_domain();
    options.member.partition = wire::exercise_partition("default");
    options.seat = station::Seat::trainee;
    options.log = [](const std::string&) {};
    Gateway gateway(options);
    Ends transport;
    const auto session = gateway.open_page("default", transport);
    session->open();
    Clock::time_point now{};
    const auto say = [&](const std::string& text) { // slower than a flood
        session->take_text(text, now += std::chrono::milliseconds(10));
    };
    const auto answers = [&] {
        std::vector<json> all;
        while (const auto item = session->next())
            if (!item->frame) all.push_back(json::parse(item->text)); // which throws if it is none
        return all;
    };
    answers();
    std::map<std::string, int> told; // by op
    Mutator mutator;
    for (int k = 0; k < kMessages; ++k) {
        const std::string text = mutator.next();
        SCOPED_TRACE(text);
        say(text);
        for (const json& answer : answers())
            ++told[answer.at("op").get<std::string>()];
        if (k % 100 == 0) gateway.tick(now);
        ASSERT_THAT(transport.ended, testing::IsEmpty());
    }
    // Neither all of them broken at their first byte, nor all of them as they were.
    EXPECT_GT(told["refused"], kMessages / 2);
    EXPECT_GT(told["levers"], 10); // told when a hand takes them or leaves them
    say(R"({"op":"order","id":4711,"topic":"NoTopic","sample":{}})");
    const auto last = answers();
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(last[0]["id"], 4711);
    EXPECT_EQ(last[0]["op"], "refused");
    session->close();
}

} // namespace
} // namespace windlass::gateway
