// What Foxglove and Lichtblick are shown: the exercise's time, and its scene as foxglove.SceneUpdate.

#include "idl/payload.hpp"
#include "station/gateway/exercise_clock.hpp"
#include "station/gateway/outbox.hpp"
#include "station/gateway/scene_channel.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace windlass::gateway {
namespace {

namespace topics = wire::topics;
using namespace std::chrono_literals;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// ------------------------------------------------------------------ time

TEST(ExerciseClock, GoesForwardWithinARunAsSoonAsAnyStateTellsIt) {
    ExerciseClock clock;
    EXPECT_FALSE(clock.hear_status(10, 1));
    EXPECT_FALSE(clock.hear_status(10.2, 1));
    std::vector<double> times;
    for (const double heard : {10.25, 10.22, 10.3, 10.1}) { // as topics overtake each other
        clock.hear_state(heard);
        times.push_back(clock.time());
    }
    EXPECT_THAT(times, ElementsAre(10.25, 10.25, 10.3, 10.3));
    EXPECT_FALSE(clock.hear_status(10.28, 1));
    EXPECT_EQ(clock.time(), 10.3);
}

TEST(ExerciseClock, GoesBackWithARestoreAndNoStateOfTheRunThatWasLeftTakesItForwardAgain) {
    ExerciseClock clock;
    clock.hear_status(100, 1);
    clock.hear_status(100.2, 1);
    clock.hear_state(40); // of the restored run, ahead of its status
    EXPECT_EQ(clock.time(), 100.2);
    EXPECT_TRUE(clock.hear_status(40, 2));
    clock.hear_state(100.25);
    EXPECT_EQ(clock.time(), 40);
    EXPECT_FALSE(clock.hear_status(40, 2)) << "paused";
    clock.hear_state(40.1);
    EXPECT_EQ(clock.time(), 40);
    clock.hear_status(40.2, 2);
    clock.hear_state(40.5);
    EXPECT_EQ(clock.time(), 40.5);
    EXPECT_TRUE(clock.hear_status(40.1, 2)) << "a replay that is wound back";
    EXPECT_TRUE(clock.hear_status(90, 3)) << "a restore to a later moment is another run, too";
    EXPECT_EQ(clock.time(), 90);
}

TEST(Nanoseconds, AreZeroForWhatIsNoTime) {
    EXPECT_EQ(nanoseconds(12.25), 12'250'000'000U);
    for (const double none : {-1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(nanoseconds(none), 0U);
    EXPECT_EQ(nanoseconds(std::numeric_limits<double>::infinity()), 9'000'000'000'000'000'000U);
}

TEST(Outbox, OfTimesThatWaitHasTheNewest) {
    Outbox outbox;
    outbox.put_time(1);
    outbox.put("text");
    outbox.put_time(2);
    const auto first = outbox.pop(), second = outbox.pop();
    EXPECT_TRUE(first->is_time);
    EXPECT_EQ(first->ns, 2U);
    EXPECT_EQ(second->text, "text");
    EXPECT_TRUE(outbox.empty());
}

// ------------------------------------------------------------------ scene

Vec3 at(double x, double y, double z) {
    Vec3 made;
    made.x(x);
    made.y(y);
    made.z(z);
    return made;
}
Point3f node(float x, float y, float z) {
    Point3f made;
    made.x(x);
    made.y(y);
    made.z(z);
    return made;
}
Quaternion turned(double heading) { // about the vertical, rad clockwise from north
    const double half = (std::numbers::pi / 2 - heading) / 2;
    Quaternion made;
    made.w(std::cos(half));
    made.z(std::sin(half));
    return made;
}

/// A ship that heads west at 100, 50; her port anchor east of her hawse in 25 m and 2 m of tide.
SceneHeard anchored() {
    SceneHeard heard;
    heard.plan.emplace();
    heard.plan->hull_corners({node(0, 0, -5), node(50, 0, -5), node(0, 10, 5)});
    heard.plan->hull_triangles({0, 1, 2});
    SceneTackle tackle;
    tackle.shank_length(3);
    tackle.fluke_length(2);
    heard.plan->tackle({tackle});
    heard.bed.emplace().depth(25);
    heard.sea.emplace().tide_height(2);
    heard.ship.emplace().position(at(100, 50, 0.25));
    heard.ship->attitude(turned(1.5 * std::numbers::pi));
    heard.chains[0].emplace().nodes({node(60, 50, 6), node(100, 50, -27), node(180.0001F, 50, -26.9F)});
    heard.anchors[0].emplace().shackle(at(180, 50, -26.9));
    heard.anchors[0]->attitude(turned(1.5 * std::numbers::pi)); // its crown lies east of the shackle
    heard.anchors[0]->fluke_angle(std::numbers::pi / 2);
    return heard;
}

json entity(const json& update, const std::string& id) {
    for (const json& each : update.at("entities"))
        if (each.at("id") == id) return each;
    return {};
}

std::vector<double> xyz(const json& at) {
    return {at.at("x"), at.at("y"), at.at("z")};
}

/// Field by field: all that the schema names, and nothing else.
void expect_fits(const json& value, const json& schema, const std::string& where) {
    if (schema.contains("oneOf")) {
        EXPECT_TRUE(std::ranges::any_of(schema["oneOf"], [&](const json& row) {
            return row["const"] == value;
        })) << where;
        return;
    }
    const std::string type = schema.at("type");
    if (type == "array") {
        ASSERT_TRUE(value.is_array()) << where;
        for (const json& each : value)
            expect_fits(each, schema.at("items"), where + "[]");
    } else if (type == "object") {
        ASSERT_TRUE(value.is_object()) << where;
        for (const auto& [name, unused] : value.items())
            EXPECT_TRUE(schema.at("properties").contains(name)) << where << "." << name;
        for (const auto& [name, field] : schema.at("properties").items()) {
            ASSERT_TRUE(value.contains(name)) << where << "." << name;
            expect_fits(value[name], field, where + "." + name);
        }
    } else {
        EXPECT_TRUE(type == "number"    ? value.is_number()
                    : type == "integer" ? value.is_number_integer()
                    : type == "string"  ? value.is_string()
                                        : value.is_boolean())
            << where << ": " << value;
    }
}

std::vector<std::string> fields(const json& schema) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : schema.at("properties").items())
        names.push_back(name);
    return names;
}

TEST(SceneUpdate, HasTheFieldsOfItsSchemaAndTheSchemaThoseThatFoxglovePublishes) {
    const json schema = json::parse(scene_schema());
    expect_fits(json::parse(scene_update(anchored(), 12.5, 30)), schema, "SceneUpdate");
    EXPECT_EQ(schema.at("title"), "foxglove.SceneUpdate");
    EXPECT_THAT(fields(schema), ElementsAre("deletions", "entities"));
    EXPECT_THAT(fields(schema["properties"]["deletions"]["items"]), ElementsAre("id", "timestamp", "type"));
    const json& one = schema["properties"]["entities"]["items"];
    EXPECT_EQ(one.at("title"), "foxglove.SceneEntity");
    EXPECT_THAT(fields(one),
                ElementsAre("arrows", "cubes", "cylinders", "frame_id", "frame_locked", "id", "lifetime",
                            "lines", "metadata", "models", "spheres", "texts", "timestamp", "triangles"));
    const auto of = [&](const char* kind) { return fields(one["properties"][kind]["items"]); };
    EXPECT_THAT(of("lines"), ElementsAre("color", "colors", "indices", "points", "pose", "scale_invariant",
                                         "thickness", "type"));
    EXPECT_THAT(of("triangles"), ElementsAre("color", "colors", "indices", "points", "pose"));
    EXPECT_THAT(of("arrows"), ElementsAre("color", "head_diameter", "head_length", "pose", "shaft_diameter",
                                          "shaft_length"));
    EXPECT_THAT(of("cubes"), ElementsAre("color", "pose", "size"));
}

TEST(SceneUpdate, DrawsEachThingWhereItsTopicHasIt) {
    const json update = json::parse(scene_update(anchored(), 12.5));
    EXPECT_THAT(update["deletions"], IsEmpty());
    for (const json& each : update["entities"]) {
        EXPECT_EQ(each["frame_id"], "world");
        EXPECT_EQ(each["timestamp"], (json{{"sec", 12}, {"nsec", 500'000'000}}));
    }
    EXPECT_THAT(update["entities"], SizeIs(5)) << "nothing was heard of a starboard side";

    const json line = entity(update, "port_cable")["lines"][0];
    EXPECT_EQ(line["type"], 0);
    EXPECT_THAT(xyz(line["points"].front()), ElementsAre(60, 50, 6)) << "at the hawse";
    EXPECT_THAT(xyz(line["points"].back()), ElementsAre(180, 50, -26.9))
        << "at the anchor, to the millimetre";

    EXPECT_THAT(xyz(entity(update, "water")["cubes"][0]["pose"]["position"]), ElementsAre(100, 50, 0));
    EXPECT_THAT(xyz(entity(update, "seabed")["cubes"][0]["pose"]["position"]), ElementsAre(100, 50, -27))
        << "the tide stands over the chart's datum";

    const json hull = entity(update, "ship")["triangles"][0];
    EXPECT_THAT(xyz(hull["pose"]["position"]), ElementsAre(100, 50, 0.25));
    EXPECT_NEAR(std::abs(hull["pose"]["orientation"]["z"].get<double>()), 1, 1e-12) << "she heads west";
    EXPECT_EQ(hull["indices"], json({0, 1, 2}));

    const json anchor = entity(update, "port_anchor");
    EXPECT_THAT(xyz(anchor["arrows"][0]["pose"]["position"]), ElementsAre(180, 50, -26.9));
    EXPECT_NEAR(std::abs(anchor["arrows"][0]["pose"]["orientation"]["w"].get<double>()), 1, 1e-12)
        << "it points along x, to the crown";
    EXPECT_THAT(xyz(anchor["cubes"][0]["pose"]["position"]), ElementsAre(183, 50, -27.9))
        << "flukes straight down from the crown, 3 m on, their middle 1 m deeper";
}

TEST(SceneUpdate, ABedThatRisesIsDrawnSo) {
    SceneHeard heard = anchored();
    heard.bed->slope(0.1);
    heard.bed->slope_towards(std::numbers::pi / 2); // east
    const json pose = entity(json::parse(scene_update(heard, 0)), "seabed")["cubes"][0]["pose"];
    EXPECT_NEAR(pose["position"]["z"].get<double>(), -27 + 100 * std::tan(0.1), 1e-3);
    EXPECT_NEAR(pose["orientation"]["y"].get<double>(), -std::sin(0.05), 1e-12) << "its east side is up";
    EXPECT_NEAR(pose["orientation"]["x"].get<double>(), 0, 1e-12);
}

TEST(SceneHeard, TakesSamplesOfBothSidesAndNoneThatIsBroken) {
    SceneHeard heard;
    ChainState chain;
    for (const int side : {0, 1, 2, -1}) {
        chain.side(side);
        heard.hear(topics::chain_state, wire::encode(chain));
    }
    EXPECT_TRUE(heard.chains[0] && heard.chains[1]);
    auto cut = wire::encode(ShipState{});
    cut.resize(30);
    heard.hear(topics::ship_state, cut);
    EXPECT_FALSE(heard.ship);
    EXPECT_EQ(json::parse(scene_update(heard, 1))["entities"][0]["lines"], json::array())
        << "a cable without nodes";
}

// ------------------------------------------------------------------ channel

std::vector<Channel> channels_of(const Topics& hears) {
    std::vector<Channel> made;
    for (const wire::TopicInfo* topic : hears)
        made.push_back({static_cast<std::uint32_t>(made.size() + 1), topic->name, topic});
    return made;
}

/// A feed that says what a test has it say.
class Said : public Source {
public:
    json advertisements(bool) const override { return json::array(); }
    bool has(std::uint32_t) const override { return true; }
    void listen(std::uint32_t channel, Ear& ear, const std::function<void(std::vector<FramePtr>)>&) override {
        ears.emplace(channel, &ear);
    }
    void leave(std::uint32_t channel, Ear&) override { ears.erase(channel); }
    void leave(Ear&) override { ears.clear(); }

    template <class T>
    void say(const wire::TopicInfo& topic, const T& sample, double time = 0) {
        auto frame = std::make_shared<SharedFrame>();
        frame->channel = number_of(channels, topic);
        frame->time = time;
        frame->payload = wire::encode(sample);
        if (const auto found = ears.find(frame->channel); found != ears.end()) found->second->hear(frame);
    }

    std::vector<Channel> channels = channels_of(role_of(station::Seat::instructor, "mine").hears);
    std::map<std::uint32_t, Ear*> ears;
};

struct Shown : Ear {
    void hear(const FramePtr& frame) override { updates.push_back(json::parse(frame->payload)); }
    std::vector<json> updates;
};

TEST(SceneChannel, IsThereOnlyWhereTheSeatHearsAllThatItIsMadeOf) {
    using station::Seat;
    Said feed;
    for (const Seat seat : {Seat::forecastle, Seat::conning, Seat::trainee, Seat::watcher, Seat::observer,
                            Seat::assessor, Seat::instructor}) {
        const Role role = role_of(seat, "mine");
        const SceneChannel channel(feed, channels_of(role.hears));
        EXPECT_EQ(channel.has(SceneChannel::kChannel), has_truth(seat)) << role.name;
        EXPECT_EQ(channel.advertisements(true).size(), has_truth(seat) ? 1U : 0U) << role.name;
        for (const wire::TopicInfo* lacking : scene_topics()) {
            Topics fewer = role.hears;
            std::erase_if(fewer,
                          [&](const auto* each) { return std::string_view(each->name) == lacking->name; });
            EXPECT_FALSE(SceneChannel(feed, channels_of(fewer)).has(SceneChannel::kChannel)) << lacking->name;
        }
    }
}

TEST(SceneChannel, SendsWhatIsNewTenTimesASecondAndNothingWhileNobodyListens) {
    Said feed;
    Shown client;
    SceneChannel channel(feed, feed.channels);
    channel.tell(1, false, Clock::now());
    EXPECT_THAT(feed.ears, IsEmpty());
    channel.listen(SceneChannel::kChannel, client, [](const auto& kept) { EXPECT_THAT(kept, SizeIs(1)); });
    auto now = Clock::now() + 1h; // beyond the first, which listen() has sent
    ShipState ship;
    for (int tick = 0; tick < 60; ++tick) { // a second of states
        ship.position().x(tick);
        feed.say(topics::ship_state, ship);
        channel.tell(1 + tick / 60.0, false, now += 16'667us);
    }
    EXPECT_GE(client.updates.size(), 8U);
    EXPECT_LE(client.updates.size(), 10U);
    client.updates.clear();
    for (int status = 0; status < 10; ++status) // a pause
        channel.tell(2, false, now += 200ms);
    EXPECT_THAT(client.updates, SizeIs(1)) << "what was not sent yet, and the same no more";
    channel.leave(SceneChannel::kChannel, client);
    EXPECT_THAT(feed.ears, IsEmpty());
    channel.tell(3, true, now += 1s);
    EXPECT_THAT(client.updates, SizeIs(1));
}

TEST(SceneChannel, DeletesAtARestoreWhatItHasDrawnAndDrawsAllAnew) {
    Said feed;
    Shown client;
    SceneChannel channel(feed, feed.channels);
    channel.listen(SceneChannel::kChannel, client, [](const auto&) {});
    auto now = Clock::now() + 1h;
    feed.say(topics::ship_state, ShipState{});
    channel.tell(500, false, now);
    channel.tell(120, true, now + 1ms);
    ASSERT_THAT(client.updates, SizeIs(2)) << "at once, and not when the tenth of a second is over";
    EXPECT_THAT(client.updates[0]["deletions"], IsEmpty());
    const json& anew = client.updates[1];
    EXPECT_EQ(anew["deletions"],
              json({{{"timestamp", {{"sec", 500}, {"nsec", 1000}}}, {"type", 1}, {"id", ""}}}))
        << "later than all that was drawn, which is what it deletes";
    ASSERT_THAT(anew["entities"], SizeIs(1));
    EXPECT_EQ(anew["entities"][0]["id"], client.updates[0]["entities"][0]["id"]);
    EXPECT_EQ(anew["entities"][0]["timestamp"]["sec"], 120);
    channel.tell(121, false, now + 1s);
    EXPECT_THAT(client.updates.at(2)["deletions"], IsEmpty()) << "once";
}

} // namespace
} // namespace windlass::gateway
