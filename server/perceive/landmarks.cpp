#include "server/perceive/landmarks.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/physics/base/units.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::perceive {
namespace {

using Json = nlohmann::json;

Json list(const Json& document, const char* name) {
    return document.value(name, Json::array());
}

/// Of x y or x y z.
Point3f point(const Json& from) {
    Point3f to;
    to.x(from[0]);
    to.y(from[1]);
    to.z(from.size() > 2 ? from[2].get<float>() : 0);
    return to;
}

template <class Enum>
Enum named(const auto& names, const std::string& name) {
    return static_cast<Enum>(std::ranges::find(names, name) - names.begin());
}

Coast coast(const Json& from) {
    Coast to;
    to.colour(
        static_cast<std::uint32_t>(std::stoul(from["colour"].get<std::string>().substr(1), nullptr, 16)));
    for (const Json& each : from["shore"])
        to.shore().push_back(point(each));
    for (const Json& each : from["ridge"])
        to.ridge().push_back(point(each));
    return to;
}

Landmark landmark(const Json& from) {
    Landmark to;
    to.name(from["name"].get<std::string>());
    to.kind(named<LandmarkKind>(words::kLandmarkNames, from["kind"]));
    to.x(from["x"]);
    to.y(from["y"]);
    to.height(from["height"]);
    to.light(named<LightColour>(words::kLightNames, from.value("light", "none")));
    to.period(from.value("period", 0.0F));
    for (const Json& each : list(from, "flashes")) {
        Flash& flash = to.flashes().emplace_back();
        flash.begin(each[0]);
        flash.duration(each[1]);
    }
    for (const Json& each : list(from, "sectors")) {
        LightSector& sector = to.sectors().emplace_back();
        sector.light(named<LightColour>(words::kLightNames, each["light"]));
        sector.from(static_cast<float>(physics::radians_from_degrees(each["from_deg"])));
        sector.to(static_cast<float>(physics::radians_from_degrees(each["to_deg"])));
    }
    return to;
}

AnchoredShip ship(const Json& from) {
    AnchoredShip to;
    to.x(from["x"]);
    to.y(from["y"]);
    to.heading(static_cast<float>(physics::radians_from_degrees(from["heading_deg"])));
    to.length(from["length"]);
    to.beam(from["beam"]);
    return to;
}

std::uint32_t number_of(const std::vector<Landmark>& marks, const std::string& name) {
    const auto found =
        std::ranges::find_if(marks, [&](const Landmark& mark) { return name == mark.name().c_str(); });
    return static_cast<std::uint32_t>(found - marks.begin());
}

} // namespace

void describe_landmarks(const exercise::ExerciseDef& def, Landmarks& to) {
    to = {};
    to.definition_hash(exercise::definition_hash(def));
    if (def.landmarks.empty()) return;
    const Json from = Json::parse(def.landmarks);
    to.has_position(from.contains("position"));
    if (to.has_position()) {
        to.latitude_deg(from["position"]["latitude_deg"]);
        to.longitude_deg(from["position"]["longitude_deg"]);
    }
    to.region_b(from.value("iala_region", "A") == "B");
    for (const Json& each : list(from, "coasts"))
        to.coasts().push_back(coast(each));
    for (const Json& each : list(from, "lamps"))
        to.lamps().push_back(point(each));
    for (const Json& each : list(from, "marks"))
        to.marks().push_back(landmark(each));
    for (const Json& each : list(from, "transits")) {
        Transit& transit = to.transits().emplace_back();
        transit.name(each["name"].get<std::string>());
        transit.front(number_of(to.marks(), each["front"]));
        transit.rear(number_of(to.marks(), each["rear"]));
    }
    for (const Json& each : list(from, "ships"))
        to.ships().push_back(ship(each));
}

} // namespace windlass::perceive
