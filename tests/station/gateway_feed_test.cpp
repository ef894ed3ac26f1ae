// What a late page is given, and what a slow one loses.

#include "idl/payload.hpp"
#include "station/gateway/alert_watch.hpp"
#include "station/gateway/camera_watch.hpp"
#include "station/gateway/event_log.hpp"
#include "station/gateway/outbox.hpp"
#include "station/gateway/session.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <gmock/gmock.h>

namespace windlass::gateway {
namespace {

namespace topics = wire::topics;
using namespace std::chrono_literals;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

const Clock::time_point kStart{1h};

template <class T>
std::vector<std::uint8_t> cdr(const T& sample, bool swapped = false) {
    namespace fastcdr = eprosima::fastcdr;
    std::vector<std::uint8_t> bytes(T::getCdrSerializedSize(sample) + 8);
    fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
    fastcdr::Cdr out(buffer, swapped ? fastcdr::Cdr::BIG_ENDIANNESS : fastcdr::Cdr::LITTLE_ENDIANNESS,
                     fastcdr::Cdr::DDS_CDR);
    out.serialize_encapsulation();
    sample.serialize(out);
    bytes.resize(out.getSerializedDataLength());
    return bytes;
}

FramePtr frame(std::uint8_t mark, std::string instance = "", bool newest = false) {
    auto made = std::make_shared<SharedFrame>();
    made->newest_only = newest;
    made->instance = std::move(instance);
    made->payload = {mark};
    return made;
}

/// A sample of a stream at that exercise time, s; its mark is the time in whole seconds.
FramePtr at_time(double time, std::string instance = "", std::size_t bytes = 1) {
    auto made = std::make_shared<SharedFrame>();
    made->newest_only = true;
    made->instance = std::move(instance);
    made->time = time;
    made->payload.assign(bytes, static_cast<std::uint8_t>(time));
    return made;
}

std::vector<int> marks(const std::vector<FramePtr>& frames) {
    std::vector<int> found;
    for (const auto& each : frames)
        found.push_back(each->payload[0]);
    return found;
}

FramePtr alert(const char* text, AlertPriority priority, AlertCondition condition, double raised) {
    Alert sample;
    sample.code("made.up");
    sample.text(text);
    sample.side(1);
    sample.priority(priority);
    sample.condition(condition);
    sample.raised_time(raised);
    auto made = std::make_shared<SharedFrame>();
    made->payload = cdr(sample);
    return made;
}

// MSC.302(87): what is acknowledged or normal does not ask for attention; of what does, the highest priority
// comes first, of equal ones the latest.
TEST(AlertToTell, IsTheMostUrgentThatIsNotAcknowledged) {
    EXPECT_TRUE(alert_to_tell({}).is_null());
    EXPECT_TRUE(alert_to_tell({alert("acknowledged", ALERT_ALARM, ALERT_ACTIVE_ACKNOWLEDGED, 9),
                               alert("over", ALERT_EMERGENCY, ALERT_NORMAL, 9)})
                    .is_null());
    const json told =
        alert_to_tell({alert("late warning", ALERT_WARNING, ALERT_ACTIVE_UNACKNOWLEDGED, 30),
                       alert("early alarm", ALERT_ALARM, ALERT_ACTIVE_SILENCED, 10),
                       alert("late alarm", ALERT_ALARM, ALERT_RECTIFIED_UNACKNOWLEDGED, 20),
                       alert("acknowledged", ALERT_EMERGENCY, ALERT_ACTIVE_ACKNOWLEDGED, 40), frame(7)});
    EXPECT_EQ(told.at("text"), "late alarm");
    EXPECT_EQ(told.at("priority"), 2);
    EXPECT_EQ(told.at("side"), 1);
    EXPECT_EQ(told.at("raised_time"), 20.0);
    EXPECT_EQ(told.at("waiting"), 3);
}

TEST(CameraTopics, AreWhatABridgeHasAndNoTruth) {
    const auto bridge = role_of(station::Seat::conning, "mon-1").hears;
    for (const wire::TopicInfo* topic : camera_topics())
        EXPECT_TRUE(std::ranges::any_of(bridge, [&](const wire::TopicInfo* each) {
            return std::string_view(each->name) == topic->name;
        })) << topic->name;
}

TEST(SamplesSince, AreTheNewestOfEachInstanceThatALookBeforeHasNotHad) {
    const auto heard = [](std::string instance, int mark, int seconds) {
        auto made = std::make_shared<SharedFrame>();
        made->instance = std::move(instance);
        made->payload = {static_cast<std::uint8_t>(mark)};
        made->heard = kStart + std::chrono::seconds(seconds);
        return made;
    };
    const std::vector<FramePtr> kept{heard("port", 1, 1), heard("starboard", 2, 2), heard("port", 3, 3)};
    const auto told = [](const char* payload) {
        return json::array({topics::forecastle_camera.name, payload});
    };
    const auto& camera = topics::forecastle_camera;
    EXPECT_EQ(samples_since(kept, camera, kStart), json::array({told("Aw=="), told("Ag==")}));
    EXPECT_EQ(samples_since(kept, camera, kStart + 2s), json::array({told("Aw==")}));
    EXPECT_EQ(samples_since(kept, camera, kStart + 3s), json::array());
}

TEST(History, OfASmallPictureHasNoPast) {
    History history(topics::bridge_view, false, false);
    for (int second = 0; second < 100; ++second)
        history.keep(at_time(second), "server", kStart);
    EXPECT_THAT(marks(history.kept(kStart)), ElementsAre(99));
}

TEST(InstanceOf, IsTheKeyOfEveryKeyedTopic) {
    for (const bool swapped : {false, true}) {
        ChainState port, starboard;
        starboard.side(1);
        EXPECT_NE(instance_of(topics::chain_state, cdr(port, swapped)),
                  instance_of(topics::chain_state, cdr(starboard, swapped)));
        port.time(5);
        ChainState later = port;
        later.time(6);
        EXPECT_EQ(instance_of(topics::chain_state, cdr(port, swapped)),
                  instance_of(topics::chain_state, cdr(later, swapped)));

        std::set<std::string> instances;
        for (const char* code : {"brake.hot", "brake.hotter", "b"})
            for (const int side : {-1, 0, 1}) {
                Alert alert;
                alert.code(code);
                alert.side(side);
                alert.text("a text");
                instances.insert(instance_of(topics::alert, cdr(alert, swapped)));
            }
        EXPECT_EQ(instances.size(), 9U);

        BridgeOrder first, second;
        first.number(1);
        second.number(2);
        EXPECT_NE(instance_of(topics::bridge_order, cdr(first, swapped)),
                  instance_of(topics::bridge_order, cdr(second, swapped)));
    }
    EXPECT_EQ(instance_of(topics::ship_state, cdr(ShipState{})), "") << "it has no key";
    const std::vector<std::uint8_t> cut{0, 1, 0, 0, 255, 255, 255, 255, 'x'};
    EXPECT_EQ(instance_of(topics::alert, cut), "") << "a text that claims more than there is";
    EXPECT_EQ(instance_of(topics::alert, {}), "");
}

TEST(History, KeepsWhatALateJoinerOfDdsWouldGet) {
    History events(topics::event);
    for (int i = 0; i < 1100; ++i)
        events.keep(frame(static_cast<std::uint8_t>(i % 200)), "server", kStart);
    EXPECT_EQ(events.kept(kStart).size(), 1000U);
    EXPECT_EQ(marks(events.kept(kStart)).back(), 1099 % 200);

    History alerts(topics::alert);
    alerts.keep(frame(1, "a"), "server", kStart);
    alerts.keep(frame(2, "b"), "server", kStart);
    alerts.keep(frame(3, "a"), "server", kStart);
    EXPECT_THAT(marks(alerts.kept(kStart + 1h)), ElementsAre(2, 3));
}

TEST(History, KeepsTheNewestOfEveryStream) {
    History loads(topics::chain_state);
    for (int i = 0; i < 10; ++i)
        loads.keep(frame(static_cast<std::uint8_t>(i), i % 2 == 0 ? "port" : "starboard"), "server", kStart);
    EXPECT_THAT(marks(loads.kept(kStart)), ElementsAre(8, 9));
}

// What was set stays set when the hand has left, which no topic of the server tells.
TEST(History, KeepsTheLastWordOnLeversOfEachSideAndNoOrder) {
    History levers(topics::windlass_command);
    for (const int time : {1, 2, 3})
        levers.keep(at_time(time, "port"), "trainee", kStart);
    levers.keep(at_time(5, "starboard"), "another trainee", kStart);
    EXPECT_THAT(marks(levers.kept(kStart + 1h)), ElementsAre(3, 5));
    levers.back_to(4);
    EXPECT_THAT(marks(levers.kept(kStart)), ElementsAre(3)) << "what a restore has left was not said";
    History orders(topics::fault_command);
    orders.keep(frame(1), "instructor", kStart);
    EXPECT_THAT(orders.kept(kStart), IsEmpty());
}

TEST(TimeOf, IsTheExerciseTimeOfEveryTopicWithAPast) {
    const auto timed = [](auto sample) {
        sample.time(123.25);
        return sample;
    };
    ChainState chain;
    chain.side(1);
    for (const bool swapped : {false, true}) {
        EXPECT_EQ(time_of(topics::ship_state, cdr(timed(ShipState{}), swapped)), 123.25);
        EXPECT_EQ(time_of(topics::anchor_state, cdr(timed(AnchorState{}), swapped)), 123.25);
        EXPECT_EQ(time_of(topics::windlass_load, cdr(timed(WindlassLoad{}), swapped)), 123.25);
        EXPECT_EQ(time_of(topics::environment_state, cdr(timed(EnvironmentState{}), swapped)), 123.25);
        EXPECT_EQ(time_of(topics::bridge_view, cdr(timed(BridgeView{}), swapped)), 123.25);
        EXPECT_EQ(time_of(topics::exercise_status, cdr(timed(ExerciseStatus{}), swapped)), 123.25);
        EXPECT_EQ(time_of(topics::chain_state, cdr(timed(chain), swapped)), 123.25);
    }
    EXPECT_EQ(time_of(topics::report, cdr(Report{})), std::nullopt) << "it has none";
    auto cut = cdr(timed(ShipState{}));
    cut.resize(19);
    EXPECT_EQ(time_of(topics::ship_state, cut), std::nullopt);
    EXPECT_EQ(time_of(topics::ship_state, {}), std::nullopt);
    for (const wire::TopicInfo& topic : topics::all)
        EXPECT_TRUE(past_of(topic).frames == 0 || topic.rate > 0 || !topic.from_server) << topic.name;
}

TEST(History, KeepsThePastOfWhatIsPlottedASampleASecondAndItsNewest) {
    History loads(topics::windlass_load);
    for (int i = 0; i <= 550; ++i) // 5.5 s at 100 Hz of both sides
        for (const char* side : {"port", "starboard"})
            loads.keep(at_time(i / 100.0, side), "server", kStart);
    const auto kept = loads.kept(kStart);
    EXPECT_THAT(marks(kept), ElementsAre(0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 5, 5));
    EXPECT_EQ(kept.back()->time, 5.5);

    History still(topics::ship_state); // before the start, or paused: what was first stays first
    for (const int heard : {1, 2, 3}) {
        auto sample = std::make_shared<SharedFrame>(*at_time(0));
        sample->heard = kStart + std::chrono::seconds(heard);
        still.keep(sample, "server", kStart);
    }
    EXPECT_EQ(still.kept(kStart).front()->heard, kStart + 1s);

    History chain(topics::chain_state); // thousands of nodes in each
    for (int i = 0; i <= 5; ++i)
        chain.keep(at_time(i), "server", kStart);
    EXPECT_THAT(marks(chain.kept(kStart)), ElementsAre(5));
}

TEST(History, DropsWhatARestoreHasLeft) {
    History ship(topics::ship_state);
    for (const int time : {0, 1, 2, 3, 4, 5, 6})
        ship.keep(at_time(time), "server", kStart);
    for (const double time : {2.5, 3.5})
        ship.keep(at_time(time), "server", kStart);
    EXPECT_THAT(marks(ship.kept(kStart)), ElementsAre(0, 1, 2, 3)) << "0, 1, 2, 3.5: 2.5 is too near to 2";
    ship.keep(at_time(0), "server", kStart);
    EXPECT_THAT(marks(ship.kept(kStart)), ElementsAre(0)) << "a reset";
}

TEST(History, HasReportsOfAllStationsButNotThoseThatARestoreHasLeft) {
    History reports(topics::report);
    for (int i = 0; i < 300; ++i)
        reports.keep(at_time(i % 250 / 10.0), i % 2 == 0 ? "forecastle" : "desk", kStart);
    EXPECT_EQ(reports.kept(kStart + 1h).size(), 50U) << "time went back to 0";
    reports.back_to(2);
    EXPECT_EQ(reports.kept(kStart).size(), 21U);
    for (int i = 0; i < 1000; ++i)
        reports.keep(at_time(100), "forecastle", kStart);
    EXPECT_EQ(reports.kept(kStart).size(), 200U);
}

TEST(Past, IsBoundedByCountAndByBytes) {
    Past few({.apart = 1, .frames = 10, .bytes = 1000});
    for (int i = 0; i < 100; ++i)
        few.keep(at_time(i));
    EXPECT_EQ(few.frames().size(), 10U);
    EXPECT_EQ(few.frames().back()->time, 99);
    Past small({.apart = 1, .frames = 10, .bytes = 1000});
    for (int i = 0; i < 100; ++i)
        small.keep(at_time(i, "", 300));
    EXPECT_EQ(small.frames().size(), 3U);
    small.back_to(98);
    for (int i = 99; i < 110; ++i)
        small.keep(at_time(i, "", 300));
    EXPECT_EQ(small.frames().size(), 3U) << "what was dropped counts no longer";
    small.keep(at_time(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(small.frames().size(), 3U);
}

TEST(History, ForgetsStatesOfAServerThatAnotherFollowed) {
    for (const double taken_up : {0, 12}) {
        History alerts(topics::alert);
        alerts.keep(at_time(10, "a"), "first server", kStart);
        alerts.keep(at_time(taken_up, "b"), "second server", kStart);
        EXPECT_THAT(marks(alerts.kept(kStart)), ElementsAre(taken_up));
    }
}

// An exercise that is taken up goes on in the log that it had, and one that begins anew begins a new one.
TEST(History, OfWhatHappenedGoesOnWhereTheNextServerTakesUpTheExercise) {
    for (const wire::TopicInfo& topic : std::initializer_list<wire::TopicInfo>{
             topics::event, topics::forecastle_event, topics::forecastle_instruction}) {
        SCOPED_TRACE(topic.name);
        History log(topic);
        for (const double time : {0, 3, 8, 9})
            log.keep(at_time(time), "first server", kStart);
        log.keep(at_time(8), "second server", kStart);
        EXPECT_THAT(marks(log.kept(kStart)), ElementsAre(0, 3, 8, 8)) << "9 was lost with its server";
        log.keep(at_time(20), "second server", kStart);
        log.keep(at_time(0), "third server", kStart);
        EXPECT_THAT(marks(log.kept(kStart)), ElementsAre(0)) << "it has not kept the exercise";
    }
    History ship(topics::ship_state);
    for (const int time : {0, 1, 2, 3})
        ship.keep(at_time(time), "first server", kStart);
    ship.keep(at_time(2), "second server", kStart);
    EXPECT_THAT(marks(ship.kept(kStart)), ElementsAre(0, 1, 2, 2))
        << "so does what is plotted; then the newest";
    ship.keep(at_time(0), "third server", kStart);
    EXPECT_THAT(marks(ship.kept(kStart)), ElementsAre(0));
}

TEST(History, OfTheClassroomHasEveryServerUntilItIsSilent) {
    History rooms(topics::classroom_status, true);
    rooms.keep(frame(1, "a"), "a", kStart);
    rooms.keep(frame(2, "b"), "b", kStart + 2s);
    EXPECT_THAT(marks(rooms.kept(kStart + 2s)), ElementsAre(1, 2));
    EXPECT_THAT(marks(rooms.kept(kStart + 4s)), ElementsAre(2));
}

TEST(History, HasNoMoreInstancesThanItsTopicMayHave) {
    History loads(topics::chain_state); // two sides
    for (const char* instance : {"0", "1", "2", "3"})
        loads.keep(frame(static_cast<std::uint8_t>(*instance)), "server", kStart);
    for (int i = 0; i < 5; ++i)
        loads.keep(frame(static_cast<std::uint8_t>(i), std::to_string(i)), "server", kStart);
    EXPECT_THAT(marks(loads.kept(kStart)), ElementsAre(3, 4));
}

std::vector<int> sent(Outbox& outbox) {
    std::vector<int> found;
    while (const auto item = outbox.pop())
        found.push_back(item->frame ? item->frame->payload[0] : -1);
    return found;
}

TEST(Outbox, ASlowPageLosesOldStatesAndNothingElse) {
    Outbox outbox;
    EXPECT_TRUE(outbox.put(1, frame(10, "port", true)));
    EXPECT_TRUE(outbox.put(2, frame(1)));
    EXPECT_TRUE(outbox.put(1, frame(20, "starboard", true)));
    EXPECT_TRUE(outbox.put("text"));
    EXPECT_TRUE(outbox.put(1, frame(11, "port", true)));
    EXPECT_TRUE(outbox.put(2, frame(2)));
    EXPECT_TRUE(outbox.put(3, frame(30, "port", true))) << "another subscription";
    EXPECT_THAT(sent(outbox), ElementsAre(11, 1, 20, -1, 2, 30));
    EXPECT_TRUE(outbox.put(1, frame(12, "port", true)));
    EXPECT_THAT(sent(outbox), ElementsAre(12));
}

TEST(Outbox, ThousandsOfEventsAreTooManyAndStatesNeverAre) {
    Outbox outbox;
    for (int i = 0; i < 5000; ++i)
        outbox.put_kept(1, frame(1), false);
    for (std::size_t i = 0; i < Outbox::kMost; ++i)
        ASSERT_TRUE(outbox.put(1, frame(2)));
    EXPECT_FALSE(outbox.put(1, frame(2)));
    EXPECT_FALSE(outbox.put("text"));
    for (int i = 0; i < 5000; ++i)
        ASSERT_TRUE(outbox.put(2, frame(3, "port", true)));
    EXPECT_EQ(sent(outbox).size(), 5000 + Outbox::kMost + 1);
    EXPECT_TRUE(outbox.put("text")) << "there is room again";
}

TEST(LogOf, AnEventIsALineOfItsLevelWithCodeAndExerciseTime) {
    Event event;
    event.time(12.34);
    event.severity(EVENT_CAUTION);
    event.code("brake.hot");
    event.text("The lining smokes");
    SharedFrame heard;
    heard.payload = wire::encode(event);
    const FramePtr log = log_of(heard);
    ASSERT_NE(log, nullptr);
    EXPECT_EQ(log->channel, EventLog::kChannel);
    EXPECT_EQ(json::parse(log->payload), (json{{"timestamp", {{"sec", 12}, {"nsec", 340000000}}},
                                               {"level", 3},
                                               {"message", "12.3 s: The lining smokes"},
                                               {"name", "brake.hot"},
                                               {"file", ""},
                                               {"line", 0}}));
    heard.payload.resize(20);
    EXPECT_EQ(log_of(heard), nullptr) << "it ends too early";
}

// ------------------------------------------------------------------ sessions

class Ends : public Transport {
public:
    void wake() override {}
    void close(int code, const std::string&) override { codes.push_back(code); }
    std::vector<int> codes;
};

TEST(FoxgloveSession, APageThatTakesNothingIsEndedOnceTooMuchWaitsForIt) {
    Ends transport;
    FoxgloveSession session({}, transport);
    Clock::time_point now{};
    for (std::size_t k = 0; k < Outbox::kMost; ++k) // each is answered by one that says why it is refused
        session.take_text("{}", now += 10ms);
    EXPECT_THAT(transport.codes, IsEmpty());
    session.take_text("{}", now += 10ms);
    EXPECT_THAT(transport.codes, ElementsAre(1013));
    session.take_text("{}", now += 10ms);
    EXPECT_THAT(transport.codes, ElementsAre(1013)) << "it is ended once";
}

TEST(FoxgloveSession, APageThatReadsIsNeverTooSlow) {
    Ends transport;
    FoxgloveSession session({}, transport);
    Clock::time_point now{};
    for (std::size_t k = 0; k < 3 * Outbox::kMost; ++k) {
        session.take_text("{}", now += 10ms);
        while (session.next()) {
        }
    }
    EXPECT_THAT(transport.codes, IsEmpty());
}

/// Two channels with what was kept of them; a sample comes while the second is asked for.
class Kept : public Source {
public:
    json advertisements(bool) const override { return json::array(); }
    bool has(std::uint32_t channel) const override { return channel == 1 || channel == 2; }
    void listen(std::uint32_t channel, Ear& ear,
                const std::function<void(std::vector<FramePtr>)>& begin) override {
        begin(kept[channel]);
        if (channel == 1) ear.hear(frame_of(1, 9, 9s, true));
    }
    void leave(std::uint32_t, Ear&) override {}
    void leave(Ear&) override {}

    static FramePtr frame_of(std::uint32_t channel, std::uint8_t mark, Clock::duration heard, bool newest) {
        auto made = std::make_shared<SharedFrame>();
        made->channel = channel;
        made->newest_only = newest;
        made->heard = kStart + heard;
        made->payload = {mark};
        return made;
    }
    std::map<std::uint32_t, std::vector<FramePtr>> kept{
        {1, {frame_of(1, 1, 1s, true), frame_of(1, 3, 3s, true)}},
        {2, {frame_of(2, 2, 2s, false), frame_of(2, 4, 4s, false)}}};
};

class PageOfOurs : public FoxgloveSession {
public:
    using FoxgloveSession::FoxgloveSession;

protected:
    bool with_past() const override { return true; }
};

std::vector<int> sent(FoxgloveSession& session) {
    std::vector<int> found;
    while (const auto item = session.next())
        if (item->frame) found.push_back(item->frame->payload[0]);
    return found;
}

TEST(FoxgloveSession, APageIsToldThePastOfAllItsTopicsInTheOrderInWhichItWas) {
    Ends transport;
    Kept source;
    auto standing = std::make_shared<SharedFrame>(*Kept::frame_of(2, 7, 8s, false));
    standing->standing = true;
    source.kept[2].push_back(standing);
    const char* subscribe =
        R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 1}, {"id": 2, "channelId": 2}]})";
    PageOfOurs page({&source}, transport);
    page.take_text(subscribe, kStart);
    EXPECT_THAT(sent(page), ElementsAre(7, 1, 2, 3, 4, 9)) << "what stands, what was, what has come since";
    FoxgloveSession foreign({&source}, transport);
    foreign.take_text(subscribe, kStart);
    EXPECT_THAT(sent(foreign), ElementsAre(7, 9, 2, 4)) << "of a stream the newest";
}

