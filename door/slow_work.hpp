#pragma once
// What would hold the network up: passwords, files, other machines. Beside the network's thread.

#include "station/gateway/request.hpp"

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <vector>

namespace windlass::door {

/// Called on the network's thread alone.
class SlowWork {
public:
    /// at_once: threads; 1: one thing after the other. waiting: beyond that people are asked to come again.
    explicit SlowWork(std::size_t at_once = 1, std::size_t waiting = 16)
        : at_once_{at_once}, most_{waiting} {}

    using Verdict = gateway::Verdict;

    /// work runs on a thread of its own and may throw; then: makes of what it returned the answer that is
    /// replied.
    template <class Result>
    void add(std::function<Result()> work, std::function<Verdict(Result)> then,
             std::function<void(Verdict)> reply) {
        if (waiting_.size() >= most_) return reply(gateway::refused(503, "many are at the door: try again"));
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
        std::erase_if(under_way_, [](const auto& done) { return done(); });
        while (under_way_.size() < at_once_ && !waiting_.empty()) {
            under_way_.push_back(waiting_.front()());
            waiting_.pop_front();
        }
    }

private:
    const std::size_t at_once_, most_;
    std::deque<std::function<std::function<bool()>()>> waiting_; // begins the work
    std::vector<std::function<bool()>> under_way_;               // whether it is done, which is told once
};

} // namespace windlass::door
