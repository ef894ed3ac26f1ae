#include "station/gateway/gateway.hpp"

#include "idl/payload.hpp"
#include "station/gateway/event_log.hpp"
#include "station/gateway/exercise_clock.hpp"
#include "station/gateway/page_session.hpp"
#include "station/gateway/scene_channel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::gateway {

using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr auto kUnused = 10s; // a page that is loaded anew comes back within that time
constexpr auto kNews = 500ms; // how often hello is looked at

/// A foreign client, which only looks on.
class Onlooker final : public FoxgloveSession {
public:
    Onlooker(std::shared_ptr<ExerciseDesk> desk, Transport& transport)
        : FoxgloveSession{{&desk->feed(), &log_, &scene_}, transport},
          desk_{std::move(desk)},
          log_{desk_->feed()},
          scene_{desk_->feed(), desk_->feed().channels()} {}
    ~Onlooker() override { Onlooker::close(); }

    void open() override {
        FoxgloveSession::open();
        // The time first: at a step back a client forgets what it has drawn.
        const auto tell = [this](double time, bool again) {
            send_time(nanoseconds(time));
            scene_.tell(time, again, Clock::now());
        };
        clock_.emplace(desk_->feed(), desk_->feed().channels(), tell);
    }

    void close() override {
        clock_.reset();
        FoxgloveSession::close();
    }

protected:
    std::string server_name() const override { return "Windlass " + desk_->exercise(); }
    std::vector<std::string> capabilities() const override { return {"time"}; }
    /// The protocol asks for one source of time in all that a server sends.
    std::uint64_t stamp(const SharedFrame& frame) const override { return nanoseconds(frame.time); }

private:
    std::shared_ptr<ExerciseDesk> desk_;
    EventLog log_;
    SceneChannel scene_;
    std::optional<ClockWatch> clock_; ///< while it is open
};

} // namespace

Gateway::Gateway(GatewayOptions options)
    : options_{std::move(options)},
      readers_{options_.readers ? *options_.readers : SharedReaders(wire::Participant(options_.member))},
      log_{options_.log} {
    const Role role = role_of(options_.seat, options_.exercise);
    classroom_ = std::make_unique<Feed>(readers_, wire::kClassroomPartition, Feed::Kind::classroom,
                                        role.classroom_hears);
    classroom_orders_ = std::make_unique<OrderWriters>(classroom_->participant(), role.classroom_writes,
                                                       options_.member.name);
    if (!options_.recorder.empty()) {
        std::vector<std::string> arguments = options_.recorder_arguments;
        if (!options_.config_root.empty())
            arguments.insert(arguments.end(), {"--config-root", options_.config_root.string()});
        recorders_.emplace(options_.recorder, std::move(arguments));
        if (!options_.replays)
            options_.replays =
                std::make_shared<Replays>(options_.recorder, options_.recorder_arguments, options_.log);
    }
    if (!options_.exercise.empty()) desk(options_.exercise);
}

Gateway::~Gateway() = default;

std::shared_ptr<ExerciseDesk> Gateway::desk(const std::string& exercise) {
    Desk& wanted = desks_[exercise];
    wanted.used = Clock::now();
    if (!wanted.desk) {
        try {
            wanted.desk = std::make_shared<ExerciseDesk>(
                readers_, exercise, options_.seat, options_.member.name,
                [this, exercise](Hand hand, LeverDesk::Page holder, const std::string& taken_by) {
                    levers_changed(exercise, hand, holder, taken_by);
                });
        } catch (...) {
            desks_.erase(exercise);
            throw;
        }
    }
    return wanted.desk;
}

std::shared_ptr<PageSession> Gateway::open_page(const std::string& exercise, Transport& transport,
                                                const std::string& name) {
    auto its_desk = desk(exercise);
    std::vector<Source*> sources{&its_desk->feed(), classroom_.get()};
    auto page =
        std::make_shared<PageSession>(*this, std::move(its_desk), std::move(sources), transport, name);
    pages_.insert(page.get());
    return page;
}

std::shared_ptr<FoxgloveSession> Gateway::open_foxglove(const std::string& exercise, Transport& transport) {
    return std::make_shared<Onlooker>(desk(exercise), transport);
}

bool Gateway::order_classroom(const wire::TopicInfo& topic, const json& sample, const std::string& by) {
    if (!classroom_orders_->has(topic)) return false;
    if (!classroom_->writer(wire::topics::classroom_status))
        throw Refused(topic.name, "", "an order", "no server is heard here");
    classroom_orders_->write(topic, sample, by);
    return true;
}

