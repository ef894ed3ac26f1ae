#include "server/config/config_json.hpp"

#include "server/config/config_faults.hpp"
#include "server/config/config_ground.hpp"
#include "server/config/field_json.hpp"
#include "server/exercise/definition/def_fields.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::config {
namespace {

using Json = nlohmann::json;

template <class Def>
void read(const Json& parent, const char* name, Def& def) {
    if (!parent.contains(name)) return;
    FieldReader reader(parent.at(name));
    exercise::visit_fields(reader, def);
}

/// By value: visit_fields serves readers too and so wants a def that may be written.
template <class Def>
Json written(Def def) {
    Json object = Json::object();
    FieldWriter writer(object);
    exercise::visit_fields(writer, def);
    return object;
}

/// A list of objects; one that the file does not give stays.
template <class Def>
void read_list(const Json& parent, const char* name, std::vector<Def>& list) {
    if (!parent.contains(name)) return;
    list.clear();
    for (const Json& entry : parent.at(name)) {
        FieldReader reader(entry);
        exercise::visit_fields(reader, list.emplace_back());
    }
}

template <class Def>
Json written_list(const std::vector<Def>& list) {
    Json array = Json::array();
    for (const Def& def : list)
        array.push_back(written(def));
    return array;
}

/// Diameter and grade first, then the fields that are given on their own.
physics::ChainDef read_chain(const Json& tackle) {
    physics::ChainDef def;
    read(tackle, "chain", def);
    def = physics::stud_link_chain(def.diameter, def.grade, def.length);
    read(tackle, "chain", def); // its node_spacing
    return def;
}

/// Type and mass first: they say what the rest is that is not given on its own.
physics::AnchorDef read_anchor(const Json& tackle) {
    physics::AnchorDef def;
    if (!tackle.contains("anchor")) return def;
    read(tackle, "anchor", def);
    const bool weighed = tackle.at("anchor").contains("mass");
    def = physics::typical_anchor(def.type, weighed ? def.mass : 0);
    read(tackle, "anchor", def);
    return def;
}

void read_environment(const Json& document, physics::EnvironmentDef& def) {
    read(document, "environment", def);
    lay_bed(def, def.soil);
    if (!document.contains("environment")) return;
    const Json& environment = document.at("environment");
    read_ground(environment, def);
}

void read_weather(const Json& document, exercise::Weather& weather) {
    read(document, "environment", weather);
    if (document.contains("environment"))
        read_list(document.at("environment"), "current_profile", weather.current_profile);
}

/// What a tide says of the start is the weather's.
void read_tide(const Json& document, exercise::ExerciseDef& def) {
    if (document.contains("environment")) read_list(document.at("environment"), "tide", def.tide);
    if (def.tide.empty()) return;
    const exercise::Tide start = exercise::tide_at(def.tide, 0);
    def.weather.tide_height = start.height;
    def.weather.current_speed = start.stream.norm();
    def.weather.current_towards = std::atan2(start.stream.x(), start.stream.y());
}

Json environment_to_json(const exercise::ExerciseDef& def) {
    Json environment = written(def.environment);
    environment.update(written(def.weather));
    environment["current_profile"] = written_list(def.weather.current_profile);
    environment["tide"] = written_list(def.tide);
    environment["ground"] = ground_to_json(def.environment);
    return environment;
}

void read_seats(const Json& document, exercise::Seats& seats) {
    const Json::json_pointer fitted("/seats/forecastle/fitted"), aids("/seats/forecastle/aids");
    if (document.contains(fitted)) {
        NamesReader names(document.at(fitted));
        exercise::visit_fitted(names, seats);
    }
    if (document.contains(aids)) {
        NamesReader names(document.at(aids));
        exercise::visit_aids(names, seats);
    }
}

Json seats_to_json(exercise::Seats seats) {
    Json fitted = Json::array(), aids = Json::array();
    NamesWriter fitted_names(fitted), aid_names(aids);
    exercise::visit_fitted(fitted_names, seats);
    exercise::visit_aids(aid_names, seats);
    return {{"forecastle", {{"fitted", fitted}, {"aids", aids}}}};
}

} // namespace

Json to_json(const exercise::ExerciseDef& def) {
    Json document = written(def);
    document["model"] = written(def.model);
    document["environment"] = environment_to_json(def);
    document["seats"] = seats_to_json(def.seats);
    document["ship"] = written(def.ship);
    document["ship_start"] = written(def.ship_start);
    document["tackle"] = Json::array();
    for (const exercise::GroundTackleDef& tackle : def.tackle) {
        Json& entry = document["tackle"].emplace_back(written(tackle));
        entry["windlass"] = written(tackle.windlass);
        entry["chain"] = written(tackle.chain);
        entry["anchor"] = written(tackle.anchor);
        entry["condition"] = written_list(tackle.condition);
    }
    document["faults"] = faults_to_json(def.faults);
    if (!def.landmarks.empty()) document["landmarks"] = Json::parse(def.landmarks);
    if (!def.lesson.empty()) document["lesson"] = Json::parse(def.lesson);
    return document;
}

exercise::ExerciseDef exercise_from_json(const Json& document) {
    exercise::ExerciseDef def;
    FieldReader reader(document);
    exercise::visit_fields(reader, def);
    read(document, "model", def.model);
    read_environment(document, def.environment);
    read_weather(document, def.weather);
    read_tide(document, def);
    exercise::lay_weather(def.weather, def.environment);
    read_seats(document, def.seats);
    read(document, "ship", def.ship);
    read(document, "ship_start", def.ship_start);
    def.faults = faults_from_json(document);
    if (document.contains("landmarks")) def.landmarks = document.at("landmarks").dump();
    if (document.contains("lesson")) def.lesson = document.at("lesson").dump();
    if (!document.contains("tackle")) return def;
    def.tackle.clear();
    for (const Json& entry : document.at("tackle")) {
        exercise::GroundTackleDef& tackle = def.tackle.emplace_back();
        FieldReader tackle_reader(entry);
        exercise::visit_fields(tackle_reader, tackle);
        read(entry, "windlass", tackle.windlass);
        tackle.anchor = read_anchor(entry);
        tackle.chain = read_chain(entry);
        read_list(entry, "condition", tackle.condition);
    }
    return def;
}

} // namespace windlass::config
