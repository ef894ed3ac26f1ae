// Who is let in: hosts, origins, methods, paths, tokens, subprotocols; each refusal with its status.

#include "station/gateway/admission.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <set>

namespace windlass::gateway {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

namespace fs = std::filesystem;

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

/// Pages on the disk, for as long as the test lasts.
class Admitted : public ::testing::Test {
protected:
    Admitted() {
        folder_ = fs::temp_directory_path() / ("windlass_gateway_test_" + std::to_string(getpid()));
        fs::create_directories(folder_ / "assets");
        put("forecastle.html", "<p>deck</p>");
        put("assets/kit.css", "p {}");
        put("assets/kit.css.gz", "zipped");
        put("assets/chunk-ABCDEF12.js", "1");
        put("notes.md", "not for pages");
        put("secret", "nor this");
        assets_.emplace(folder_, "forecastle");
        admit();
    }
    ~Admitted() override { fs::remove_all(folder_); }

    void put(const char* name, const char* text) const { std::ofstream(folder_ / name) << text; }

    void admit(bool foxglove = false, bool any_exercise = false) {
        admission_.emplace(AdmissionOptions{.hosts = {"127.0.0.1:8765", "localhost:8765"},
                                            .tls = false,
                                            .token = kToken,
                                            .exercise = "mine",
                                            .any_exercise = any_exercise,
                                            .foxglove = foxglove,
                                            .foxglove_origins = {"https://app.example.org"}},
                           *assets_);
    }

    static Request request(std::string target) {
        return {.method = "GET",
                .target = std::move(target),
                .host = "127.0.0.1:8765",
                .origin = {},
                .upgrade = false,
                .subprotocols = {},
                .address = "127.0.0.1"};
    }
    static Request page(const std::string& token = kToken, const std::string& rest = "") {
        Request asked = request("/ws?token=" + token + rest);
        asked.origin = "http://127.0.0.1:8765";
        asked.upgrade = true;
        asked.subprotocols = "windlass.v1";
        return asked;
    }
    Verdict judge(const Request& asked) { return admission_->judge(asked, now_); }
    int status(const Request& asked) { return judge(asked).status; }

    fs::path folder_;
    std::optional<Assets> assets_;
    std::optional<Admission> admission_;
    Clock::time_point now_{1h};
};

TEST_F(Admitted, FilesAreServedByTheirExactNamesOnly) {
    EXPECT_EQ(judge(request("/forecastle")).file->content, "<p>deck</p>");
    EXPECT_EQ(judge(request("/")).file->content, "<p>deck</p>");
    EXPECT_EQ(judge(request("/forecastle?still=1")).file->content, "<p>deck</p>");
    EXPECT_EQ(judge(request("/assets/kit.css")).file->zipped, "zipped");
    EXPECT_EQ(judge(request("/assets/kit.css")).file->type, "text/css; charset=utf-8");
    for (const char* target :
         {"/forecastle.html", "/forecastle/", "//forecastle", "/assets", "/assets/", "/assets/kit.css.gz",
          "/notes.md", "/secret", "/../secret", "/assets/../forecastle", "/assets/%2e%2e/forecastle",
          "/%66orecastle", "", "http://127.0.0.1:8765/forecastle", "/forecastle\\", "/ws/", "/foxglove"})
        EXPECT_EQ(status(request(target)), 404) << target;
}

TEST_F(Admitted, WhatHasAHashInItsNameMayBeKept) {
    EXPECT_TRUE(judge(request("/assets/chunk-ABCDEF12.js")).file->immutable);
    EXPECT_FALSE(judge(request("/assets/kit.css")).file->immutable);
}

TEST_F(Admitted, OnlyTheNamesUnderWhichWeAreReachedAreOurs) {
    Request asked = request("/forecastle");
    for (const char* host : {"localhost:8765", "LOCALHOST:8765", "127.0.0.1:8765"}) {
        asked.host = host;
        EXPECT_EQ(status(asked), 200) << host;
    }
    for (const char* host : {"", "127.0.0.1", "127.0.0.1:8766", "evil.example:8765",
                             "localhost:8765.evil.example", "127.0.0.1:8765@evil.example"}) {
        asked.host = host;
        EXPECT_EQ(status(asked), 421) << host;
    }
}

TEST_F(Admitted, AForeignOriginIsRefusedEvenWithTheToken) {
    for (const char* origin : {"http://evil.example", "https://127.0.0.1:8765", "http://127.0.0.1:8766",
                               "null", "http://127.0.0.1:8765.evil.example", "file://"}) {
        Request asked = page();
        asked.origin = origin;
        EXPECT_EQ(status(asked), 403) << origin;
        Request file = request("/forecastle");
        file.origin = origin;
        EXPECT_EQ(status(file), 403) << origin;
    }
    Request asked = page();
    asked.origin = "http://localhost:8765";
    EXPECT_EQ(status(asked), 101);
    asked.origin = ""; // no browser: it needs the token all the same
    EXPECT_EQ(status(asked), 101);
}

TEST_F(Admitted, GetAndHeadAreTheOnlyMethods) {
    Request asked = request("/forecastle");
    asked.method = "HEAD";
    EXPECT_EQ(status(asked), 200);
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "get", ""}) {
        asked.method = method;
        EXPECT_EQ(status(asked), 405) << method;
    }
}

TEST_F(Admitted, AnAddressOfMoreThanTwoKilobytesIsRefused) {
    EXPECT_EQ(status(request("/" + std::string(2047, 'a'))), 404);
    EXPECT_EQ(status(request("/" + std::string(2048, 'a'))), 414);
}

