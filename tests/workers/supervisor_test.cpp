// A supervisor with workers that die, hang, grow and will not begin. Each worker writes down when it begins.

#include "server/workers/supervisor.hpp"

#include <gmock/gmock.h>

#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace windlass::workers {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t told = 0;

/// What processes write down for one another: a line each.
class Book {
public:
    Book() : path_(std::filesystem::temp_directory_path() / ("workers_test_" + std::to_string(getpid()))) {}
    ~Book() { std::filesystem::remove(path_); }
    Book(const Book&) = delete;
    Book& operator=(const Book&) = delete;

    void write(const std::string& line) const {
        std::ofstream(path_, std::ios::app) << line + '\n' << std::flush;
    }
    std::vector<std::string> lines() const {
        std::ifstream file(path_);
        std::vector<std::string> all;
        for (std::string line; std::getline(file, line);)
            all.push_back(line);
        return all;
    }
    std::ptrdiff_t count(const std::string& line) const { return std::ranges::count(lines(), line); }

private:
    const std::filesystem::path path_;
};

class Supervisor : public testing::Test {
protected:
    Supervisor() {
        std::signal(SIGTERM, [](int number) { told = number; });
    } // workers inherit it

    /// Times of a test: short, but long against what a busy machine delays a process by.
    static Limits limits() {
        return {.starting = 20'000ms,
                .silence = 3'000ms,
                .settled = 60'000ms,
                .first_pause = 50ms,
                .last_pause = 100ms};
    }

    /// Serves until it is told to stop, or `end` says so with an exit code.
    static int serve(
        Pulse& pulse, const std::function<std::optional<int>()>& end = [] { return std::nullopt; }) {
        while (told == 0) {
            if (const auto code = end()) return *code;
            pulse.serving();
            std::this_thread::sleep_for(5ms);
        }
        return 0;
    }

    /// Stops when that holds; a minute at most, which no machine needs.
    auto when(std::function<bool()> holds) {
        return [holds = std::move(holds), until = Clock::now() + 60s] {
            EXPECT_LT(Clock::now(), until);
            return holds() || Clock::now() > until ? SIGTERM : 0;
        };
    }

    Book book_;
};

TEST_F(Supervisor, StartsOneAgainThatIsKilledAndLeavesTheOthersAlone) {
    const auto work = [&](unsigned number, Pulse pulse) {
        const auto before = book_.count("began 2");
        book_.write("began " + std::to_string(number));
        if (number == 2 && before < 3) raise(SIGKILL);
        return serve(pulse);
    };
    EXPECT_EQ(supervise(3, limits(), work, when([&] { return book_.count("began 2") == 4; })), 0);
    EXPECT_EQ(book_.count("began 1"), 1);
    EXPECT_EQ(book_.count("began 3"), 1);
}

TEST_F(Supervisor, KillsOneThatHangsAndStartsItAgain) {
    const auto work = [&](unsigned number, Pulse pulse) {
        const bool again = book_.count("began 1") > 0;
        book_.write("began " + std::to_string(number));
        bool served = false;
        return serve(pulse, [&]() -> std::optional<int> {
            if (number == 1 && !again && std::exchange(served, true)) std::this_thread::sleep_for(1h);
            return std::nullopt;
        });
    };
    EXPECT_EQ(supervise(2, limits(), work, when([&] { return book_.count("began 1") == 2; })), 0);
    EXPECT_EQ(book_.count("began 2"), 1) << "the other is heard";
}

TEST_F(Supervisor, KillsOneThatHasGrown) {
    auto narrow = limits();
    narrow.memory = 300U << 20U;
    const auto work = [&](unsigned number, Pulse pulse) {
        const bool again = book_.count("began 1") > 0;
        book_.write("began " + std::to_string(number));
        std::vector<char> grown;
        if (number == 1 && !again) grown.assign(400U << 20U, 'x');
        return serve(pulse);
    };
    EXPECT_EQ(supervise(2, narrow, work, when([&] { return book_.count("began 1") == 2; })), 0);
    EXPECT_EQ(book_.count("began 2"), 1);
}

TEST_F(Supervisor, EndsAllWhenOneCannotBegin) {
    const auto work = [&](unsigned number, Pulse pulse) {
        if (number == 1) book_.write("began");
        while (number == 2 && book_.count("began") == 0)
            std::this_thread::sleep_for(5ms);
        if (number == 2) return 5;
        const int code = serve(pulse);
        book_.write("ended");
        return code;
    };
    EXPECT_EQ(supervise(2, limits(), work, [] { return 0; }), 5);
    EXPECT_EQ(book_.count("ended"), 1) << "in order";
}

TEST_F(Supervisor, TriesAgainWhenOneThatHadServedCannotBegin) {
    const auto work = [&](unsigned number, Pulse pulse) {
        book_.write("began");
        const auto times = book_.count("began");
        if (times == 2) return 5; // what it needs is still held by the one that was killed
        return serve(pulse, [&, until = Clock::now() + 500ms]() -> std::optional<int> {
            if (times == 1 && Clock::now() > until) raise(SIGKILL);
            static_cast<void>(number);
            return std::nullopt;
        });
    };
    EXPECT_EQ(supervise(1, limits(), work, when([&] { return book_.count("began") == 3; })), 0);
}

TEST_F(Supervisor, EndsWhenEachHasComeToItsEnd) {
    const auto work = [&](unsigned number, Pulse) { return number == 2 ? 1 : 0; }; // 1: stopped by a fault
    EXPECT_EQ(supervise(3, limits(), work, [] { return 0; }), 1);
}

TEST_F(Supervisor, HandsOnTheSignalThatEndsIt) {
    const auto work = [&](unsigned, Pulse pulse) {
        book_.write("began");
        const int code = serve(pulse);
        book_.write("ended by " + std::to_string(told));
        return code;
    };
    EXPECT_EQ(supervise(2, limits(), work, when([&] { return book_.count("began") == 2; })), 0);
    EXPECT_EQ(book_.count("ended by 15"), 2);
}

TEST_F(Supervisor, HasEachBeginAnewWhenItIsAskedToOneAfterTheOther) {
    static volatile std::sig_atomic_t asked = 0;
    std::signal(SIGUSR1, [](int) { asked = 1; });
    const auto work = [&](unsigned number, Pulse pulse) {
        book_.write("began " + std::to_string(number));
        return serve(pulse, [&]() -> std::optional<int> {
            if (asked == 0) return std::nullopt;
            book_.write("ends " + std::to_string(number));
            return 7;
        });
    };
    bool wanted = true;
    const auto anew = [&] { return book_.lines().size() == 3 && std::exchange(wanted, false); };
    EXPECT_EQ(supervise(3, limits(), work, when([&] { return book_.lines().size() == 9; }), anew), 0);
    const auto lines = book_.lines();
    ASSERT_EQ(lines.size(), 9U);
    EXPECT_THAT(std::vector(lines.begin() + 3, lines.end()),
                testing::ElementsAre("ends 1", "began 1", "ends 2", "began 2", "ends 3", "began 3"));
}

} // namespace
} // namespace windlass::workers
