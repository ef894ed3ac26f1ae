// Pages that mean harm, or do not know better: refused and logged, and nothing else happens.

#include "tests/wire/gateway_rig.hpp"
#include "tests/wire/plain_connection.hpp"

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// The status of a request that is sent as it stands, "HOST" and "TOKEN" put in.
class HostilePage : public GatewayRig {
protected:
    std::string request(std::string text) const {
        const auto put = [&text](const std::string& word, const std::string& value) {
            for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += value.size())
                text.replace(at, word.size(), value);
        };
        put("HOST", "127.0.0.1:" + std::to_string(station_->address.port));
        put("TOKEN", station_->address.token);
        return text;
    }
    std::string status_of(const std::string& text) const {
        const Plain connection(station_->address.port);
        connection.say(request(text));
        const std::string answer = connection.answer();
        return answer.starts_with("HTTP/1.1 ") ? answer.substr(9, 3) : "no answer: " + answer;
    }
    static double memory(pid_t pid) { // MB
        std::ifstream status("/proc/" + std::to_string(pid) + "/status");
        for (std::string word; status >> word;)
            if (word == "VmRSS:" && status >> word) return std::stod(word) / 1024;
        return 0;
    }
    /// A page goes on hearing, and a new one is let in.
    void expect_unharmed() {
        const auto before = page_.samples("ForecastleView").size();
        EXPECT_TRUE(eventually([&] { return page_.samples("ForecastleView").size() > before + 10; }))
            << station_->text();
        EXPECT_FALSE(page_.closed());
        PageClient next(station_->address);
        EXPECT_TRUE(eventually([&] { return !next.samples("ForecastleView").empty(); })) << station_->text();
        EXPECT_EQ(status().state(), RUN_RUNNING);
    }

    std::unique_ptr<StationProcess> station_ = seat("forecastle");
    PageClient page_{station_->address};
};

TEST_F(HostilePage, RequestsThatAreNotAPagesAreRefusedWithTheirStatus) {
    const std::string ws = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    const std::string ours = ws + "Sec-WebSocket-Protocol: windlass.v1\r\n";
    const std::pair<const char*, std::string> tries[] = {
        {"200", "GET / HTTP/1.1\r\nHost: HOST\r\nConnection: close\r\n\r\n"},
        {"404", "GET /../../etc/passwd HTTP/1.1\r\nHost: HOST\r\nConnection: close\r\n\r\n"},
        {"404", "GET /..%2f..%2fetc/passwd HTTP/1.1\r\nHost: HOST\r\nConnection: close\r\n\r\n"},
        {"404", "GET /assets/../../trainee_client HTTP/1.1\r\nHost: HOST\r\nConnection: close\r\n\r\n"},
        {"421", "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"},
        {"421", "GET / HTTP/1.1\r\n\r\n"},
        {"405", "POST / HTTP/1.1\r\nHost: HOST\r\nContent-Length: 3\r\n\r\nabc"},
        {"403", "GET /ws?token=00000000000000000000000000000000 HTTP/1.1\r\nHost: HOST\r\n" + ours + "\r\n"},
        {"403", "GET /ws HTTP/1.1\r\nHost: HOST\r\n" + ours + "\r\n"},
        {"403",
         "GET /ws?token=TOKEN HTTP/1.1\r\nHost: HOST\r\nOrigin: http://evil.example\r\n" + ours + "\r\n"},
        {"421", "GET /ws?token=TOKEN HTTP/1.1\r\nHost: evil.example\r\n" + ours + "\r\n"},
        {"400", "GET /ws?token=TOKEN HTTP/1.1\r\nHost: HOST\r\n" + ws + "\r\n"},
        {"400", "GET /ws?token=TOKEN HTTP/1.1\r\nHost: HOST\r\n\r\n"},
        {"414", "GET /" + std::string(3000, 'a') + " HTTP/1.1\r\nHost: HOST\r\n\r\n"},
        {"404", "GET /foxglove?token=TOKEN HTTP/1.1\r\nHost: HOST\r\nConnection: close\r\n\r\n"},
    };
    for (const auto& [status, text] : tries)
        EXPECT_EQ(status_of(text), status) << text;
    EXPECT_THAT(station_->text(), HasSubstr("/ws: 403 a token is needed"));
    EXPECT_THAT(station_->text(), HasSubstr("403 pages of this origin"));
    EXPECT_EQ(station_->text().find(station_->address.token), station_->text().rfind(station_->address.token))
        << "the token stands in the printed address alone";
    // What is no HTTP, or too much of it, is not answered.
    for (const std::string& text :
         {std::string("\x16\x03\x01\x02 no HTTP at all\r\n\r\n"),
          "GET / HTTP/1.1\r\nHost: HOST\r\nX: " + std::string(10000, 'x') + "\r\n\r\n",
          std::string("GET / HTTP/9.9\r\n\r\n")})
        EXPECT_THAT(status_of(text), HasSubstr("no answer"));
    expect_unharmed();
}

