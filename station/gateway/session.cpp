#include "station/gateway/session.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace windlass::gateway {

using nlohmann::json;

namespace {

// A hand that drags a lever makes some 60 messages a second, and there may be two.
constexpr double kMessagesPerSecond = 120;
constexpr double kBurst = 2 * kMessagesPerSecond;
constexpr int kRefusedForRate = 120; // then it is not carelessness any more

} // namespace

FoxgloveSession::FoxgloveSession(std::vector<Source*> sources, Transport& transport)
    : sources_{std::move(sources)}, transport_{transport}, allowance_{kBurst} {}

FoxgloveSession::~FoxgloveSession() {
    FoxgloveSession::close();
}

void FoxgloveSession::open() {
    send({{"op", "serverInfo"},
          {"name", server_name()},
          {"capabilities", json(capabilities())},
          {"metadata", {{"wire_version", std::to_string(WIRE_VERSION)}}}});
    advertise();
}

void FoxgloveSession::advertise() {
    json channels = json::array();
    for (const Source* source : sources_)
        for (json& channel : source->advertisements(with_schema()))
            channels.push_back(std::move(channel));
    send({{"op", "advertise"}, {"channels", std::move(channels)}});
}

void FoxgloveSession::take_text(std::string_view text, Clock::time_point now) {
    if (closed_ || !within_rate(now)) return;
    const json message = json::parse(text, nullptr, false);
    if (!message.is_object()) return refuse(nullptr, "a JSON object is expected");
    const auto op = message.find("op");
    if (op == message.end() || !op->is_string()) return refuse(message, "the message has no op");
    if (!handle(op->get<std::string>(), message)) refuse(message, "this op is not known here");
}

void FoxgloveSession::take_binary() {
    ++refused_;
    transport_.close(kBinaryRefused, "text messages only");
}

bool FoxgloveSession::handle(const std::string& op, const json& message) {
    if (op == "subscribe")
        subscribe(message);
    else if (op == "unsubscribe")
        unsubscribe(message);
    else
        return false;
    return true;
}

void FoxgloveSession::refuse(const json&, const std::string& why) {
    ++refused_;
    constexpr int kError = 2;
    send({{"op", "status"}, {"level", kError}, {"message", why}});
}

void FoxgloveSession::subscribe(const json& message) {
    const auto list = message.find("subscriptions");
    if (list == message.end() || !list->is_array())
        return refuse(message, "subscriptions: a list is expected");
    std::vector<std::pair<std::uint32_t, FramePtr>> kept;
    gather();
    for (const json& each : *list) {
        const auto number = [&each](const char* name) -> std::optional<std::uint32_t> {
            const auto found = each.is_object() ? each.find(name) : each.end();
            if (!each.is_object() || found == each.end() || !found->is_number_unsigned()) return std::nullopt;
            const auto value = found->get<std::uint64_t>();
            return value <= 0xFFFFFFFFU ? std::optional(static_cast<std::uint32_t>(value)) : std::nullopt;
        };
        const auto id = number("id"), channel = number("channelId");
        Source* from = nullptr;
        for (Source* source : sources_)
            if (channel && source->has(*channel)) from = source;
        if (!id || from == nullptr) {
            refuse(message, "subscriptions: id and channelId of an advertised channel are expected");
            continue;
        }
        {
            const std::scoped_lock lock{mutex_};
            const bool used =
                std::ranges::any_of(subscriptions_, [&](const auto& s) { return s.second == *id; });
            if (used || subscriptions_.contains(*channel)) {
                // Said below: refuse() takes the lock too.
                from = nullptr;
            } else {
                subscriptions_.emplace(*channel, *id);
            }
        }
        if (from == nullptr) {
            refuse(message, "subscriptions: this id or this channel is subscribed to already");
            continue;
        }
        from->listen(*channel, *this, [&](const std::vector<FramePtr>& frames) {
            for (const FramePtr& frame : frames)
                kept.emplace_back(*id, frame);
        });
    }
    deliver(std::move(kept));
}

void FoxgloveSession::gather() {
    const std::scoped_lock lock{mutex_};
    gathering_ = true;
}

/// What stands now, then what was, of all topics in the order in which it was heard, then what has come
/// since.
void FoxgloveSession::deliver(std::vector<std::pair<std::uint32_t, FramePtr>> kept) {
    std::ranges::stable_sort(
        kept, {}, [](const auto& each) { return std::pair(!each.second->standing, each.second->heard); });
    put([&] {
        for (const auto& [id, frame] : kept)
            outbox_.put_kept(id, frame, with_past());
        gathering_ = false;
        return std::ranges::all_of(std::exchange(new_, {}),
                                   [this](const auto& each) { return outbox_.put(each.first, each.second); });
    });
}

void FoxgloveSession::unsubscribe(const json& message) {
    const auto list = message.find("subscriptionIds");
    if (list == message.end() || !list->is_array())
        return refuse(message, "subscriptionIds: a list is expected");
    for (const json& each : *list) {
        std::optional<std::uint32_t> channel;
        {
            const std::scoped_lock lock{mutex_};
            for (const auto& [number, id] : subscriptions_)
                if (each == id) channel = number;
            if (channel) {
                subscriptions_.erase(*channel);
                outbox_.forget(each.get<std::uint32_t>());
            }
        }
        if (!channel) {
            refuse(message, "subscriptionIds: ids of subscriptions are expected");
            continue;
        }
        for (Source* source : sources_)
            source->leave(*channel, *this);
    }
}

void FoxgloveSession::close() {
    closed_ = true;
    for (Source* source : sources_)
        source->leave(*this);
    sources_.clear();
}

void FoxgloveSession::hear(const FramePtr& frame) {
    put([&] {
        const auto subscription = subscriptions_.find(frame->channel);
        if (subscription == subscriptions_.end()) return true;
        if (!gathering_) return outbox_.put(subscription->second, frame);
        new_.emplace_back(subscription->second, frame);
        return true;
    });
}

void FoxgloveSession::send(const json& message) {
    put([&] { return outbox_.put(message.dump(-1, ' ', false, json::error_handler_t::replace)); });
}

void FoxgloveSession::send_time(std::uint64_t ns) {
    put([&] {
        outbox_.put_time(ns);
        return true;
    });
}

void FoxgloveSession::put(const std::function<bool()>& into_outbox) {
    bool too_slow = false;
    {
        const std::scoped_lock lock{mutex_};
        if (overflown_) return;
        too_slow = overflown_ = !into_outbox();
    }
    if (too_slow)
        transport_.close(kTooSlow, "this page is too slow to be told everything: it may come again");
    else
        transport_.wake();
}

std::optional<Outbox::Item> FoxgloveSession::next() {
    const std::scoped_lock lock{mutex_};
    auto item = outbox_.pop();
    if (item && item->frame) item->ns = stamp(*item->frame);
    return item;
}

bool FoxgloveSession::within_rate(Clock::time_point now) {
    if (counted_until_ != Clock::time_point{})
        allowance_ =
            std::min(kBurst, allowance_ + kMessagesPerSecond *
                                              std::chrono::duration<double>(now - counted_until_).count());
    counted_until_ = now;
    if (allowance_ >= 1) {
        allowance_ -= 1;
        return true;
    }
    if (++beyond_rate_ > kRefusedForRate)
        transport_.close(kFlood, "too many messages");
    else
        refuse(nullptr, "too many messages: 120 a second are taken");
    return false;
}

} // namespace windlass::gateway
