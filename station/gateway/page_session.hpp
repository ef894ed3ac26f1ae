#pragma once
// One page of ours: beside the Foxglove protocol it has levers, orders and, for an instructor, recordings.

#include "station/gateway/page_host.hpp"
#include "station/gateway/session.hpp"

#include <nlohmann/json.hpp>

#include <array>

namespace windlass::gateway {

class PageSession final : public FoxgloveSession {
public:
    /// name: of who sits there, under which its orders go out; empty: the station's.
    PageSession(PageHost& host, std::shared_ptr<PageDesk> desk, std::vector<Source*> sources,
                Transport& transport, std::string name);
    ~PageSession() override;

    void open() override;
    void close() override;

    const PageDesk& desk() const { return *desk_; }
    const std::string& name() const { return name_; }
    /// When its hand last did something: gave an order or a report, or moved a lever; at first, when it came.
    Clock::time_point acted() const { return acted_.value_or(opened_); }
    bool has_acted() const { return acted_.has_value(); }

    /// Says hello again when it has changed.
    void tell_hello(const nlohmann::json& hello);
    void tell_levers(Hand hand, LeverDesk::Page holder, const std::string& taken_by = {});
    /// Says what is alerted in the classroom when it has changed.
    void tell_alerts(const nlohmann::json& alerts);
    bool watches_classroom() const { return watches_classroom_; }
    void tell_sent(const nlohmann::json& id);
    void tell_refused(const nlohmann::json& id, const Refused& refusal);
    /// The answer to an order, and that it is one.
    void tell(const nlohmann::json& id, const nlohmann::json& message);

protected:
    bool handle(const std::string& op, const nlohmann::json& message) override;
    void refuse(const nlohmann::json& message, const std::string& why) override;
    bool with_schema() const override { return false; }
    bool with_past() const override { return true; }

private:
    void order(const nlohmann::json& message);
    void levers(Hand hand, const nlohmann::json& message);
    void let_go(const nlohmann::json& message);
    void record(const nlohmann::json& message);
    void replay(const nlohmann::json& message);
    void continue_live(const nlohmann::json& message);
    void exercise_files(const nlohmann::json& message);
    void wind_sea(const nlohmann::json& message);
    void watch_classroom(const nlohmann::json& message);
    void camera(const nlohmann::json& message);
    void look_ahead_no_more();

    PageHost& host_;
    std::shared_ptr<PageDesk> desk_;
    const std::string name_;
    nlohmann::json hello_, alerts_;
    std::array<nlohmann::json, 3> set_; // levers as this page had them last, by Hand
    Clock::time_point opened_ = Clock::now();
    std::optional<Clock::time_point> acted_;
    bool watches_classroom_ = false;
    bool looks_ahead_ = false; // by its word predictions are made
    bool open_ = true;
};

} // namespace windlass::gateway
