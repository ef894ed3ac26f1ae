#include "server/host/lookout.hpp"

#include "common/thread_name.hpp"

#include <spdlog/spdlog.h>

#include <pthread.h>

#include <algorithm>

namespace windlass::host {

namespace {

using namespace std::chrono_literals;

/// After it the core is free for an instant, in which Linux looks whether somebody waits for the other one.
constexpr auto kPause = 100us;

/// Whatever the thread that began this one is: it has a core only where nobody else wants it.
void give_way() {
    const sched_param idle{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &idle);
}

bool over(const run::RunStatus& status) {
    return status.state == exercise::RunState::finished ||
           status.state == exercise::RunState::stopped_by_fault;
}

} // namespace

bool Outlook::look(const run::Session& session, Time now, const Tell& tell) {
    const bool on = session.predicts();
    if (!on && !on_) return false;
    stands_ = !session.running();
    const std::uint64_t run = session.status().run;
    if (on != on_ || run != run_) {
        on_ = on, run_ = run;
        given_ = {};
        wanted_ = on ? run : 0;
        tell({.run = run,
              .tick = session.now_tick(),
              .time = session.now_time(),
              .state = on ? run::PredictionState::awaited : run::PredictionState::off,
              .moments = {},
              .events = {},
              .processor_time = 0});
    }
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return false;
    if (std::exchange(made_, false) && on && prediction_.run == run) tell(prediction_);
    const Stand stand{run, session.now_tick(), session.orders_taken()};
    if (!on || over(session.status()) || waits_ || at_it_ || now < rests_until_ || stand == given_)
        return false;
    const double began = thread_time();
    state_ = session.state();
    spent_ = thread_time() - began;
    given_ = stand;
    of_run_ = run;
    given_at_ = now;
    waits_ = true;
    return true;
}

void Outlook::close() {
    wanted_ = 0;
    closed_ = true;
}

bool Outlook::go_on() {
    if (!branch_) {
        const std::lock_guard lock(mutex_);
        if (!std::exchange(waits_, false)) return false;
        at_it_ = true;
    }
    const double began = thread_time();
    bool goes_on = true, made = true;
    try {
        if (!branch_) branch_.emplace(state_, of_run_);
        for (const Time end = Clock::now() + kTurn; goes_on && Clock::now() < end;)
            goes_on = branch_->step();
    } catch (const std::exception& error) { // no memory
        spdlog::warn("no prediction: {}", error.what());
        goes_on = made = false;
    }
    spent_ += thread_time() - began;
    if (wanted_ != of_run_) {
        goes_on = made = false;
    } else if (goes_on && (spent_ >= kMostTime || (!stands_ && Clock::now() - given_at_ >= kPatience))) {
        branch_->give_up();
        goes_on = false;
    }
    if (!goes_on) put_down(made);
    return true;
}

/// Rests until the time spent is the share that it may be.
void Outlook::put_down(bool made) {
    {
        const std::lock_guard lock(mutex_);
        if (made) {
            prediction_ = branch_->found();
            prediction_.processor_time = spent_;
        }
        made_ = made;
        at_it_ = false;
        const std::chrono::duration<double> rest(spent_ / kShare);
        rests_until_ =
            given_at_ + std::max<Clock::duration>(kApart, std::chrono::duration_cast<Clock::duration>(rest));
    }
    branch_.reset();
}

Lookout::Lookout() {
    const ThreadName name("lookout");
    thread_ = std::thread([this] { work(); });
}

Lookout::~Lookout() {
    stop_ = true;
    call();
    thread_.join();
}

std::shared_ptr<Outlook> Lookout::add() {
    auto outlook = std::make_shared<Outlook>();
    add(outlook);
    return outlook;
}

void Lookout::add(std::shared_ptr<IdleWork> work) {
    const std::lock_guard lock(mutex_);
    works_.push_back(std::move(work));
}

void Lookout::call() {
    ++calls_;
    calls_.notify_one();
}

std::vector<std::shared_ptr<IdleWork>> Lookout::works() {
    const std::lock_guard lock(mutex_);
    std::erase_if(works_, [](const auto& work) { return work->closed(); });
    return works_;
}

void Lookout::work() {
    give_way();
    while (!stop_) {
        const int calls = calls_;
        bool busy = false;
        for (const auto& work : works()) {
            if (stop_ || !work->go_on()) continue;
            busy = true;
            std::this_thread::sleep_for(kPause);
        }
        if (!busy && !stop_) calls_.wait(calls);
    }
}

} // namespace windlass::host
