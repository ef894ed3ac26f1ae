#include "server/host/task_pool.hpp"

#include "common/thread_name.hpp"
#include "server/host/realtime.hpp"

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
        return std::ranges::find(running_, &task) != running_.end() ||
               std::ranges::find(running_giving_way_, &task) != running_giving_way_.end();
    };
    for (Queue* queue : {&queue_, &giving_way_}) {
        std::erase_if(*queue, [&](const Waiting& one) { return one.task == &task; });
        std::make_heap(queue->begin(), queue->end(), later);
    }
    if (!is_running()) return;
    leaving_.push_back(&task);
    done_.wait(lock, [&] { return !is_running(); });
    std::erase(leaving_, &task);
}

/// What is due by now keeps its time: who goes as fast as he can waits for no grain to end.
void TaskPool::put(Task& task) {
    const Task::Time due = task.due();
    Queue& queue = task.gives_way() ? giving_way_ : queue_;
    queue.push_back({due > std::chrono::steady_clock::now() ? end_of_grain(due) : due, &task});
    std::push_heap(queue.begin(), queue.end(), later);
}

bool TaskPool::has_room_for_who_gives_way() const {
    const bool alone = queue_.empty() && running_.empty();
    const std::size_t free = alone || threads_.size() == 1 ? 0 : 1;
    return running_giving_way_.size() + free < threads_.size();
}

/// Whose first is to be done next, now or when it falls due; null: there is nothing to be done.
TaskPool::Queue* TaskPool::next_queue(Task::Time now) {
    if (giving_way_.empty() || !has_room_for_who_gives_way()) return queue_.empty() ? nullptr : &queue_;
    if (queue_.empty()) return &giving_way_;
    const Task::Time due = queue_.front().due, giving_way = giving_way_.front().due;
    if (due > now) return giving_way < due ? &giving_way_ : &queue_;
    return giving_way + kPatience <= now ? &giving_way_ : &queue_;
}

/// Sees to it that somebody is awake when the first in the queue falls due.
void TaskPool::call_watch() {
    const Queue* next = next_queue(std::chrono::steady_clock::now());
    if (next == nullptr) return;
    if (!watched_) {
        idle_.notify_one();
    } else if (next->front().due < watched_until_) {
        watch_.notify_one();
    }
}

void TaskPool::keep_watch(std::unique_lock<std::mutex>& lock) {
    watched_ = true;
    watched_until_ = next_queue(std::chrono::steady_clock::now())->front().due;
    watch_.wait_until(lock, Task::Time(watched_until_));
    watched_ = false;
}

void TaskPool::do_first(Queue& queue, std::unique_lock<std::mutex>& lock) {
    std::pop_heap(queue.begin(), queue.end(), later);
    Task& task = *queue.back().task;
    queue.pop_back();
    auto& running = &queue == &queue_ ? running_ : running_giving_way_;
    running.push_back(&task);
    call_watch();
    lock.unlock();
    const bool again = task.run();
    lock.lock();
    std::erase(running, &task);
    if (std::find(leaving_.begin(), leaving_.end(), &task) != leaving_.end()) {
        done_.notify_all();
    } else if (again) {
        put(task);
    }
}

void TaskPool::work() {
    go_before_others();
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
        Queue* next = next_queue(now);
        const bool due = next != nullptr && next->front().due <= now;
        if (worked && (!due || now - paused >= kGrain)) {
            paused = now, worked = false;
            pause();
        } else if (due) {
            if (!worked) paused = now, worked = true;
            do_first(*next, lock);
        } else if (next == nullptr) {
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