json Gateway::look_at_forecastle(const std::string& exercise, std::int64_t since) {
    using std::chrono::microseconds;
    const Topics hears = role_of(options_.seat, exercise).hears;
    const bool may = std::ranges::all_of(camera_topics(), [&](const wire::TopicInfo* topic) {
        return std::ranges::any_of(
            hears, [&](const wire::TopicInfo* each) { return std::string_view(each->name) == topic->name; });
    });
    if (!may || !has_truth(options_.seat))
        throw Refused("", "", "the cameras of other exercises", "for who has their truth");
    const auto all = live();
    if (std::ranges::find(all, exercise) == all.end())
        throw Refused("", "exercise", exercise, "an exercise that a server here has");
    const auto now = Clock::now();
    try {
        json samples = cameras_.look(readers_, exercise, Clock::time_point{microseconds{since}}, now);
        const auto at = std::chrono::duration_cast<microseconds>(now.time_since_epoch()).count();
        return {{"at", at}, {"samples", std::move(samples)}};
    } catch (const std::runtime_error& error) {
        throw Refused("", "exercise", exercise, error.what());
    }
}

void Gateway::tick(Clock::time_point now) {
    for (auto at = desks_.begin(); at != desks_.end();) {
        Desk& each = at->second;
        each.desk->tick(now);
        if (each.desk.use_count() > 1 || at->first == options_.exercise) each.used = now;
        at = now - each.used > kUnused ? desks_.erase(at) : std::next(at);
    }
    std::erase_if(continuations_, [&](Continuation& each) { return go_on(each, now); });
    std::erase_if(readings_, show);
    if (now < next_news_) return;
    next_news_ = now + kNews;
    tend_recorders();
    if (options_.replays) {
        for (const auto& [exercise, _] : desks_)
            options_.replays->looked_at(exercise, now);
        options_.replays->tick(now);
    }
    cameras_.tick(now);
    tell_news();
    tell_alerts();
}

std::vector<ClassroomStatus> Gateway::servers() const {
    std::vector<ClassroomStatus> found;
    for (const FramePtr& frame : classroom_->kept(wire::topics::classroom_status)) {
        try {
            found.push_back(wire::decode<ClassroomStatus>(frame->payload));
        } catch (const std::exception&) {
            continue; // of a writer that is no server of ours
        }
    }
    return found;
}

std::vector<std::string> Gateway::live() const {
    std::vector<std::string> names;
    if (!has_truth(options_.seat)) return names;
    for (const ClassroomStatus& server : servers())
        for (const auto& exercise : server.exercises())
            names.push_back(exercise.id().to_string());
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void Gateway::tell_given(const PageSession& by, const std::string& topic) const {
    if (options_.given)
        options_.given(by.name().empty() ? options_.member.name : by.name(), by.desk().exercise(), topic);
}

json Gateway::hello(const PageSession& page) const {
    const PageDesk& its_desk = page.desk();
    json commands = json::array();
    for (const wire::TopicInfo* topic : its_desk.role().writes)
        commands.push_back(topic->name);
    for (const wire::TopicInfo* topic : its_desk.role().classroom_writes)
        commands.push_back(topic->name);
    const auto recording = recordings_.find(its_desk.exercise());
    const auto recorded = recorded_.find(its_desk.exercise());
    return {{"op", "hello"},
            {"protocol", 1},
            {"wire_version", WIRE_VERSION},
            {"seat", its_desk.role().name},
            {"exercise", its_desk.exercise()},
            {"name", page.name().empty() ? options_.member.name : page.name()},
            {"commands", std::move(commands)},
            {"recording", recording == recordings_.end() ? json() : json(recording->second.name)},
            {"recorded", recorded == recorded_.end() ? json() : json(recorded->second)},
            {"live", live()},
            {"hand_silent", wire::topics::kCommandDeadline}};
}

void Gateway::tell_news() {
    for (PageSession* page : pages_)
        page->tell_hello(hello(*page));
}

void Gateway::tell_alerts() {
    const bool watched = std::ranges::any_of(pages_, &PageSession::watches_classroom);
    alerts_.follow(readers_, watched ? live() : std::vector<std::string>());
    if (!watched) return;
    const json told{{"op", "classroom_alerts"}, {"exercises", alerts_.told()}};
    for (PageSession* page : pages_)
        if (page->watches_classroom()) page->tell_alerts(told);
}

void Gateway::forget(PageSession& page) {
    pages_.erase(&page);
    for (Continuation& each : continuations_)
        if (each.page == &page) each.page = nullptr;
    for (Reading& each : readings_)
        if (each.page == &page) each.page = nullptr;
}

void Gateway::levers_changed(const std::string& exercise, Hand hand, LeverDesk::Page holder,
                             const std::string& taken_by) {
    for (PageSession* page : pages_) {
        if (page->desk().exercise() != exercise) continue;
        page->tell_levers(hand, holder, taken_by);
        if (page == holder) tell_given(*page, page->desk().lever_topic(hand)->name);
    }
}

} // namespace windlass::gateway