TEST_F(HostilePage, GuessingTokensIsToldToWaitAndKeepsNobodyOut) {
    std::string last;
    for (int i = 0; i < 20; ++i)
        last = status_of("GET /ws?token=guess HTTP/1.1\r\nHost: HOST\r\n\r\n");
    EXPECT_EQ(last, "429");
    expect_unharmed();
}

TEST_F(HostilePage, AMessageThatIsNoneOfTheProtocolIsRefusedAndTheSessionGoesOn) {
    PageClient page(station_->address);
    const std::string deep = std::string(8000, '[') + std::string(8000, ']');
    for (const std::string& text :
         {std::string("no JSON"), std::string("[]"), std::string("5"), std::string("{\"op\": 5}"),
          std::string("{}"), std::string("{\"op\": \"shutdown\"}"), std::string("{\"op\": \"order\"}"),
          std::string("{\"op\": \"order\", \"topic\": 5}"), std::string("{\"op\": \"subscribe\"}"),
          std::string(
              "{\"op\": \"subscribe\", \"subscriptions\": [5, {}, {\"id\": -1, \"channelId\": 1e9}]}"),
          std::string("{\"op\": \"unsubscribe\", \"subscriptionIds\": [\"x\", 99999]}"),
          std::string("{\"op\": \"levers\", \"side\": 0, \"brake\": 1e999}"),
          std::string("{\"op\": \"levers\", \"side\": 0, \"brake\": NaN}"),
          std::string("{\"op\": \"let_go_levers\"}"), std::string("{\"op\": \"record\"}"),
          std::string("{\"op\": \"continue_live\", \"position\": \"x\"}"), deep}) {
        const auto before = page.told("refused").size();
        page.say(text, true);
        EXPECT_TRUE(eventually([&] { return page.told("refused").size() > before; })) << text.substr(0, 100);
    }
    EXPECT_FALSE(page.closed());
    EXPECT_TRUE(levers().empty());
    EXPECT_THAT(station_->text(), HasSubstr("a JSON object is expected"));
    expect_unharmed();
}

TEST_F(HostilePage, BinaryOversizedAndFloodingSessionsAreEnded) {
    PageClient binary(station_->address), oversized(station_->address), flood(station_->address);
    binary.say(std::string("\x01\x02\x03", 3), false);
    EXPECT_TRUE(eventually([&] { return binary.closed().has_value(); }));
    EXPECT_EQ(binary.closed(), 1003);
    oversized.say("\"" + std::string(16 * 1024, 'x') + "\"", true);
    EXPECT_TRUE(eventually([&] { return oversized.closed().has_value(); }));
    EXPECT_EQ(oversized.closed(), 1009);
    for (int i = 0; i < 2000; ++i)
        flood.say(brake(0.5));
    EXPECT_TRUE(eventually([&] { return flood.closed().has_value(); }));
    EXPECT_EQ(flood.closed(), 1008);
    EXPECT_THAT(station_->text(), HasSubstr("too many messages"));
    EXPECT_THAT(station_->text(), HasSubstr("text messages only"));
    expect_unharmed();
}

