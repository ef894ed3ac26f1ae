#pragma once
// One WebSocket: the Foxglove protocol as far as it is read-only. No network: texts in, texts and samples
// out.

#include "station/gateway/outbox.hpp"
#include "station/gateway/source.hpp"

#include <nlohmann/json_fwd.hpp>

#include <atomic>
#include <mutex>
#include <string_view>

namespace windlass::gateway {

/// Close codes of RFC 6455 that a session ends with.
enum CloseCode { kBinaryRefused = 1003, kFlood = 1008, kTooSlow = 1013 };

/// What carries a session to its page.
class Transport {
public:
    virtual ~Transport() = default;
    /// Something waits in the session's outbox. From any thread; quick.
    virtual void wake() = 0;
    /// Ends the connection. From any thread; quick.
    virtual void close(int code, const std::string& reason) = 0;
};

/// Everything but hear() and next() on one thread.
class FoxgloveSession : public Ear {
public:
    /// The sources and the transport outlive the session, or close() is called before they end.
    FoxgloveSession(std::vector<Source*> sources, Transport& transport);
    ~FoxgloveSession() override;
    FoxgloveSession(const FoxgloveSession&) = delete;
    FoxgloveSession& operator=(const FoxgloveSession&) = delete;

    /// Says hello and what there is to hear.
    virtual void open();

    /// A message of the page. now: for its rate.
    void take_text(std::string_view text, Clock::time_point now);
    void take_binary();

    /// The page is gone: nothing is heard any more, of it neither. What it sent before it knew may still
    /// come.
    virtual void close();

    /// Sends the page away. From any thread.
    void end(int code, const std::string& reason) { transport_.close(code, reason); }

    /// The next message to send; from any thread.
    std::optional<Outbox::Item> next();

    void hear(const FramePtr& frame) override;

    std::uint64_t refused() const { return refused_; } ///< messages so far

protected:
    /// A JSON object with its op. False: it is not known here.
    virtual bool handle(const std::string& op, const nlohmann::json& message);
    /// A message that is not taken; message: null where it is no JSON object.
    virtual void refuse(const nlohmann::json& message, const std::string& why);
    /// Of Foxglove's `serverInfo`.
    virtual std::string server_name() const { return "Windlass"; }
    /// Every channel with its schema: a page of ours has it compiled in, others need it.
    virtual bool with_schema() const { return true; }
    /// What it can do beside the protocol's least, as Foxglove's `capabilities`.
    virtual std::vector<std::string> capabilities() const { return {}; }
    /// ns of a sample that goes out.
    virtual std::uint64_t stamp(const SharedFrame& frame) const {
        return static_cast<std::uint64_t>(frame.written_unix_ns);
    }
    /// The past of streams, too, to one that comes late: a page of ours goes by the times in the samples,
    /// others by the time at which they come.
    virtual bool with_past() const { return false; }

    void send(const nlohmann::json& message);
    /// The time of the client's clock, ns, where `time` is among the capabilities. From any thread.
    void send_time(std::uint64_t ns);
    Transport& transport() { return transport_; }
    /// When the message came that is being handled.
    Clock::time_point now() const { return counted_until_; }

private:
    void advertise();
    void subscribe(const nlohmann::json& message);
    void unsubscribe(const nlohmann::json& message);
    bool within_rate(Clock::time_point now);
    void put(const std::function<bool()>& into_outbox);
    void gather();
    void deliver(std::vector<std::pair<std::uint32_t, FramePtr>> kept);

    std::vector<Source*> sources_;
    Transport& transport_;

    std::mutex mutex_; // of those below
    Outbox outbox_;
    bool gathering_ = false; // what was kept of several topics: what is new waits behind it
    std::vector<std::pair<std::uint32_t, FramePtr>> new_;  // by subscription
    std::map<std::uint32_t, std::uint32_t> subscriptions_; // by channel
    bool overflown_ = false;

    bool closed_ = false;

    double allowance_;
    Clock::time_point counted_until_{};
    int beyond_rate_ = 0;
    std::uint64_t refused_ = 0;
};

} // namespace windlass::gateway
