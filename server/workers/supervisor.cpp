#include "server/workers/supervisor.hpp"

#include <spdlog/spdlog.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

namespace windlass::workers {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kLook = 20ms;
// Of the silence between two looks: a supervisor that slept blames nobody.
constexpr auto kLongestLook = 200ms;
constexpr auto kWeigh = 1s; // its memory

/// bytes of the process in the machine's memory; 0: it is gone.
std::uint64_t memory_of(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    std::uint64_t pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::string in_words(int status) {
    if (WIFSIGNALED(status)) return fmt::format("was killed by signal {}", WTERMSIG(status));
    return fmt::format("ended with code {}", WEXITSTATUS(status));
}

class Worker {
public:
    Worker(unsigned number, const Limits& limits, const Work& work)
        : number_(number), limits_(limits), work_(work), next_start_(Clock::now()) {}
    ~Worker() { forget(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    bool at_work() const { return process_ > 0; }
    bool done() const { return code_.has_value(); } ///< by itself, or refused
    bool serves() const { return at_work() && serves_ && !asked_; }
    int code() const { return code_.value_or(0); }

    void start_when_due(Clock::time_point now) {
        if (!at_work() && !done() && now >= next_start_) start(now);
    }

    /// Reads its signs of life. since: the last look.
    void listen(Clock::duration since) {
        silence_ += std::min<Clock::duration>(since, kLongestLook);
        std::array<char, 64> told{};
        for (ssize_t read = 0; (read = ::read(pulse_, told.data(), told.size())) > 0;) {
            silence_ = {};
            serves_ = told[static_cast<std::size_t>(read) - 1] == 'r';
            served_ = served_ || serves_;
        }
    }

    /// Kills it where it hangs or has grown too much. stopping: it was told to end.
    void judge(Clock::time_point now, bool stopping) {
        if (!at_work() || killed_) return;
        const auto working = serves_ ? limits_.silence : limits_.starting;
        if (silence_ > (stopping ? limits_.ending : working))
            return end_it(fmt::format("hangs: it has given no sign of life for {:.1f} s",
                                      std::chrono::duration<double>(silence_).count()));
        if (limits_.memory == 0 || now < weighed_ + kWeigh) return;
        weighed_ = now;
        if (const auto memory = memory_of(process_); memory > limits_.memory)
            end_it(fmt::format("has grown to {} MB, at most {} are allowed", memory >> 20,
                               limits_.memory >> 20));
    }

    /// It has come to its end. stopping: it was told to.
    void ended(int status, bool stopping, Clock::time_point now) {
        forget();
        const bool by_itself = WIFEXITED(status);
        const int code = by_itself ? WEXITSTATUS(status) : 1;
        if (stopping || (by_itself && (code <= 1 || !served_))) {
            code_ = code;
            return;
        }
        if (asked_) {
            next_start_ = now;
            spdlog::info("worker {} begins anew", number_);
            return;
        }
        if (now - started_ > limits_.settled) early_ends_ = 0;
        const auto longest = serves_ ? limits_.served_pause : limits_.last_pause;
        const auto pause =
            early_ends_ == 0 ? 0ms : std::min(limits_.first_pause * (1 << (early_ends_ - 1)), longest);
        early_ends_ = std::min(early_ends_ + 1, 16);
        next_start_ = now + pause;
        spdlog::error("worker {} {}; it is started again{}", number_, in_words(status),
                      pause > 0ms ? fmt::format(" in {:.1f} s", 1e-3 * static_cast<double>(pause.count()))
                                  : "");
    }

    /// It is to end and to be started again, at once.
    void ask_to_begin_anew() {
        asked_ = at_work();
        signal(SIGUSR1);
    }

    pid_t process() const { return process_; }
    void signal(int number) const {
        if (at_work()) kill(process_, number);
    }

private:
    /// A machine that has no room for it just now is asked again later.
    void start(Clock::time_point now) {
        next_start_ = now + limits_.last_pause;
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return cannot_start();
        const pid_t supervisor = getpid();
        process_ = fork();
        if (process_ < 0) {
            cannot_start();
            close(ends[0]);
            close(ends[1]);
            return;
        }
        if (process_ == 0) {
            close(ends[0]);
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (getppid() != supervisor) _exit(1); // it was killed in between
            std::_Exit(work_(number_, Pulse(ends[1])));
        }
        close(ends[1]);
        pulse_ = ends[0];
        started_ = weighed_ = now;
        silence_ = {};
        serves_ = killed_ = asked_ = false;
        spdlog::debug("worker {} is process {}", number_, process_);
    }

    void cannot_start() const {
        spdlog::error("worker {} cannot be started: {}; it is tried again in {:.1f} s", number_,
                      std::generic_category().message(errno),
                      1e-3 * static_cast<double>(limits_.last_pause.count()));
    }

    void end_it(const std::string& why) {
        spdlog::error("worker {} {}; it is killed", number_, why);
        killed_ = true;
        signal(SIGKILL);
    }

    void forget() {
        process_ = 0;
        if (pulse_ >= 0) close(pulse_);
        pulse_ = -1;
    }

    const unsigned number_;
    const Limits& limits_;
    const Work& work_;
    pid_t process_ = 0;
    int pulse_ = -1; // the pipe's end to read from
    bool serves_ = false, served_ = false, killed_ = false, asked_ = false;
    std::optional<int> code_;
    int early_ends_ = 0; // one behind the other
    Clock::duration silence_{};
    Clock::time_point started_{}, weighed_{}, next_start_;
};

} // namespace

int supervise(unsigned count, const Limits& limits, const Work& work, const std::function<int()>& stop,
              const std::function<bool()>& anew) {
    std::vector<std::unique_ptr<Worker>> workers;
    for (unsigned number = 1; number <= count; ++number)
        workers.push_back(std::make_unique<Worker>(number, limits, work));
    int stopping = 0;                       // the signal that was handed on
    std::size_t next_anew = workers.size(); // that is to begin anew; the last is behind it
    for (auto looked = Clock::now();;) {
        const bool refused =
            std::ranges::any_of(workers, [](const auto& worker) { return worker->code() > 1; });
        if (const int wanted = refused ? SIGTERM : stop(); wanted != 0 && stopping == 0) {
            stopping = wanted;
            for (const auto& worker : workers)
                worker->signal(stopping);
        }
        if (anew()) next_anew = 0;
        const auto is_well = [](const auto& worker) { return worker->serves() || worker->done(); };
        if (next_anew < workers.size() && stopping == 0 && std::ranges::all_of(workers, is_well))
            workers[next_anew++]->ask_to_begin_anew();
        const auto now = Clock::now();
        for (const auto& worker : workers) {
            if (stopping == 0) worker->start_when_due(now);
            worker->listen(now - looked);
        }
        looked = now;
        int status = 0;
        for (pid_t process = 0; (process = waitpid(-1, &status, WNOHANG)) > 0;)
            for (const auto& worker : workers)
                if (worker->process() == process) worker->ended(status, stopping != 0, now);
        const bool over = std::ranges::all_of(workers, [&](const auto& worker) {
            return !worker->at_work() && (worker->done() || stopping != 0);
        });
        if (over) break;
        for (const auto& worker : workers)
            worker->judge(now, stopping != 0);
        std::this_thread::sleep_for(kLook);
    }
    const auto first = std::ranges::find_if(workers, [](const auto& worker) { return worker->code() != 0; });
    return first == workers.end() ? 0 : (*first)->code();
}

} // namespace windlass::workers