TEST(FoxgloveSession, WhatIsKeptWaitsOnceForAPageThatSubscribesAgainAndAgainAndTakesNothing) {
    Ends transport;
    Kept source;
    PageOfOurs page({&source}, transport);
    Clock::time_point now = kStart;
    for (int id = 1; id <= 100; ++id) {
        const std::string number = std::to_string(id), before = std::to_string(id - 1);
        if (id > 1)
            page.take_text(R"({"op": "unsubscribe", "subscriptionIds": [)" + before + "]}", now += 100ms);
        page.take_text(R"({"op": "subscribe", "subscriptions": [{"id": )" + number + R"(, "channelId": 1}]})",
                       now += 100ms);
    }
    EXPECT_THAT(sent(page), ElementsAre(1, 3, 9));
}

TEST(Outbox, IsToldOfASubscriptionThatEndsAndHasRoomForAsMuchAgain) {
    Outbox outbox;
    for (std::size_t k = 0; k < Outbox::kMost; ++k)
        EXPECT_TRUE(outbox.put(1, frame(1)));
    EXPECT_TRUE(outbox.put(2, frame(2, "", true)));
    outbox.forget(1);
    EXPECT_TRUE(outbox.put(3, frame(3)));
    EXPECT_TRUE(outbox.put(2, frame(4, "", true))) << "takes the place of the state that still waits";
    EXPECT_EQ(outbox.pop()->frame->payload[0], 4);
    EXPECT_EQ(outbox.pop()->frame->payload[0], 3);
    outbox.put(2, frame(5, "", true));
    outbox.forget(2);
    EXPECT_TRUE(outbox.empty());
    outbox.put(2, frame(6, "", true));
    EXPECT_EQ(outbox.pop()->frame->payload[0], 6) << "and is no part of what was forgotten";
}

/// Counts what it is asked to do.
class Counting : public FoxgloveSession {
public:
    using FoxgloveSession::FoxgloveSession;
    int handled = 0;

protected:
    bool handle(const std::string&, const json&) override {
        ++handled;
        return true;
    }
};

// A page that is sent away has more on its way, and its socket still reads that: its levers would have been
// taken once more, by a session that nobody ends again.
TEST(FoxgloveSession, WhatComesBehindItsEndIsNotHeard) {
    Ends transport;
    Counting session({}, transport);
    session.take_text(R"({"op": "levers"})", kStart);
    session.close();
    session.take_text(R"({"op": "levers"})", kStart + 1s);
    EXPECT_EQ(session.handled, 1);
}

} // namespace
} // namespace windlass::gateway
