#include "server/host/companion.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace windlass::host {

namespace {

/// s of exercise that hands go on in one piece, as often as they look. What they have done by then is shown
/// once it is known to tell nothing.
constexpr double kPiece = 0.1;
/// s of exercise by which hands may be late and still be shown: else they have yet to catch up.
constexpr double kLate = 1;

std::uint64_t ticks(double seconds, int tick_rate) {
    return static_cast<std::uint64_t>(std::llround(seconds * tick_rate));
}

} // namespace

bool Companion::look(run::Session& session, Time now, const Show& show) {
    if (now - looked_at_ < kApart) return false;
    looked_at_ = now;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return false;
    const bool hint = look_for_hint(session, now);
    return look_at_hands(session, show) || hint;
}

bool Companion::look_for_hint(run::Session& session, Time now) {
    const std::optional<bool> wanted = session.hint_wanted();
    const bool of_now = wanted == hint_forecastle_ && hint_of_ == session.setups();
    if (hint_ == Hint::found) {
        hint_ = Hint::none;
        if (of_now) session.tell_hint(found_);
        return false;
    }
    if (!wanted || (hint_ == Hint::asked && of_now)) return hint_ == Hint::asked;
    hint_state_ = session.state();
    hint_of_ = session.setups();
    hint_forecastle_ = *wanted;
    asked_at_ = now;
    hint_ = Hint::asked;
    return true;
}

bool Companion::look_at_hands(const run::Session& session, const Show& show) {
    if (!session.wants_ghost()) {
        const bool ends = attempt_ != 0;
        attempt_ = 0;
        made_ = false;
        return ends;
    }
    if (attempt_ != session.setups()) {
        attempt_ = session.setups();
        beginning_ = session.beginning();
        orders_.clear();
        others_given_ = 0;
        made_ = false;
    }
    for (; others_given_ < session.others().size(); ++others_given_)
        orders_.push_back(session.others()[others_given_]);
    until_ = session.now_tick();
    trainee_ = session.assessor().state(); // its lists keep their memory
    faults_ = session.snapshot().faults;
    if (made_)
        for (const bool forecastle : {true, false})
            if (session.shows_ghost(forecastle)) show(picture_, forecastle);
    return true;
}

bool Companion::go_on() {
    const bool searches = search();
    return play() || searches;
}

bool Companion::search() {
    Time asked_at;
    assess::AidWord found{.kind = assess::AidKind::told, .criterion = 0}; // that none is known
    {
        const std::lock_guard lock(mutex_);
        if (hint_ != Hint::asked) {
            search_.reset();
            return false;
        }
        asked_at = asked_at_;
        found.forecastle = hint_forecastle_;
        if (!hint_state_.empty()) {
            search_.reset();
            spent_ = 0;
        }
    }
    const double began = thread_time();
    bool goes_on = true;
    try {
        if (!search_) {
            std::vector<std::uint8_t> state;
            bool forecastle = true;
            {
                const std::lock_guard lock(mutex_);
                state = std::exchange(hint_state_, {});
                forecastle = hint_forecastle_;
            }
            search_.emplace(state, forecastle);
        }
        for (const Time end = Clock::now() + kTurn; goes_on && Clock::now() < end;)
            goes_on = search_->step();
    } catch (const std::exception& error) { // no memory
        spdlog::warn("no hint: {}", error.what());
        goes_on = false;
    }
    spent_ += thread_time() - began;
    if (goes_on && (spent_ >= kMostTime || Clock::now() - asked_at >= kPatience)) {
        search_->give_up();
        goes_on = false;
    }
    if (goes_on) return true;
    if (search_) {
        found = search_->found();
        spdlog::debug("a hint by {} branches in {:.1f} s", search_->tried(), spent_);
    }
    search_.reset();
    const std::lock_guard lock(mutex_);
    if (hint_ == Hint::asked && hint_state_.empty()) { // else it is asked anew
        found_ = found;
        hint_ = Hint::found;
    }
    return true;
}

/// False: no hands are wanted.
bool Companion::takes_what_is_new() {
    std::optional<run::Beginning> beginning;
    {
        const std::lock_guard lock(mutex_);
        if (attempt_ != playing_) {
            playing_ = attempt_;
            hands_.reset();
            ahead_ = false;
            orders_now_.clear();
            beginning = std::exchange(beginning_, std::nullopt);
        }
        if (playing_ == 0) return false;
        until_now_ = until_;
        trainee_now_ = trainee_;
        faults_now_ = faults_;
        orders_now_.insert(orders_now_.end(), orders_.begin(), orders_.end());
        orders_.clear();
    }
    if (!beginning) return hands_ != nullptr;
    try {
        made_now_ = {};
        hands_ = from_(*beginning);
        maker_.emplace(hands_->def());
    } catch (const std::exception& error) {
        spdlog::warn("the model's hands cannot be shown: {}", error.what());
        hands_.reset();
    }
    return hands_ != nullptr;
}

/// They have come to something that the trainee's lesson has not brought yet: what they do would tell it.
bool Companion::tells_too_much() {
    if (run::is_ahead(hands_->state(), trainee_now_)) return true;
    return std::ranges::any_of(hands_->seen().faults, [&](const exercise::FaultView& fault) {
        return fault.phase != exercise::FaultPhase::armed &&
               std::ranges::none_of(faults_now_, [&](const exercise::FaultView& his) {
                   return his.order.code == fault.order.code && his.order.side == fault.order.side &&
                          his.phase != exercise::FaultPhase::armed;
               });
    });
}

void Companion::play_on(Time end) {
    const int tick_rate = hands_->def().tick_rate_hz;
    const std::uint64_t piece = ticks(kPiece, tick_rate);
    bool goes_on = true, moved = false;
    const auto look = [&] {
        ahead_ = tells_too_much();
        if (ahead_) return;
        maker_->make(hands_->seen(), made_now_);
        moved = true;
    };
    if (ahead_) look();
    while (goes_on && !ahead_ && hands_->tick() + piece <= until_now_ && Clock::now() < end) {
        for (std::uint64_t k = 0; k < piece && goes_on; ++k) {
            const auto later = std::ranges::find_if(
                orders_now_, [&](const run::OrderView& order) { return order.tick > hands_->tick(); });
            for (auto order = orders_now_.begin(); order != later; ++order)
                hands_->take(order->command);
            orders_now_.erase(orders_now_.begin(), later);
            goes_on = hands_->step();
        }
        look();
    }
    // Those who wait are level with the trainee's lesson, and are shown as they stood before they were ahead
    // of it, however late that is by now.
    const bool level = ahead_ || !goes_on || hands_->tick() + ticks(kLate, tick_rate) >= until_now_;
    const std::lock_guard lock(mutex_);
    if (attempt_ != playing_ || made_now_.forecastle.empty() || !(made_ ? moved : level)) return;
    picture_ = made_now_;
    made_ = true;
}

bool Companion::play() {
    if (!takes_what_is_new()) return false;
    const std::uint64_t before = hands_->tick();
    try {
        play_on(Clock::now() + kTurn);
    } catch (const std::exception& error) {
        spdlog::warn("the model's hands go no further: {}", error.what());
        hands_.reset();
        return false;
    }
    return hands_->tick() != before;
}

} // namespace windlass::host