TEST_F(HostilePage, OneThatReadsNothingCostsNoMemoryAndHoldsNobodyUp) {
    const Plain slow(station_->address.port, "127.0.0.1", 4096);
    slow.say(
        request("GET /ws?token=TOKEN HTTP/1.1\r\nHost: HOST\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                "Sec-WebSocket-Protocol: windlass.v1\r\n\r\n"));
    std::string all = "{\"op\":\"subscribe\",\"subscriptions\":[";
    for (int number = 1; number < 39; ++number)
        all += (number > 1 ? ",{\"id\":" : "{\"id\":") + std::to_string(number) +
               ",\"channelId\":" + std::to_string(number) + "}";
    all += "]}";
    std::string message = {'\x81', '\xFE', static_cast<char>(all.size() / 256),
                           static_cast<char>(all.size() % 256)};
    message += std::string(4, '\0') + all; // a mask of zeros
    slow.say(message);
    const auto before = page_.samples("ForecastleView").size();
    ASSERT_TRUE(eventually([&] { return page_.samples("ForecastleView").size() > before + 30; }));
    const double held = memory(station_->pid());
    const auto begun = page_.samples("ForecastleView").size();
    ASSERT_TRUE(eventually([&] { return page_.samples("ForecastleView").size() > begun + 300; })); // 5 s
    EXPECT_LT(memory(station_->pid()) - held, 4);                                                  // MB
    expect_unharmed();
}

// It says nothing, and answers no ping: its place is given to somebody else.
TEST_F(HostilePage, OneThatIsSilentForTwentySecondsIsLetGo) {
    const Plain silent(station_->address.port);
    const auto begin = std::chrono::steady_clock::now();
    silent.say(
        request("GET /ws?token=TOKEN HTTP/1.1\r\nHost: HOST\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                "Sec-WebSocket-Protocol: windlass.v1\r\n\r\n"));
    EXPECT_TRUE(
        silent.answer().starts_with("HTTP/1.1 101")); // and all that comes until the other side ends it
    EXPECT_GE(std::chrono::steady_clock::now() - begin, 20s);
    expect_unharmed();
}

TEST_F(HostilePage, AThousandConnectionsAreTurnedAwayAndThePagesGoOn) {
    const double before = memory(station_->pid());
    {
        std::vector<std::unique_ptr<Plain>> many;
        for (int i = 0; i < 1000; ++i) {
            many.push_back(std::make_unique<Plain>(station_->address.port));
            many.back()->say("GET /");
        }
        const auto heard = page_.samples("ForecastleView").size();
        EXPECT_TRUE(eventually([&] { return page_.samples("ForecastleView").size() > heard + 10; }));
        EXPECT_TRUE(
            eventually([&] { return station_->text().find("too many connections") != std::string::npos; }));
    }
    expect_unharmed();
    EXPECT_LT(memory(station_->pid()) - before, 32); // MB
}

TEST_F(HostilePage, MorePagesThanAStationTakesAreRefused) {
    std::vector<std::unique_ptr<PageClient>> pages;
    std::string refused;
    for (int i = 0; i < 40 && refused.empty(); ++i) {
        try {
            pages.push_back(std::make_unique<PageClient>(station_->address));
        } catch (const std::runtime_error& error) {
            refused = error.what();
        }
    }
    EXPECT_NE(refused, "");
    EXPECT_EQ(pages.size(), 15U) << "and the rig's own";
    EXPECT_EQ(
        status_of(
            "GET /ws?token=TOKEN HTTP/1.1\r\nHost: HOST\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
            "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
            "Sec-WebSocket-Protocol: windlass.v1\r\n\r\n"),
        "503");
    pages.clear();
    EXPECT_TRUE(eventually([&] { return station_->text().find("503") != std::string::npos; }));
    ASSERT_TRUE(eventually([&] {
        try {
            const PageClient next(station_->address);
            return true;
        } catch (const std::runtime_error&) {
            return false; // those that left are not yet gone
        }
    }));
    expect_unharmed();
}

} // namespace
} // namespace windlass::test
