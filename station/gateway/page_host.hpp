#pragma once
// What a page's session stands on, as far as it knows of that: the program, and the exercise that it looks
// at. No network: the gateway and its desks have it.

#include "station/gateway/lever_desk.hpp"
#include "station/gateway/orders.hpp"
#include "station/gateway/roles.hpp"

namespace windlass::gateway {

class PageSession;

/// One exercise, with the orders that go out and who has the levers. ExerciseDesk has more of it.
class PageDesk {
public:
    virtual ~PageDesk() = default;

    virtual const std::string& exercise() const = 0; ///< NAME without "exercise/"
    virtual const Role& role() const = 0;
    virtual LeverDesk& levers() = 0;
    /// The topic on which this role works that hand's levers; nullptr: it has none.
    virtual const wire::TopicInfo* lever_topic(Hand hand) const = 0;

    /// Throws Refused: what encode_order refuses, a topic that the role may not write here, and what nobody
    /// would hear. by: who gives it; empty: the station.
    virtual void give(const wire::TopicInfo& topic, const nlohmann::json& sample, const std::string& by) = 0;
    /// The levers that the page holds go out under that name; otherwise under the station's.
    virtual void call(LeverDesk::Page page, const std::string& name) = 0;
    /// The page is gone.
    virtual void leave(LeverDesk::Page page) = 0;
};

/// The program. What it does is said at Gateway's.
class PageHost {
public:
    virtual ~PageHost() = default;

    virtual void log(const std::string& line) = 0;
    virtual nlohmann::json hello(const PageSession& page) const = 0;
    virtual void forget(PageSession& page) = 0;
    virtual bool sees_truth() const = 0; ///< as has_truth() of the program's seat
    virtual void tell_given(const PageSession& by, const std::string& topic) const = 0;
    virtual bool order_classroom(const wire::TopicInfo& topic, const nlohmann::json& sample,
                                 const std::string& by) = 0;
    virtual nlohmann::json look_at_forecastle(const std::string& exercise, std::int64_t since) = 0;

    virtual void record(const std::string& exercise, bool on, const std::string& name) = 0;
    virtual std::string replay(const std::string& recording) = 0;
    virtual void continue_live(PageSession& page, const nlohmann::json& id, const std::string& recording,
                               double position, const std::string& exercise) = 0;
    virtual void read_events(PageSession& page, const nlohmann::json& id, const std::string& recording) = 0;
    virtual void debrief(PageSession& page, const nlohmann::json& id, const std::string& recording) = 0;
    virtual void ask_exercise_files(PageSession& page, const nlohmann::json& id,
                                    const nlohmann::json& request) = 0;
};

} // namespace windlass::gateway