TEST_F(Admitted, APageNeedsTheToken) {
    EXPECT_EQ(judge(page()).kind, Verdict::Kind::page);
    EXPECT_EQ(judge(page()).subprotocol, "windlass.v1");
    std::string near = kToken;
    near.back() = '0';
    for (const std::string& token :
         {std::string(), near, std::string(kToken) + "0", std::string(kToken).substr(1)}) {
        now_ += 10s;
        EXPECT_EQ(status(page(token)), 403) << token;
    }
    now_ += 10s;
    Request without = page();
    without.target = "/ws";
    EXPECT_EQ(status(without), 403);
}

TEST_F(Admitted, AfterFiveWrongTokensInASecondTheNextAreToldToWaitAndARightOneIsNot) {
    for (int i = 0; i < Admission::kWrongTokens; ++i)
        EXPECT_EQ(status(page("wrong")), 403);
    EXPECT_EQ(status(page("wrong")), 429);
    Request other = page("wrong");
    other.address = "127.0.0.2";
    EXPECT_EQ(status(other), 403) << "another address has not tried yet";
    EXPECT_EQ(status(page()), 101) << "one who guesses keeps nobody out";
    now_ += 1001ms;
    EXPECT_EQ(status(page("wrong")), 403);
}

TEST_F(Admitted, APageSpeaksOurSubprotocolOverAWebSocket) {
    Request asked = page();
    asked.subprotocols = "";
    EXPECT_EQ(status(asked), 400);
    asked.subprotocols = "windlass.v2, chat";
    EXPECT_EQ(status(asked), 400);
    asked.subprotocols = "chat , windlass.v1";
    EXPECT_EQ(status(asked), 101);
    asked.upgrade = false;
    EXPECT_EQ(status(asked), 400);
    asked = page();
    asked.method = "HEAD";
    EXPECT_EQ(status(asked), 400);
}

TEST_F(Admitted, OnlyAnInstructorMayNameAnotherExercise) {
    EXPECT_EQ(judge(page()).exercise, "mine");
    EXPECT_EQ(judge(page(kToken, "&exercise=mine")).exercise, "mine");
    EXPECT_EQ(status(page(kToken, "&exercise=other")), 403);
    admit(false, true);
    EXPECT_EQ(judge(page(kToken, "&exercise=other")).exercise, "other");
    for (const char* name : {"../etc", "a%2Fb", "*", "a b"})
        EXPECT_EQ(status(page(kToken, std::string("&exercise=") + name)), 400) << name;
}

TEST_F(Admitted, FoxgloveIsOffUnlessAskedForAndForNamedOriginsOnly) {
    Request asked = request(std::string("/foxglove?token=") + kToken);
    asked.upgrade = true;
    asked.subprotocols = "foxglove.websocket.v1, foxglove.sdk.v1";
    EXPECT_EQ(status(asked), 404);
    admit(true);
    EXPECT_EQ(judge(asked).kind, Verdict::Kind::foxglove);
    EXPECT_EQ(judge(asked).subprotocol, "foxglove.sdk.v1");
    asked.origin = "https://app.example.org";
    EXPECT_EQ(status(asked), 101);
    asked.origin = "https://evil.example.org";
    EXPECT_EQ(status(asked), 403);
    asked.origin = "https://app.example.org";
    asked.subprotocols = "foxglove.websocket.v1";
    EXPECT_EQ(judge(asked).subprotocol, "foxglove.websocket.v1");
    asked.subprotocols = "windlass.v1";
    EXPECT_EQ(status(asked), 400);
    asked.target = "/foxglove?token=wrong";
    EXPECT_EQ(status(asked), 403);
    Request ours = page();
    ours.origin = "https://app.example.org";
    EXPECT_EQ(status(ours), 403) << "a foreign page looks on, it has no seat";
}

TEST(Token, HasAHundredAndTwentyEightBitsAndIsNeverTheSame) {
    const std::string token = make_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(make_token(), token);
    EXPECT_TRUE(same_token(token, token));
    EXPECT_FALSE(same_token("", token));
}

// Were the digits of a clock, of a counter or of a generator with few states, some bit would hardly change,
// or tokens would come twice. Of 4096 fair draws a bit is set 2048 times, by a standard deviation of 32;
// seven of them are passed by one of 128 bits once in 3e9 runs.
TEST(Token, HasNoBitThatCanBeGuessedFromOthersBefore) {
    constexpr int kTokens = 4096;
    std::set<std::string> all;
    std::array<int, 128> set{}, changed{};
    std::string before = make_token();
    for (int i = 0; i < kTokens; ++i) {
        const std::string token = make_token();
        all.insert(token);
        for (std::size_t bit = 0; bit < 128; ++bit) {
            const auto value = [&](const std::string& of) {
                return std::stoi(of.substr(bit / 4, 1), nullptr, 16) >> bit % 4 & 1;
            };
            set[bit] += value(token);
            changed[bit] += value(token) != value(before);
        }
        before = token;
    }
    EXPECT_EQ(all.size(), static_cast<std::size_t>(kTokens));
    EXPECT_THAT(set, testing::Each(testing::AllOf(testing::Gt(2048 - 224), testing::Lt(2048 + 224))));
    EXPECT_THAT(changed, testing::Each(testing::AllOf(testing::Gt(2048 - 224), testing::Lt(2048 + 224))));
}

TEST(AssetsOfNoPages, AreToldWithTheFolder) {
    try {
        const Assets assets("/nowhere/at/all", "forecastle");
        FAIL() << "there are no pages there";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/at/all"));
    }
}

} // namespace
} // namespace windlass::gateway
