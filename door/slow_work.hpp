#pragma once
// What would hold the network up: passwords, files. One after the other, beside the network's thread.

#include "station/gateway/request.hpp"

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>

namespace windlass::door {

/// Called on the network's thread alone.
class SlowWork {
public:
    static constexpr std::size_t kWaiting = 16; ///< beyond that people are asked to come again

    using Verdict = gateway::Verdict;

    /// work runs on a thread of its own and may throw; then: makes of what it returned the answer that is
    /// replied.
    template <class Result>
    void add(std::function<Result()> work, std::function<Verdict(Result)> then,
             std::function<void(Verdict)> reply) {
        if (waiting_.size() >= kWaiting)
            return reply(gateway::refused(503, "many are at the door: try again"));
        waiting_.push_back([work = std::move(work), then = std::move(then),
                            reply = std::move(reply)]() -> std::function<bool()> {
            auto made = std::make_shared<std::future<Result>>(std::async(std::launch::async, work));
            return [made, then, reply] {
                if (made->wait_for(std::chrono::seconds{0}) != std::future_status::ready) return false;
                try {
                    reply(then(made->get()));
                } catch (const std::exception& error) {
                    reply(gateway::refused(500, error.what()));
                }
                return true;
            };
        });
    }

    void tick() {
        if (done_ && done_()) done_ = {};
        if (done_ || waiting_.empty()) return;
        done_ = waiting_.front()();
        waiting_.pop_front();
    }

private:
    std::deque<std::function<std::function<bool()>()>> waiting_; // begins the work
    std::function<bool()> done_;                                 // of that which is under way
};

} // namespace windlass::door
