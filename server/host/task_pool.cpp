#include "server/host/task_pool.hpp"

#include "common/thread_name.hpp"

#include <algorithm>
#include <ratio>

namespace windlass::host {

namespace {

/// The end of the grain of time that this instant lies in.
Task::Time end_of_grain(Task::Time instant) {
    return Task::Time(
        std::chrono::ceil<std::chrono::duration<std::int64_t, TaskPool::Grain>>(instant.time_since_epoch()));
}

} // namespace

TaskPool::TaskPool(unsigned threads, std::function<void()> pause) : pause_(std::move(pause)) {
    threads_.reserve(threads);
    const ThreadName name("tick");
    for (unsigned i = 0; i < std::max(1U, threads); ++i)
        threads_.emplace_back([this] { work(); });
}

TaskPool::~TaskPool() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    watch_.notify_all();
    idle_.notify_all();
    for (auto& thread : threads_)
        thread.join();
}

void TaskPool::add(Task& task) {
    const std::lock_guard lock(mutex_);
    put(task);
    call_watch();
}

void TaskPool::remove(const Task& task) {
    std::unique_lock lock(mutex_);
    const auto is_running = [&] {
        return std::find(running_.begin(), running_.end(), &task) != running_.end();
    };
    std::erase_if(queue_, [&](const Waiting& one) { return one.task == &task; });
    std::make_heap(queue_.begin(), queue_.end(), later);
    if (!is_running()) return;
    leaving_.push_back(&task);
    done_.wait(lock, [&] { return !is_running(); });
    std::erase(leaving_, &task);
}

/// What is due by now keeps its time: who goes as fast as he can waits for no grain to end.
void TaskPool::put(Task& task) {
    const Task::Time due = task.due();
    queue_.push_back({due > std::chrono::steady_clock::now() ? end_of_grain(due) : due, &task});
    std::push_heap(queue_.begin(), queue_.end(), later);
}

/// Sees to it that somebody is awake when the first in the queue falls due.
void TaskPool::call_watch() {
    if (!watched_) {
        idle_.notify_one();
    } else if (queue_.front().due < watched_until_) {
        watch_.notify_one();
    }
}

void TaskPool::keep_watch(std::unique_lock<std::mutex>& lock) {
    watched_ = true;
    watched_until_ = queue_.front().due;
    watch_.wait_until(lock, Task::Time(watched_until_));
    watched_ = false;
}

void TaskPool::do_first(std::unique_lock<std::mutex>& lock) {
    std::pop_heap(queue_.begin(), queue_.end(), later);
    Task& task = *queue_.back().task;
    queue_.pop_back();
    running_.push_back(&task);
    if (!queue_.empty()) call_watch();
    lock.unlock();
    const bool again = task.run();
    lock.lock();
    std::erase(running_, &task);
    if (std::find(leaving_.begin(), leaving_.end(), &task) != leaving_.end()) {
        done_.notify_all();
    } else if (again) {
        put(task);
    }
}

void TaskPool::work() {
    std::unique_lock lock(mutex_);
    Task::Time paused{};
    const auto pause = [&] {
        lock.unlock();
        pause_();
        lock.lock();
    };
    bool worked = false; // since the last pause
    while (!stop_) {
        const Task::Time now = std::chrono::steady_clock::now();
        const bool due = !queue_.empty() && queue_.front().due <= now;
        if (worked && (!due || now - paused >= kGrain)) {
            paused = now, worked = false;
            pause();
        } else if (due) {
            if (!worked) paused = now, worked = true;
            do_first(lock);
        } else if (queue_.empty()) {
            idle_.wait(lock);
        } else if (!watched_) {
            keep_watch(lock);
        } else { // one thread at most waits for a time: were it all of them, each beat would wake all
            call_watch();
            idle_.wait(lock);
        }
    }
}

} // namespace windlass::host
