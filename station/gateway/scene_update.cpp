#include "station/gateway/scene_update.hpp"

#include "idl/payload.hpp"
#include "station/gateway/exercise_clock.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::gateway {

using nlohmann::json;

namespace {

// ------------------------------------------------------------------ geometry

struct Point {
    double x = 0, y = 0, z = 0;
};
struct Turn {
    double w = 1, x = 0, y = 0, z = 0;
};

Turn operator*(const Turn& a, const Turn& b) {
    return {.w = a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            .x = a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            .y = a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            .z = a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// From there along the turned x axis.
Point along_x(const Point& from, const Turn& turn, double length) {
    return {.x = from.x + length * (1 - 2 * (turn.y * turn.y + turn.z * turn.z)),
            .y = from.y + length * 2 * (turn.x * turn.y + turn.w * turn.z),
            .z = from.z + length * 2 * (turn.x * turn.z - turn.w * turn.y)};
}

Point point(const Vec3& at) {
    return {at.x(), at.y(), at.z()};
}
Turn turn(const Quaternion& by) {
    return {.w = by.w(), .x = by.x(), .y = by.y(), .z = by.z()};
}

// ------------------------------------------------------------------ Foxglove's messages

/// m; digits that nobody sees are not sent.
json number(double value) {
    constexpr double kPerMetre = 1000;
    return std::round(value * kPerMetre) / kPerMetre;
}

json vector(double x, double y, double z) {
    return {{"x", number(x)}, {"y", number(y)}, {"z", number(z)}};
}

json pose(const Point& at, const Turn& by = {}) {
    return {{"position", vector(at.x, at.y, at.z)},
            {"orientation", {{"x", by.x}, {"y", by.y}, {"z", by.z}, {"w", by.w}}}};
}

json colour(double red, double green, double blue, double alpha = 1) {
    return {{"r", red}, {"g", green}, {"b", blue}, {"a", alpha}};
}

json stamp(std::uint64_t ns) {
    constexpr std::uint64_t kSecond = 1'000'000'000;
    return {{"sec", ns / kSecond}, {"nsec", ns % kSecond}};
}

/// primitives: by their kinds ("lines": [...]); of the others there are none.
json entity(const char* id, double time, const json& primitives) {
    json made{{"timestamp", stamp(nanoseconds(time))},
              {"frame_id", "world"},
              {"id", id},
              {"lifetime", stamp(0)}, // until it is replaced or deleted
              {"frame_locked", false},
              {"metadata", json::array()}};
    for (const char* kind :
         {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
        made[kind] = primitives.value(kind, json::array());
    return made;
}

json cube(const json& at, const json& size, const json& its_colour) {
    return {{"pose", at}, {"size", size}, {"color", its_colour}};
}

// ------------------------------------------------------------------ what is drawn

constexpr double kPlane = 1000; // m, side of the water and seabed that are drawn, about the ship
constexpr double kThin = 0.02;  // m

json water(const ShipState& ship) {
    return {{"cubes",
             {cube(pose({ship.position().x(), ship.position().y(), 0}), vector(kPlane, kPlane, kThin),
                   colour(0.2, 0.5, 0.8, 0.25))}}};
}

/// The sloping plane; a grid's hills and holes are not drawn.
json seabed(const SeabedDescription& bed, double tide, const ShipState& ship) {
    const double east = std::sin(bed.slope_towards()), north = std::cos(bed.slope_towards());
    const double x = ship.position().x(), y = ship.position().y();
    const double z = -(bed.depth() + tide) + std::tan(bed.slope()) * (east * x + north * y);
    const double half = bed.slope() / 2;
    const Turn rise{.w = std::cos(half), .x = std::sin(half) * north, .y = -std::sin(half) * east};
    return {{"cubes", {cube(pose({x, y, z}, rise), vector(kPlane, kPlane, kThin), colour(0.55, 0.45, 0.3))}}};
}

json hull(const SceneDescription& plan, const ShipState& ship) {
    json points = json::array();
    for (const Point3f& corner : plan.hull_corners())
        points.push_back(vector(corner.x(), corner.y(), corner.z()));
    return {{"triangles",
             {{{"pose", pose(point(ship.position()), turn(ship.attitude()))},
               {"points", std::move(points)},
               {"color", colour(0.5, 0.5, 0.55)},
               {"colors", json::array()},
               {"indices",
                std::vector<std::uint32_t>(plan.hull_triangles().begin(), plan.hull_triangles().end())}}}}};
}

/// In the colour of its side, as lights have them.
json side_colour(std::size_t side) {
    return side == SIDE_PORT ? colour(0.9, 0.2, 0.2) : colour(0.2, 0.8, 0.3);
}

json cable(const ChainState& chain, std::size_t side) {
    constexpr int kLineStrip = 0;
    constexpr double kPixels = 3; // a cable's own width is less than one from where the ship is seen whole
    if (chain.nodes().size() < 2) return json::object();
    json points = json::array();
    for (const Point3f& node : chain.nodes())
        points.push_back(vector(node.x(), node.y(), node.z()));
    return {{"lines",
             {{{"type", kLineStrip},
               {"pose", pose({})},
               {"thickness", kPixels},
               {"scale_invariant", true},
               {"points", std::move(points)},
               {"color", side_colour(side)},
               {"colors", json::array()},
               {"indices", json::array()}}}}};
}

/// Shank: an arrow from the shackle to the crown. Flukes: a slab from the crown on.
json anchor(const AnchorState& state, const SceneTackle& plan, std::size_t side) {
    const Turn attitude = turn(state.attitude()), aft{.w = 0, .z = 1};
    const double half = state.fluke_angle() / 2; // about y: positive towards -z
    const Turn flukes = attitude * Turn{.w = std::cos(half), .y = std::sin(half)};
    const double shank = plan.shank_length(), fluke = plan.fluke_length();
    const Point crown = along_x(point(state.shackle()), attitude, -shank);
    return {{"arrows",
             {{{"pose", pose(point(state.shackle()), attitude * aft)},
               {"shaft_length", number(0.75 * shank)},
               {"shaft_diameter", number(0.12 * shank)},
               {"head_length", number(0.25 * shank)},
               {"head_diameter", number(0.3 * shank)},
               {"color", side_colour(side)}}}},
            {"cubes",
             {cube(pose(along_x(crown, flukes, fluke / 2), flukes), vector(fluke, 0.8 * fluke, 0.15 * fluke),
                   side_colour(side))}}};
}

// ------------------------------------------------------------------ the schema

json of_type(const char* type) {
    return {{"type", type}};
}
json list(const json& items) {
    return {{"type", "array"}, {"items", items}};
}
json message(const char* title, const json& properties) {
    return {{"title", title}, {"type", "object"}, {"properties", properties}};
}
json choice(const char* title, const std::vector<std::string>& names) {
    json rows = json::array();
    for (const std::string& name : names)
        rows.push_back({{"title", name}, {"const", rows.size()}});
    return {{"title", title}, {"oneOf", std::move(rows)}};
}

json make_schema() {
    const json real = of_type("number"), text = of_type("string"), flag = of_type("boolean");
    const json whole{{"type", "integer"}, {"minimum", 0}};
    const json nsec{{"type", "integer"}, {"minimum", 0}, {"maximum", 999'999'999}};
    const json time = message("time", {{"sec", whole}, {"nsec", nsec}});
    const json duration = message("duration", {{"sec", of_type("integer")}, {"nsec", nsec}});
    const json xyz{{"x", real}, {"y", real}, {"z", real}};
    const json size = message("foxglove.Vector3", xyz), points = list(message("foxglove.Point3", xyz));
    const json rotation =
        message("foxglove.Quaternion", {{"x", real}, {"y", real}, {"z", real}, {"w", real}});
    const json at = message("foxglove.Pose", {{"position", size}, {"orientation", rotation}});
    const json paint = message("foxglove.Color", {{"r", real}, {"g", real}, {"b", real}, {"a", real}});
    const json round{{"pose", at}, {"size", size}, {"color", paint}};
    const json bytes{{"type", "string"}, {"contentEncoding", "base64"}};

    const json primitives{
        {"arrows", list(message("foxglove.ArrowPrimitive", {{"pose", at},
                                                            {"shaft_length", real},
                                                            {"shaft_diameter", real},
                                                            {"head_length", real},
                                                            {"head_diameter", real},
                                                            {"color", paint}}))},
        {"cubes", list(message("foxglove.CubePrimitive", round))},
        {"spheres", list(message("foxglove.SpherePrimitive", round))},
        {"cylinders",
         list(message(
             "foxglove.CylinderPrimitive",
             {{"pose", at}, {"size", size}, {"bottom_scale", real}, {"top_scale", real}, {"color", paint}}))},
        {"lines",
         list(message("foxglove.LinePrimitive",
                      {{"type", choice("foxglove.LineType", {"LINE_STRIP", "LINE_LOOP", "LINE_LIST"})},
                       {"pose", at},
                       {"thickness", real},
                       {"scale_invariant", flag},
                       {"points", points},
                       {"color", paint},
                       {"colors", list(paint)},
                       {"indices", list(whole)}}))},
        {"triangles", list(message("foxglove.TriangleListPrimitive", {{"pose", at},
                                                                      {"points", points},
                                                                      {"color", paint},
                                                                      {"colors", list(paint)},
                                                                      {"indices", list(whole)}}))},
        {"texts", list(message("foxglove.TextPrimitive", {{"pose", at},
                                                          {"billboard", flag},
                                                          {"font_size", real},
                                                          {"scale_invariant", flag},
                                                          {"color", paint},
                                                          {"text", text}}))},
        {"models", list(message("foxglove.ModelPrimitive", {{"pose", at},
                                                            {"scale", size},
                                                            {"color", paint},
                                                            {"override_color", flag},
                                                            {"url", text},
                                                            {"media_type", text},
                                                            {"data", bytes}}))}};
    json entity_fields{
        {"timestamp", time},
        {"frame_id", text},
        {"id", text},
        {"lifetime", duration},
        {"frame_locked", flag},
        {"metadata", list(message("foxglove.KeyValuePair", {{"key", text}, {"value", text}}))}};
    entity_fields.update(primitives);
    return message(
        "foxglove.SceneUpdate",
        {{"deletions",
          list(message("foxglove.SceneEntityDeletion",
                       {{"timestamp", time},
                        {"type", choice("foxglove.SceneEntityDeletionType", {"MATCHING_ID", "ALL"})},
                        {"id", text}}))},
         {"entities", list(message("foxglove.SceneEntity", entity_fields))}});
}

bool is(const wire::TopicInfo& topic, const wire::TopicInfo& other) {
    return std::string_view(topic.name) == other.name;
}

} // namespace

void SceneHeard::hear(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload) {
    const auto take = [&]<class T>(std::optional<T>& into) { into = wire::decode<T>(payload); };
    const auto take_side = [&]<class T>(std::array<std::optional<T>, 2>& into) {
        T sample = wire::decode<T>(payload);
        if (sample.side() == SIDE_PORT || sample.side() == SIDE_STARBOARD)
            into[static_cast<std::size_t>(sample.side())] = std::move(sample);
    };
    namespace topics = wire::topics;
    try {
        if (is(topic, topics::scene_description)) take(plan);
        if (is(topic, topics::seabed_description)) take(bed);
        if (is(topic, topics::sea_state)) take(sea);
        if (is(topic, topics::ship_state)) take(ship);
        if (is(topic, topics::chain_state)) take_side(chains);
        if (is(topic, topics::anchor_state)) take_side(anchors);
    } catch (const std::exception&) {
        return; // of a writer that is no server of ours
    }
}

const Topics& scene_topics() {
    namespace topics = wire::topics;
    static const Topics all{&topics::scene_description, &topics::seabed_description, &topics::sea_state,
                            &topics::ship_state,        &topics::chain_state,        &topics::anchor_state};
    return all;
}

std::string scene_update(const SceneHeard& heard, double time, std::optional<double> delete_until) {
    static constexpr std::array kCables{"port_cable", "starboard_cable"};
    static constexpr std::array kAnchors{"port_anchor", "starboard_anchor"};
    json entities = json::array(), deletions = json::array();
    if (delete_until) {
        constexpr int kAll = 1;
        deletions.push_back({{"timestamp", stamp(nanoseconds(*delete_until))}, {"type", kAll}, {"id", ""}});
    }
    const auto add = [&](const char* id, const json& primitives) {
        entities.push_back(entity(id, time, primitives));
    };
    if (heard.ship) {
        add("water", water(*heard.ship));
        if (heard.bed && heard.sea) add("seabed", seabed(*heard.bed, heard.sea->tide_height(), *heard.ship));
        if (heard.plan) add("ship", hull(*heard.plan, *heard.ship));
    }
    for (std::size_t side = 0; side < 2; ++side) {
        if (heard.chains[side]) add(kCables[side], cable(*heard.chains[side], side));
        if (!heard.anchors[side] || !heard.plan) continue;
        for (const SceneTackle& tackle : heard.plan->tackle())
            if (tackle.side() == static_cast<std::int32_t>(side))
                add(kAnchors[side], anchor(*heard.anchors[side], tackle, side));
    }
    return json{{"deletions", std::move(deletions)}, {"entities", std::move(entities)}}.dump();
}

const std::string& scene_schema() {
    static const std::string text = make_schema().dump();
    return text;
}

} // namespace windlass::gateway
